//! Formats, baselines, statistics, the list of rules.

use serde_json::Value;

use super::{Bench, THREE, lint};

#[test]
fn every_format_is_what_its_readers_take() {
    let bench = Bench::new();
    bench.file("three.8K", THREE);
    let report = |format: &str| bench.acrc(["lint", "three.8K", "--format", format]).expect(1).stdout;
    for (format, pointer, expected) in [
        ("json", "/diagnostics/0/code", "ACR103"),
        ("sarif", "/runs/0/results/0/ruleId", "ACR103"),
        ("sarif", "/runs/0/tool/driver/rules/0/shortDescription/text", "The size in a DIM stands without parentheses."),
        ("gitlab", "/0/check_name", "ACR103"),
    ] {
        let value: Value = serde_json::from_str(&report(format)).expect("JSON");
        assert_eq!(value.pointer(pointer).and_then(Value::as_str), Some(expected), "{format}");
    }
    let lines = report("jsonl");
    let lines: Vec<Value> = lines.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    assert_eq!(lines.len(), 3);
    assert!(report("github").starts_with("::notice title=ACR103 unused-label,file=three.8K,line=3"));
    for format in ["junit", "checkstyle"] {
        let xml = report(format);
        assert!(xml.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>") && xml.contains("ACR101"), "{xml}");
    }
}

#[test]
fn a_report_goes_into_a_file_whole() {
    let bench = Bench::new();
    bench.file("three.8K", THREE);
    let arguments = ["lint", "three.8K", "--format", "json", "--output-file", "out.json", "--color", "always"];
    let run = bench.acrc(arguments).expect(1);
    assert!(run.stdout.starts_with("1 error, 1 warning, 1 piece of advice in 1 file\n"), "{}", run.stdout);
    let value: Value = serde_json::from_slice(&bench.read("out.json")).expect("JSON");
    assert_eq!(value["summary"]["errors"], 1);
    bench.acrc(["lint", "three.8K", "--output-file", "three.8K"]).expect(2);
    assert_eq!(bench.read("three.8K"), THREE.as_bytes());
    let quiet = bench.acrc(["lint", "three.8K", "--format", "json", "-o", "out.json", "--quiet"]).expect(1);
    assert_eq!(quiet.stdout, "");
}

#[test]
fn a_baseline_hides_what_was_there() {
    let bench = Bench::new();
    bench.file("src/three.8K", THREE);
    let with = |more: &[&str]| bench.acrc(["lint", "src/three.8K", "--baseline", "base.json"].iter().chain(more));
    assert!(with(&[]).expect(2).stderr.contains("--write-baseline writes it"));
    assert_eq!(with(&["--write-baseline"]).expect(0).stdout, "base.json: 3 findings\n");
    let written = bench.read("base.json");
    let run = with(&[]).expect(0);
    assert!(run.stdout.contains("no problems in 1 file\n3 findings of base.json not shown\n"), "{}", run.stdout);
    assert_eq!(with(&["--format", "concise"]).expect(0).stderr, "3 findings of base.json not shown\n");

    // A rule that is not asked has nothing repaired.
    let run = with(&["--select", "ACR102"]).expect(0);
    assert!(!run.stdout.contains("repaired"), "{}", run.stdout);

    // Lines above come and go; a second jump of the same text is new, and what is repaired is told.
    bench.file("src/three.8K", THREE.replace("_A\n", "SET 32\n\nGOTO  Nowhere\n"));
    let run = with(&[]).expect(1);
    assert!(run.stdout.contains("1 error in 1 file\n2 findings of base.json not shown\n"), "{}", run.stdout);
    assert!(run.stdout.contains("1 finding of base.json is repaired: write it anew"), "{}", run.stdout);

    // From another folder the file is the same one, and writing again gives the same bytes.
    bench.file("src/three.8K", THREE);
    let elsewhere = std::process::Command::new(env!("CARGO_BIN_EXE_acrc"))
        .args(["lint", "three.8K", "--baseline", "../base.json"])
        .current_dir(bench.path("src"))
        .status();
    assert_eq!(elsewhere.expect("acrc starts").code(), Some(0));
    with(&["--write-baseline"]).expect(0);
    assert_eq!(bench.read("base.json"), written);

    std::fs::remove_file(bench.path("src/three.8K")).expect("a file of ours");
    bench.file("other.8K", "SET 32\n");
    let run = bench.acrc(["lint", "other.8K", "--baseline", "base.json"]).expect(0);
    assert!(run.stdout.contains("3 findings of base.json are repaired"), "{}", run.stdout);
    bench.file("base.json", "{}");
    assert!(bench.acrc(["lint", "other.8K", "--baseline", "base.json"]).expect(2).stderr.contains("base.json"));
    bench.acrc(["lint", "other.8K", "--baseline", "other.8K", "--write-baseline"]).expect(2);
}

#[test]
fn statistics_count_by_rule() {
    let bench = Bench::new();
    bench.file(
        "three.8K",
        THREE.replace("CLEAR : DIM LV10\n", "CLEAR : DIM LV10\nDIM SV20\nPRINT SV0\nGOTO Gone\nGOTO Gone\n"),
    );
    let run = bench.acrc(["lint", "three.8K", "--statistics"]).expect(1);
    let table = "3  ACR101  error    [ ]  undefined-label\n\
                 2  ACR007  warning  [*]  dim-without-parentheses\n\
                 1  ACR103  advice   [ ]  unused-label\n";
    assert!(run.stdout.starts_with(table), "{}", run.stdout);
    let run = bench.acrc(["lint", "three.8K", "--statistics", "--format", "json"]).expect(1);
    let rows: Value = serde_json::from_str(&run.stdout).expect("JSON");
    assert_eq!(
        rows[1],
        serde_json::json!({"code": "ACR007", "name": "dim-without-parentheses", "severity": "warning", "count": 2, "fixable": 2})
    );
    bench.acrc(["lint", "three.8K", "--statistics", "--format", "sarif"]).expect(2);
}

#[test]
fn the_rules_are_listed_as_the_project_has_them() {
    let bench = Bench::new();
    let list = |more: &[&str]| {
        let run = bench.acrc(["lint", "--rules", "--format", "json"].iter().chain(more)).expect(0);
        let rows: Vec<Value> = serde_json::from_str(&run.stdout).expect("JSON");
        move |code: &str| rows.iter().find(|row| row["code"] == code).cloned().expect("a row")
    };
    let rule = list(&[]);
    assert_eq!(
        (&rule("ACR101")["fix"], &rule("ACR007")["fix"], &rule("ACR102")["fix"]),
        (&"unsafe".into(), &"safe".into(), &Value::Null)
    );
    bench.file("acrc.toml", "[lint]\nignore = [\"ACR103\"]\n[lint.severity]\nACR101 = \"advice\"\n");
    bench.file("src/Prog0.8K", "");
    let rule = list(&["src"]);
    assert_eq!(rule("ACR103")["enabled"], false);
    assert_eq!(rule("ACR101")["severity"], "advice");
    let text = bench.acrc(["lint", "--rules", "--select", "ACR101"]).expect(0).stdout;
    let line = text.lines().find(|line| line.starts_with("ACR115")).expect("a row");
    assert!(
        line.contains(" off ") && line.ends_with("A BREAK stands outside of FOR .. NEXT and WHILE .. WEND"),
        "{line}"
    );
    assert!(text.lines().any(|line| line.starts_with("ACR001") && line.contains(" error ")), "{text}");
}

#[test]
fn help_shows_examples() {
    let help = Bench::new().acrc(["lint", "--help"]).expect(0).stdout;
    for expected in ["Examples:", "--baseline old.json --write-baseline", "Rules:", "Repairs:", "Report:"] {
        assert!(help.contains(expected), "{help}");
    }
    assert_eq!(lint(&Bench::new(), &["--statistics", "--diff"]), [""; 0]);
}

#[cfg(unix)]
#[test]
fn standard_output_by_its_name_keeps_what_was_written_before() {
    let bench = Bench::new();
    bench.file("three.8K", THREE);
    let log = std::fs::File::create(bench.path("log")).expect("a file of ours");
    let script = "echo before; \"$0\" lint three.8K -o /dev/stdout --format concise --fail-on never; echo after";
    let status = std::process::Command::new("sh")
        .args(["-c", script, env!("CARGO_BIN_EXE_acrc")])
        .current_dir(bench.path("."))
        .stdout(log)
        .status();
    assert!(status.expect("a shell").success());
    let log = String::from_utf8(bench.read("log")).expect("a report is text");
    assert!(log.starts_with("before\nthree.8K:") && log.ends_with("after\n"), "{log}");
}

#[test]
fn flags_that_would_be_ignored_are_refused() {
    let bench = Bench::new();
    bench.file("three.8K", THREE);
    for flags in [
        &["--diff", "--output-file", "x"][..],
        &["--diff", "--format", "sarif"],
        &["--diff", "--baseline", "b.json", "--write-baseline"],
        &["--rules", "--output-file", "x"],
        &["--statistics", "--baseline", "b.json", "--write-baseline"],
    ] {
        let run = bench.acrc(["lint", "three.8K"].iter().chain(flags)).expect(2);
        assert!(run.stderr.contains("cannot be used with"), "{}", run.stderr);
    }
}

#[test]
fn a_project_that_cannot_be_loaded_is_in_every_report() {
    let bench = Bench::new();
    bench.file("good/Prog0.8K", "PROGRAM\nGOTO Nowhere\nENDP\n");
    bench.file("bad/acrc.toml", "[project\n");
    for (format, expected) in [
        ("json", "\"errors\":[{\"file\":\"bad/acrc.toml\",\"message\":\"`bad/acrc.toml` is not a valid"),
        ("jsonl", "{\"code\":null,\"name\":\"not-checked\""),
        ("sarif", "\"executionSuccessful\":false,\"toolExecutionNotifications\":[{\"level\":\"error\""),
        ("github", "::error title=not-checked,file=bad/acrc.toml::"),
        ("gitlab", "\"check_name\":\"not-checked\""),
        ("junit", "<error message=\"`bad/acrc.toml` is not a valid"),
        ("checkstyle", "<file name=\"bad/acrc.toml\">"),
    ] {
        for (paths, found) in [(&["."][..], true), (&["bad"], false)] {
            let run = bench.acrc(["lint", "--format", format].iter().chain(paths)).expect(2);
            assert!(run.stdout.contains(expected), "{format}: {}", run.stdout);
            assert_eq!(run.stdout.contains("ACR101"), found, "{format}: {}", run.stdout);
            assert!(run.stderr.contains("error: `bad/acrc.toml`"), "{}", run.stderr);
        }
    }
    let output = bench.feed(&["lint", "-", "--stdin-filename", "bad/Prog0.8K", "--format", "sarif"], b"");
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stdout).contains("\"executionSuccessful\":false"));
}

#[test]
fn what_is_no_baseline_is_told_in_plain_words() {
    let bench = Bench::new();
    bench.file("Prog0.8K", THREE);
    for (text, expected) in [
        ("hello", "line 1, column 1 is not as --write-baseline writes it"),
        ("{\"version\":1}", "line 1, column 13 is not as --write-baseline writes it"),
        ("{\"version\":9,\"other\":[]}", "it has version 9, and this is for version 1"),
    ] {
        bench.file("base.json", text);
        let run = bench.acrc(["lint", "--baseline", "base.json"]).expect(2);
        assert_eq!(run.stderr, format!("error: cannot read the baseline base.json: {expected}\n"));
    }
}

#[cfg(unix)]
#[test]
fn a_file_name_cannot_reach_the_terminal() {
    let bench = Bench::new();
    bench.file("a\u{1b}[31m\n.8K", THREE);
    let run = bench.acrc(["lint", "--format", "concise"]).expect(1);
    assert!(!run.stdout.contains('\u{1b}') && run.stdout.lines().count() == 3, "{}", run.stdout);
    let run = bench.acrc(["lint", "gone\u{1b}[31m.8K"]).expect(2);
    assert_eq!(run.stderr, "error: `gone\u{fffd}[31m.8K` does not exist\n");
}
