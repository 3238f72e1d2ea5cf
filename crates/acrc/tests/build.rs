//! `acrc build` with listing and map, and `acrc list` on what was built.

mod common;

use common::{Bench, Run};

/// Setup code and a program with everything that a listing and a map show.
const MACHINE: &str = "\
' The setup
SYS
CLEAR
DIM PROG0(4096) : DIM P(101)
DIM PLC0(256) : DIM DEF(4)
#DEFINE Ready BIT24
#DEFINE Speed P100
PROG0
ATTACH MASTER0
ATTACH SLAVE0 AXIS0 \"X\"

' The program
PROGRAM : REM waits for a part
_Start
    VEL (Speed) : ACC 10000.5    ' fast
    IF (Ready) THEN X/10 : GOSUB Blink
    IF (P12288 > 0.123456789)
        PRINT \"at \"; P12288; \" now, master \"; BIT516
    ENDIF
' one line has a number
100 GOTO Start
_Blink
    SET 32 : DWL 0.5 : CLR 32
    RETURN
ENDP
PLC0
PROGRAM
LD 24
AND NOT BIT25
OUT 33
END
ENDP
";

fn bench() -> Bench {
    let bench = Bench::new();
    bench.file("machine.8K", MACHINE);
    bench
}

/// The files of the folder, in order.
fn files(bench: &Bench) -> Vec<String> {
    let entries = std::fs::read_dir(bench.folder.path()).expect("readable");
    let mut names: Vec<_> = entries.filter_map(|entry| entry.ok()?.file_name().into_string().ok()).collect();
    names.sort();
    names
}

impl Bench {
    /// Builds the machine and lists it with these arguments.
    fn list(&self, arguments: &str) -> Run {
        self.acrc(["build", "machine.8K", "-o", "machine.acrx"]).expect(0);
        self.acrc(["list", "machine.acrx"].into_iter().chain(arguments.split_whitespace()))
    }
}

#[test]
fn a_listing_shows_words_beside_their_source() {
    let run = bench().acrc(["build", "machine.8K", "--listing", "-"]).expect(0);
    insta::assert_snapshot!(run.stdout);
    assert!(run.stderr.contains("PROG0"), "the report goes to standard error: {}", run.stderr);
}

#[test]
fn a_map_shows_where_everything_is() {
    let run = bench().acrc(["build", "machine.8K", "--map", "-"]).expect(0);
    insta::assert_snapshot!(run.stdout);
}

#[test]
fn a_map_can_be_json() {
    let bench = bench();
    bench.acrc(["build", "machine.8K", "-o", "machine.acrx", "--map", "map.json"]).expect(0);
    let map: serde_json::Value = serde_json::from_slice(&bench.read("map.json")).expect("one JSON object");
    let image = bench.read("machine.acrx");
    assert_eq!(map["image_bytes"], image.len());
    let program = &map["units"][1];
    let (offset, words) = (&program["offset"], &program["words"]);
    let offset = usize::try_from(offset.as_u64().expect("a number")).expect("small");
    assert_eq!(image[offset - 8..offset - 4], (words.as_u64().expect("a number") as u32).to_le_bytes());
    let kinds = program["kinds"].as_object().expect("bytes by kind");
    let sum: u64 = kinds.values().filter_map(serde_json::Value::as_u64).sum();
    assert_eq!(program["bytes"], sum);
    insta::assert_json_snapshot!(program["lines"].as_array().expect("lines")[..2]);
    insta::assert_json_snapshot!(map["aliases"]);
}

#[test]
fn the_source_of_a_stripped_image_is_in_its_listing_all_the_same() {
    let bench = bench();
    bench.acrc(["build", "machine.8K", "-o", "full.acrx", "--listing", "full.lst", "--map", "full.map"]).expect(0);
    let outputs = ["-o", "bare.acrx", "--listing", "bare.lst", "--map", "bare.map"];
    bench.acrc(["build", "machine.8K", "--strip"].into_iter().chain(outputs)).expect(0);
    assert!(bench.read("bare.acrx").len() < bench.read("full.acrx").len());
    assert_eq!(bench.read("bare.lst"), bench.read("full.lst"));
    let lines =
        |name| String::from_utf8(bench.read(name)).expect("text").lines().skip(1).collect::<Vec<_>>().join("\n");
    assert_eq!(lines("bare.map"), lines("full.map"));
}

#[test]
fn all_outputs_are_written_or_none() {
    let bench = bench();
    let run = bench.acrc(["build", "machine.8K", "-o", "a.acrx", "--listing", "a.lst", "--map", "no/such/folder"]);
    assert!(run.expect(2).stderr.contains("no/such/folder"));
    assert_eq!(files(&bench), ["machine.8K"]);
    for arguments in [&["-o", "a", "--map", "a"][..], &["--listing", "-", "--map", "-"], &["--listing", "machine.8K"]] {
        bench.acrc(["build", "machine.8K"].into_iter().chain(arguments.iter().copied())).expect(2);
    }
    bench.acrc(["build", "machine.8K"]).expect(2);
    assert_eq!(bench.read("machine.8K"), MACHINE.as_bytes());
    assert_eq!(files(&bench), ["machine.8K"]);
}

#[test]
fn an_image_can_go_to_standard_output() {
    let bench = bench();
    bench.acrc(["build", "machine.8K", "-o", "machine.acrx"]).expect(0);
    let piped = bench.feed(&["build", "machine.8K", "-o", "-"], b"");
    assert_eq!(piped.stdout, bench.read("machine.acrx"));
}

#[test]
fn a_list_is_the_text_of_the_controller() {
    insta::assert_snapshot!(bench().list("").expect(0).stdout);
}

#[test]
fn a_list_can_show_numbers_and_names() {
    insta::assert_snapshot!(bench().list("--line-numbers --annotate --program PROG0").expect(0).stdout);
}

#[test]
fn an_annotated_list_compiles_to_the_same_program() {
    let bench = bench();
    for arguments in ["--program PROG0", "--program plc0"] {
        let (plain, annotated) =
            (bench.list(arguments).expect(0), bench.list(&format!("{arguments} --annotate")).expect(0));
        let program = |text: &str| {
            let setup = "SYS\nCLEAR\nDIM PROG0(4096)\nDIM PLC0(256)\nDIM P(101)\nDIM DEF(4)\n#DEFINE Ready BIT24\n#DEFINE Speed P100\nPROG0\nATTACH MASTER0\n\
                         ATTACH SLAVE0 AXIS0 \"X\"\n";
            let prompt = if arguments.contains("plc0") { "PLC0" } else { "PROG0" };
            bench.file("again.8K", format!("{setup}{prompt}\nPROGRAM\n{text}ENDP\n"));
            bench.acrc(["build", "again.8K", "-o", "again.acrx"]).expect(0);
            bench.acrc(["list", "again.acrx"]).expect(0).stdout
        };
        assert_ne!(plain.stdout, annotated.stdout);
        assert_eq!(program(&annotated.stdout), plain.stdout);
    }
}

#[test]
fn some_programs_can_be_listed_alone() {
    let bench = bench();
    assert!(bench.list("--program PLC0").expect(0).stdout.starts_with("' PLC0"));
    assert!(bench.list("--program PROG1").expect(2).stderr.contains("holds no PROG1"));
    assert!(bench.list("--program PLC8").expect(2).stderr.contains("PLC0 to PLC7"));
}

#[test]
fn a_text_that_is_replaced_says_so() {
    let bench = Bench::new();
    bench.file("machine.8K", "PROG0\nPROGRAM\nSET 32\nENDP\nRUN\n20 CLR 32\n");
    insta::assert_snapshot!(bench.list("").expect(0).stdout, @r"
    ' PROG0 - 8 bytes, replaced by a text below
    SET 32

    ' PROG0 - 24 bytes
    SET 32
    20 CLR 32
    ");
}

#[test]
fn a_protected_image_lists_with_its_password_only() {
    let bench = bench();
    let open = bench.list("").expect(0).stdout;
    bench.file("machine.8K", MACHINE.replacen("CLEAR\n", "CLEAR\nPASSWORD ON \"sesame\"\n", 1));
    let refused = bench.list("").expect(2);
    assert!(refused.stderr.contains("protected by PASSWORD"), "{}", refused.stderr);
    assert_eq!(refused.stdout, "");
    assert!(bench.list("--password Sesame").expect(2).stderr.contains("another password"));
    assert_eq!(bench.list("--password sesame").expect(0).stdout, open);
    bench.file("machine.8K", MACHINE.replacen("CLEAR\n", "CLEAR\nPASSWORD ON \"a\"\nPASSWORD OFF \"a\"\n", 1));
    assert_eq!(bench.list("").expect(0).stdout, open);
}

#[test]
fn every_way_an_image_can_be_wrong_has_its_reason() {
    let bench = bench();
    bench.list("").expect(0);
    let whole = bench.read("machine.acrx");
    let changed = |at: usize, value: u8| {
        let mut bytes = whole.clone();
        bytes[at] = value;
        bytes
    };
    for (bytes, reason) in [
        (whole[..whole.len() - 3].to_vec(), "truncated"),
        (changed(whole.len() / 2, whole[whole.len() / 2] ^ 0x40), "altered"),
        (changed(4, 9), "format version 9"),
        (changed(0, b'Z'), "not an acrc image"),
        ([whole.clone(), b"\r\n".to_vec()].concat(), "2 bytes follow the end"),
    ] {
        bench.file("wrong.acrx", bytes);
        let run = bench.acrc(["list", "wrong.acrx"]).expect(2);
        assert!(run.stderr.contains(reason), "{reason}: {}", run.stderr);
    }
}

/// A project with this text in program 0, and with every rule of the linter off.
fn quiet(program: &str) -> Bench {
    let bench = Bench::new();
    bench.file("quiet/acrc.toml", "[lint]\nignore = [\"ALL\"]\n");
    bench.file(
        "quiet/Setup.8K",
        format!("SYS\nCLEAR\nDIM PROG0(60)\nDIM P(9)\nDIM DEF(1)\n#DEFINE Speed P1\nPROG0\nPROGRAM\n{program}\nENDP\n"),
    );
    bench
}

#[test]
fn a_quiet_linter_lets_nothing_pass_that_a_controller_cannot_load() {
    let setup = if cfg!(windows) { "quiet\\Setup.8K" } else { "quiet/Setup.8K" };
    for (program, problem) in [
        ("WHILE (P0 < 3)", format!("error: {setup}:9: WHILE without WEND")),
        ("SET 32\nWEND", format!("error: {setup}:10: WEND without WHILE")),
        (
            "FOR P0 = 1 TO 3\nIF (P0 = 1)\nNEXT\nENDIF",
            format!("error: {setup}:11: NEXT closes a IF block that stands inside it"),
        ),
        (
            "PRINT \"a text of this many characters is more than sixty bytes\"",
            "error: PROG0: its text needs 63 bytes, and DIM PROG0 gives 60".to_owned(),
        ),
    ] {
        let bench = quiet(program);
        let run = bench.acrc(["build", "quiet", "-o", "quiet.acrx"]).expect(1);
        assert_eq!(run.stderr, format!("{problem}\n{setup} is not built: a controller cannot load it\n"));
        assert_eq!(files(&bench), ["quiet"]);
    }
    let run = quiet("GOTO Nowhere").acrc(["build", "quiet", "-o", "quiet.acrx"]).expect(1);
    assert!(run.stderr.contains("the label `Nowhere` is not defined in this program"), "{}", run.stderr);
}

#[test]
fn what_the_project_accepts_of_the_linter_is_built() {
    let bench = quiet("SET 70000");
    bench.acrc(["build", "quiet", "-o", "quiet.acrx"]).expect(0);
    bench.file("quiet/acrc.toml", "");
    let run = bench.acrc(["build", "quiet", "-o", "quiet.acrx"]).expect(1);
    assert!(run.stderr.contains("70000"), "{}", run.stderr);
}

#[test]
fn an_alias_that_is_a_word_of_the_language_is_an_error_for_everybody() {
    let bench = Bench::new();
    for program in ["P0 = Clock", "P0 = 1"] {
        bench
            .file("a.8K", format!("SYS\nDIM DEF(1)\nDIM P(1)\n#DEFINE Clock P6916\nPROG0\nPROGRAM\n{program}\nENDP\n"));
        for arguments in [&["lint", "a.8K"][..], &["build", "a.8K", "-o", "a.acrx"]] {
            let run = bench.acrc(arguments.iter().copied()).expect(1);
            let told = run.stdout + &run.stderr;
            assert!(told.contains("error[ACR212]: the alias `Clock` is a word of the language"), "{told}");
            assert!(told.contains("1 error"), "{told}");
        }
    }
    // Where nobody speaks of the name, its uses are errors.
    bench.file("b/Prog0.8K", "SYS\nDIM DEF(1)\nDIM P(1)\n#DEFINE Clock P6916\nPROG0\nPROGRAM\nP0 = Clock\nENDP\n");
    for config in ["ignore = [\"ACR212\"]", "severity = { ACR212 = \"warning\" }"] {
        bench.file("b/acrc.toml", format!("[lint]\nfail-on = \"error\"\n{config}\n"));
        bench.acrc(["lint", "b"]).expect(1);
        bench.acrc(["build", "b", "-o", "a.acrx"]).expect(1);
    }
}
