//! The guide's own listings: every mistake that a tool must see is found, and nothing else is complained about.
//!
//! The listings are read in place (`../shared/corpus` beside the workspace, or `ACRC_CORPUS`); without them the test
//! says so and passes.

use std::fs;
use std::path::{Path, PathBuf};

use acrc_analysis::project::Config;
use acrc_analysis::{Database, FileRole, Project, SourceFile};
use acrc_diagnostics::{Diagnostic, LineIndex, Severity};
use serde::Deserialize;

#[derive(Deserialize)]
struct Listing {
    #[serde(default)]
    context: Vec<String>,
    context_file: Option<String>,
    expect: Option<Expect>,
    #[serde(default)]
    raw_lines: Vec<u32>,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Expect {
    /// `expect = "clean"`
    Clean(#[expect(dead_code, reason = "there is one word")] String),
    Findings(Vec<Finding>),
}

#[derive(Deserialize)]
struct Finding {
    line: u32,
    detect: String,
}

fn corpus() -> Option<PathBuf> {
    let path = std::env::var_os("ACRC_CORPUS")
        .map_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/corpus"), PathBuf::from);
    let guide = path.join("guide");
    if guide.is_dir() {
        return Some(guide);
    }
    eprintln!("the listings of the guide are not there ({}): nothing is checked", guide.display());
    None
}

fn lint(text: &str) -> Vec<Diagnostic> {
    let db = Database::new();
    let name = "listing.8K";
    let file = SourceFile::new(&db, name.to_owned(), text.to_owned(), FileRole::of(name), Vec::new());
    let project = Project::new(&db, vec![file], acrc_catalog::default_model(), Config::default());
    acrc_lint::check(&db, project).into_iter().flat_map(|(_, found)| found).collect()
}

/// The findings in a listing behind its context, with lines of the listing; line 0 is the context.
fn lint_listing(context: &str, listing: &str) -> Vec<(u32, Diagnostic)> {
    let text = format!("{context}{listing}");
    let index = LineIndex::new(&text);
    let before = context.lines().count() as u32;
    lint(&text).into_iter().map(|found| (index.position(found.span.start).line.saturating_sub(before), found)).collect()
}

/// What stands before the listing: the statements of its context, or the fuller setup and the switch of the level.
fn contexts(guide: &Path, listing: &Listing) -> Vec<String> {
    let lines = |lines: &[String]| lines.iter().map(|line| line.clone() + "\n").collect::<String>();
    let mut contexts = vec![lines(&listing.context)];
    if let Some(setup) = &listing.context_file {
        let setup = fs::read_to_string(guide.join(setup)).expect("the setup that a listing names");
        let level: Vec<_> = listing.context.first().cloned().into_iter().collect();
        contexts.push(format!("{}\n{}", setup.trim_end(), lines(&level)));
    }
    contexts
}

/// Compares findings with expectations; returns complaints.
fn compare(listing: &Listing, found: &[(u32, Diagnostic)], typographic: &[u32]) -> Vec<String> {
    let expected: &[Finding] = match &listing.expect {
        Some(Expect::Findings(findings)) => findings,
        _ => &[],
    };
    let mut complaints = Vec::new();
    for wanted in expected.iter().filter(|wanted| wanted.detect == "must") {
        if !found.iter().any(|(line, _)| *line == wanted.line) {
            complaints.push(format!("line {}: not found", wanted.line));
        }
    }
    for (line, diagnostic) in found {
        let allowed = expected.iter().any(|e| e.line == *line && e.detect != "reader") || typographic.contains(line);
        if diagnostic.severity > Severity::Advice && !allowed {
            complaints.push(format!("line {line}: {} {}", diagnostic.code, diagnostic.message));
        }
    }
    complaints
}

#[test]
fn the_listings_of_the_guide() {
    let Some(guide) = corpus() else { return };
    let mut names: Vec<PathBuf> = fs::read_dir(&guide)
        .expect("a directory")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
        .collect();
    names.sort();
    let mut complaints = Vec::new();
    for path in &names {
        let listing: Listing =
            toml::from_str(&fs::read_to_string(path).expect("a description")).expect("a description");
        let raw = path.with_extension("raw.8K");
        for context in contexts(&guide, &listing) {
            let name = path.file_stem().unwrap_or_default().to_string_lossy();
            let text = fs::read_to_string(path.with_extension("8K")).expect("a listing");
            let found = lint_listing(&context, &text);
            complaints.extend(compare(&listing, &found, &[]).iter().map(|complaint| format!("{name}: {complaint}")));
            if let Ok(text) = fs::read_to_string(&raw) {
                let found = lint_listing(&context, &text);
                let complained = compare(&listing, &found, &listing.raw_lines);
                complaints.extend(complained.iter().map(|complaint| format!("{name} (raw): {complaint}")));
            }
        }
    }
    assert!(names.len() > 70, "only {} listings", names.len());
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
}

#[test]
fn refused_forms_are_refused() {
    for statement in [r#"ATTACH SLAVE0 AXIS0 "P""#, r#"ATTACH SLAVE0 AXIS0 "F""#, "FLASH"] {
        let found = lint(&format!("PROG0\n{statement}\n"));
        assert!(found.iter().any(|diagnostic| diagnostic.severity == Severity::Error), "{statement}: {found:?}");
    }
}
