//! Which projects and files are checked.

use super::{Bench, THREE, lint};

const JUMP: &str = "PROGRAM\nGOTO Nowhere\nENDP\n";

#[test]
fn a_folder_stands_for_the_projects_below_it() {
    let bench = Bench::new();
    bench.file("a/acrc.toml", "");
    bench.file("a/src/Prog0.8K", JUMP);
    bench.file("a/old/Prog0.8K", JUMP);
    bench.file("a/tool/acrc.toml", "");
    bench.file("a/tool/Prog3.8K", JUMP);
    bench.file("b/Setup.8K", "#DEFINE Lamp BIT32\n");
    bench.file("b/Prog1.8K", "PROGRAM\nSET Lamp\nGOTO Nowhere\nENDP\n");
    bench.file("c/deep/lone.8K", THREE);
    bench.file("c/notes.txt", JUMP);
    bench.file("built/Prog0.8K", JUMP);
    bench.file(".gitignore", "/built\n*.tmp.8K\n");
    bench.file("c/x.tmp.8K", THREE);
    let all = [
        "a/src/Prog0.8K:2 ACR101",
        "a/tool/Prog3.8K:2 ACR101",
        "b/Prog1.8K:3 ACR101",
        "c/deep/lone.8K:3 ACR103",
        "c/deep/lone.8K:4 ACR101",
        "c/deep/lone.8K:5 ACR007",
    ];
    assert_eq!(lint(&bench, &[]), all);
    assert_eq!(lint(&bench, &["."]), all);
    assert_eq!(lint(&bench, &["a", "./a/", "a/acrc.toml"]), all[..2], "a project is checked once");
    assert_eq!(lint(&bench, &["built"]), ["built/Prog0.8K:2 ACR101"], "what is named is checked in any case");
    assert_eq!(lint(&bench, &["c/x.tmp.8K"]).len(), 3);
}

#[test]
fn a_project_that_cannot_be_loaded_does_not_hide_the_others() {
    let bench = Bench::new();
    bench.file("a/Prog0.8K", JUMP);
    bench.file("b/acrc.toml", "[project\n");
    bench.file("c/Prog0.8K", JUMP);
    bench.file("d/Prog0.8K", [0_u8, 1]);
    for paths in [&["."][..], &["a", "b", "c", "d"]] {
        let run = bench.acrc(["lint", "--format", "concise"].iter().chain(paths)).expect(2);
        assert_eq!(super::codes(&run), ["a/Prog0.8K:2 ACR101", "c/Prog0.8K:2 ACR101"]);
        let errors: Vec<&str> = run.stderr.lines().filter(|line| line.starts_with("error: ")).collect();
        assert_eq!(errors.len(), 2, "{}", run.stderr);
        assert!(errors[0].contains("b/acrc.toml") && errors[1].contains("d/Prog0.8K"), "{}", run.stderr);
    }
}

#[test]
fn a_file_is_checked_with_its_project() {
    let bench = Bench::new();
    bench.file("acrc.toml", "[project]\nfiles = [\"Setup.8K\", \"src/Prog0.8K\", \"src/Prog1.8K\"]\n");
    bench.file("Setup.8K", "#DEFINE Lamp BIT32\nGOTO Away\n");
    bench.file("src/Prog0.8K", "PROGRAM\nSET Lamp\nGOTO Nowhere\nENDP\n");
    bench.file("src/Prog1.8K", JUMP);
    bench.file("src/Prog2.8K", "PROGRAM\nSET Lamp\nENDP\n");
    assert_eq!(lint(&bench, &["src/Prog0.8K"]), ["src/Prog0.8K:3 ACR101"]);
    let both = ["src/Prog0.8K:3 ACR101", "src/Prog1.8K:2 ACR101"];
    assert_eq!(lint(&bench, &["src/Prog1.8K", "src/Prog0.8K"]), both);
    assert_eq!(lint(&bench, &["src/Prog2.8K"]), ["src/Prog2.8K:2 ACR210"], "it is not listed and stands alone");
    let inside = std::process::Command::new(env!("CARGO_BIN_EXE_acrc"))
        .args(["lint", "--format", "concise", "Prog0.8K"])
        .current_dir(bench.path("src"))
        .output();
    let inside = String::from_utf8(inside.expect("acrc starts").stdout).expect("UTF-8");
    assert!(inside.starts_with("Prog0.8K:3:6: error[ACR101]"), "{inside}");
}

#[test]
fn standard_input_takes_the_place_of_a_file() {
    let bench = Bench::new();
    bench.file("acrc.toml", "[lint]\nignore = [\"ACR103\"]\n");
    bench.file("Setup.8K", "#DEFINE Lamp BIT32\nGOTO Away\n");
    bench.file("src/Prog0.8K", "what is on disk does not count");
    let text = b"PROGRAM\n_A\nSET Lamp\nGOTO Nowhere\nENDP\n";
    for name in ["src/Prog0.8K", "src/Prog5.8K"] {
        let output = bench.feed(&["lint", "-", "--stdin-filename", name, "--format", "concise"], text);
        let report = String::from_utf8(output.stdout).expect("UTF-8");
        let program = if name.contains('0') { 0 } else { 5 };
        if program == 0 {
            assert_eq!(report, format!("{name}:4:6: error[ACR101] program {program} has no label `Nowhere`\n"));
        } else {
            assert!(report.starts_with(&format!("{name}:4:6: error[ACR101] program {program} has")), "{report}");
        }
    }
    let output = bench.feed(&["lint", "-", "--format", "concise"], b"PROG0\nPROGRAM\n_A\nENDP\n");
    assert_eq!(
        String::from_utf8_lossy(&output.stdout),
        "<stdin>:3:2: advice[ACR103] nothing in program 0 jumps to the label `A`\n"
    );
    let empty = Bench::new();
    for name in ["Prog0.8K", "new/Prog0.8K", "new/deep/Prog0.8K", "new/lone.8K"] {
        let output = empty
            .feed(&["lint", "-", "--stdin-filename", name, "--format", "concise"], b"PROGRAM\nGOTO Nowhere\nENDP\n");
        let report = String::from_utf8(output.stdout).expect("UTF-8");
        assert!(report.starts_with(&format!("{name}:2:6: error[ACR101]")), "{name}: {report}");
        assert_eq!(empty.feed(&["fmt", "-", "--stdin-filename", name], b"END\n").stdout, b"END\n", "{name}");
    }
    for arguments in [&["lint", "-", "."][..], &["lint", "--stdin-filename", "x.8K"], &["lint", "-", "--watch"]] {
        assert_eq!(bench.feed(arguments, b"").status.code(), Some(2), "{arguments:?}");
    }
}

#[test]
fn programs_that_belong_to_no_project_are_told() {
    let bench = Bench::new();
    bench.file("p/acrc.toml", "[project]\nfiles = [\"Prog0.8K\"]\n");
    bench.file("p/Prog0.8K", "PROGRAM\nEND\nENDP\n");
    bench.file("p/Prog1.8K", JUMP);
    bench.file("p/old/Prog2.8K", JUMP);
    bench.file("p/own/acrc.toml", "");
    bench.file("p/own/Prog3.8K", "PROGRAM\nEND\nENDP\n");
    let two = "note: 2 programs below `p/acrc.toml` are no part of a project and are passed over, p/Prog1.8K first: list them in \
               `files`, name them, or `exclude` them\n";
    for path in ["p", "."] {
        assert_eq!(bench.acrc(["lint", path]).expect(0).stderr, two);
        assert_eq!(bench.acrc(["fmt", path, "--check"]).expect(0).stderr, two);
        assert_eq!(bench.acrc(["lint", path, "--quiet"]).expect(0).stderr, "");
    }
    assert_eq!(bench.acrc(["lint", "p", "./p/"]).expect(0).stderr, two, "each is counted once");
    bench.file("p/acrc.toml", "[project]\nfiles = [\"Prog0.8K\"]\n[lint]\nexclude = [\"old\"]\n");
    let one = two.replace("2 programs", "1 program").replace("are no part", "is no part");
    let one = one.replace("are passed over", "is passed over").replace("them", "it").replace(" first:", ":");
    assert_eq!(bench.acrc(["lint", "p"]).expect(0).stderr, one, "a pattern of what is passed over is not idle");
    assert_eq!(bench.acrc(["lint", "p/acrc.toml"]).expect(0).stderr.lines().count(), 1);
}
