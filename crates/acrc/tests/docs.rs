//! What the documents show is what the program takes.

mod common;

use std::collections::BTreeSet;
use std::path::Path;

use common::Bench;

fn document(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(name);
    std::fs::read_to_string(path).expect("a document")
}

/// The blocks of code in one language.
fn blocks(text: &str, language: &str) -> Vec<String> {
    let fence = format!("```{language}\n");
    text.split(&fence).skip(1).filter_map(|rest| rest.split("```").next()).map(str::to_owned).collect()
}

/// The keys of the tables.
fn keys(section: &str) -> BTreeSet<&str> {
    let rows = section.lines().filter_map(|line| line.strip_prefix("| `"));
    rows.filter_map(|row| row.split('`').next()).collect()
}

#[test]
fn every_example_of_the_configuration_is_taken() {
    let text = document("docs/configuration.md");
    let examples = blocks(&text, "toml");
    assert_eq!(examples.len(), 4);
    for example in examples {
        let bench = Bench::new();
        bench.file("acrc.toml", &example);
        for name in ["src/Setup.8K", "src/Prog0.8K", "src/Prog1.8K"] {
            bench.file(name, "");
        }
        bench.acrc(["lint"]).expect(0);
    }
}

#[test]
fn every_key_has_an_example() {
    let text = document("docs/configuration.md");
    let sections: Vec<&str> = text.split("\n## [").skip(1).collect();
    assert_eq!(sections.len(), 4);
    for section in sections {
        let example = blocks(section, "toml").concat();
        assert!(!keys(section).is_empty());
        for key in keys(section) {
            assert!(example.contains(key), "`{key}` is not in the example of [{section}");
        }
    }
}

#[test]
fn the_comments_of_the_configuration_suppress() {
    let text = document("docs/configuration.md");
    let bench = Bench::new();
    bench.file("t.8K", blocks(&text, "basic").concat());
    let run = bench.acrc(["lint", "t.8K", "--format", "concise"]);
    assert!(!run.stdout.contains("ACR902") && !run.stdout.contains("ACR101"), "{}", run.stdout);
}

#[test]
fn hooks_and_pages_call_what_there_is() {
    let mut commands = BTreeSet::new();
    for name in ["docs/ci.md", "docs/configuration.md", "examples/ci/github.yml", ".pre-commit-hooks.yaml", "README.md"]
    {
        for line in document(name).lines() {
            let line = line.trim().trim_start_matches("- run: ").trim_start_matches("run: ");
            let line = line.trim_start_matches("entry: ").trim_start_matches("- ").trim_start_matches("sh '");
            if line.starts_with("acrc lint") || line.starts_with("acrc fmt") {
                commands.insert(line.trim_end_matches('\'').split("  ").next().unwrap_or_default().to_owned());
            }
        }
    }
    assert!(commands.len() >= 8, "{commands:?}");
    for command in commands {
        let words: Vec<&str> = command.split_whitespace().skip(1).collect();
        let run = Bench::new().acrc(words.iter().copied().chain(["--help"]));
        assert_eq!(run.status, Some(0), "{command}: {}", run.stderr);
        let bench = Bench::new();
        bench.file("Prog0.8K", "");
        bench.file("machine.8K", "");
        let run = bench.acrc(words);
        assert!(!run.stderr.contains("Usage:"), "{command}: {}", run.stderr);
    }
}

#[test]
fn the_page_about_building_shows_what_is_written() {
    let text = document("docs/build.md");
    let bench = Bench::new();
    bench.file("press.8K", blocks(&text, "basic").concat());
    let outputs = ["-o", "press.acrx", "--listing", "press.lst", "--map", "press.map"];
    bench.acrc(["build", "press.8K"].into_iter().chain(outputs)).expect(0);
    let written = |name| String::from_utf8(bench.read(name)).expect("text");
    for (block, shown) in [
        ("listing", written("press.lst")),
        ("map", written("press.map")),
        ("list", bench.acrc(["list", "press.acrx", "--annotate"]).expect(0).stdout),
    ] {
        assert_eq!(blocks(&text, block).concat(), shown, "docs/build.md shows another {block}");
    }
}

#[test]
fn every_command_on_the_memories_is_described() {
    let text = document("docs/nonvolatile.md");
    let described = keys(&text);
    let commands = acrc_catalog::all_commands().filter(|command| command.group == "Non-Volatile");
    let elsewhere = |name: &str| name.starts_with("FIRMWARE") || ["FLASH", "PBOOT"].contains(&name);
    for command in commands.filter(|command| !elsewhere(command.name)) {
        assert!(described.contains(command.name), "{}", command.name);
    }
}
