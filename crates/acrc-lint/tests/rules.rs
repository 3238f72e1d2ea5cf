//! Every page of a rule: its bad example is flagged by the rule, its good example is not, and both read well.

use acrc_analysis::project::{Config, LoadedFile, LoadedProject};
use acrc_analysis::{Database, FileRole, Project, SourceFile};
use acrc_diagnostics::{Diagnostic, FileReport, Severity, text};
use acrc_lint::{Group, RuleDoc};
use acrc_syntax::SourceText;

const NAME: &str = "example.8K";

/// Pages whose examples describe a file instead of showing one, or need a project that names its model.
const DESCRIBED: [&str; 5] = ["ACR004", "ACR025", "ACR027", "ACR031", "ACR310"];

/// The findings of all rules that are on by themselves, and of `also`.
fn lint_with(also: Option<&RuleDoc>, program: &str) -> Vec<Diagnostic> {
    let mut config = Config::default();
    let on = acrc_lint::rules().filter(|doc| doc.enabled || also == Some(doc));
    config.lint.select = Some(on.map(|doc| doc.code.id.to_owned()).collect());
    lint_configured(config, program)
}

fn lint_configured(config: Config, program: &str) -> Vec<Diagnostic> {
    let db = Database::new();
    let file = SourceFile::new(&db, NAME.to_owned(), program.to_owned(), FileRole::of(NAME), Vec::new());
    let project = Project::new(&db, vec![file], acrc_catalog::default_model(), config);
    acrc_lint::check(&db, project).into_iter().flat_map(|(_, found)| found).collect()
}

fn lint(program: &str) -> Vec<Diagnostic> {
    lint_with(None, program)
}

fn compile(program: &str) -> Vec<Diagnostic> {
    let project = LoadedProject {
        name: "example".to_owned(),
        model: acrc_catalog::default_model(),
        root: camino::Utf8PathBuf::new(),
        config: Config::default(),
        files: vec![LoadedFile {
            path: NAME.into(),
            role: FileRole::of(NAME),
            source: SourceText::decode(program.as_bytes()).expect("examples are text"),
        }],
    };
    project.compile().err().unwrap_or_default().iter().map(Diagnostic::from).collect()
}

fn look(doc: &RuleDoc, program: &str) -> Vec<Diagnostic> {
    if doc.group == Group::Compile { compile(program) } else { lint_with(Some(doc), program) }
}

fn shown() -> impl Iterator<Item = &'static RuleDoc> {
    acrc_lint::rules().filter(|doc| !DESCRIBED.contains(&doc.code.id))
}

fn render(program: &str, found: &[Diagnostic]) -> String {
    let report = FileReport::new(acrc_diagnostics::SourceFile::new(NAME, program), found);
    let mut out = Vec::new();
    text::render(&[report], text::Options::default(), &mut out).expect("writing to memory works");
    String::from_utf8(out).expect("the renderer writes text")
}

#[test]
fn bad_examples_are_flagged_as_their_page_says() {
    for doc in shown() {
        let found = look(doc, doc.bad);
        let own = found.iter().find(|diagnostic| diagnostic.code == doc.code);
        let own = own.unwrap_or_else(|| panic!("{} does not flag its bad example: {found:#?}", doc.code.id));
        assert_eq!(own.severity, doc.severity, "{}", doc.code.id);
    }
}

#[test]
fn good_examples_have_no_errors_and_warnings() {
    for doc in shown() {
        let found = look(doc, doc.good);
        assert!(found.iter().all(|diagnostic| diagnostic.code != doc.code), "{}: {found:#?}", doc.code.id);
        assert!(found.iter().all(|diagnostic| diagnostic.severity == Severity::Advice), "{}: {found:#?}", doc.code.id);
    }
}

/// Plans leave out the checks of rules that are off, so a check must not report for another rule.
#[test]
fn a_rule_finds_alone_what_it_finds_among_all() {
    for example in acrc_lint::rules().filter(|doc| doc.group != Group::Compile) {
        let config = |select: &str| {
            let mut config = Config::default();
            config.lint.select = Some(vec![select.to_owned()]);
            config
        };
        let among_all = lint_configured(config("ALL"), example.bad);
        for doc in acrc_lint::rules().filter(|doc| doc.group != Group::Suppressions) {
            let alone = lint_configured(config(doc.code.id), example.bad);
            let own = |found: &[Diagnostic]| found.iter().filter(|found| found.code == doc.code).count();
            assert_eq!(own(&alone), own(&among_all), "{} in the example of {}", doc.code.id, example.code.id);
        }
    }
}

#[test]
fn bad_examples_as_a_user_sees_them() {
    let mut page = String::new();
    for doc in shown().filter(|doc| doc.group != Group::Compile) {
        let own: Vec<_> = look(doc, doc.bad).into_iter().filter(|diagnostic| diagnostic.code == doc.code).collect();
        page.push_str(&render(doc.bad, &own));
        page.push('\n');
    }
    insta::assert_snapshot!(page);
}

/// What the linter and the compiler report under the same code.
fn both_report(code: &str, program: &str) -> [bool; 2] {
    [lint(program), compile(program)].map(|found| found.iter().any(|diagnostic| diagnostic.code.id == code))
}

#[test]
fn linter_and_compiler_agree_on_the_characters_of_a_text() {
    let characters = (0x80..0x600).chain(0x2000..0x2300).filter_map(char::from_u32);
    for character in characters.chain(['\u{ffff}', '\u{1f600}']) {
        let [lint, compile] = both_report("ACR026", &format!("PROG0\nPROGRAM\nPRINT \"{character}.\"\nENDP"));
        assert_eq!(lint, compile, "{:x}", u32::from(character));
    }
}

#[test]
fn linter_and_compiler_agree_on_what_an_alias_stands_for() {
    let operands = "P1 BIT24 LV0 $V0 LA0 LA0(1) $A0(1) P(1+2) P(Other) Other -P1 +P1 -5 +5 (5) -(5) (-5) ((P1)) (P1+1) \
                    NOT5 SQRT(4) \"text\" (\"text\") 1.5 ENC0";
    for operand in operands.split_whitespace() {
        let [lint, compile] = both_report("ACR030", &format!("#DEFINE Name {operand}"));
        assert_eq!(lint, compile, "{operand}");
    }
}

#[test]
fn codes_and_names_are_unique_and_in_order() {
    let ids: Vec<_> = acrc_lint::rules().map(|doc| doc.code.id).collect();
    assert!(ids.is_sorted_by(|a, b| a < b), "{ids:?}");
    let mut linter: Vec<_> =
        acrc_lint::rules().filter(|doc| doc.group != Group::Compile).map(|doc| doc.code.name).collect();
    linter.sort_unstable();
    assert!(linter.is_sorted_by(|a, b| a < b), "{linter:?}");
}

#[test]
fn every_code_of_parser_and_compiler_has_a_page() {
    let codes = acrc_syntax::codes::ALL.iter().chain(acrc_analysis::compile_codes::ALL);
    for code in codes {
        assert_eq!(acrc_lint::explain(code.id).map(|doc| doc.code), Some(*code));
    }
}

#[test]
fn a_page_is_found_by_code_and_by_name() {
    let page = acrc_lint::explain("acr101").expect("a rule of the linter");
    assert_eq!(acrc_lint::explain("ACR101"), Some(page));
    assert_eq!(acrc_lint::explain("ACR999"), None);
    insta::assert_snapshot!(page.render());
}

#[test]
fn a_name_of_linter_and_compiler_gives_the_page_of_the_linter() {
    assert_eq!(acrc_lint::explain("undefined-label").map(|doc| doc.code.id), Some("ACR101"));
}

#[test]
fn all_pages() {
    let pages: Vec<_> = acrc_lint::rules().map(RuleDoc::render).collect();
    insta::assert_snapshot!(pages.join("\n----\n\n"));
}
