//! What the tests of the rules share.

use acrc_analysis::project::Config;
use acrc_analysis::{Database, FileRole, Project, SourceFile};
use acrc_catalog::Model;
use acrc_diagnostics::{Diagnostic, LineIndex, Severity};

/// The findings in the files of a project, each a name and a text.
pub(crate) fn lint(files: &[(&str, &str)]) -> Vec<Vec<Diagnostic>> {
    lint_with(acrc_catalog::default_model(), Config::default(), files)
}

/// The findings in a single file of a project that names its model.
pub(crate) fn lint_as(model: &str, text: &str) -> Vec<Diagnostic> {
    let mut config = Config::default();
    config.project.model = Some(model.to_owned());
    let model = acrc_catalog::model(model).expect("a model of the catalogue");
    lint_with(model, config, &[("test.8K", text)]).concat()
}

fn lint_with(model: &'static Model, config: Config, files: &[(&str, &str)]) -> Vec<Vec<Diagnostic>> {
    let db = Database::new();
    let inputs = files.iter().map(|(name, text)| {
        SourceFile::new(&db, (*name).to_owned(), (*text).to_owned(), FileRole::of(name), Vec::new())
    });
    let project = Project::new(&db, inputs.collect(), model, config);
    crate::check(&db, project).into_iter().map(|(_, found)| found).collect()
}

/// The lines at which one rule, on by itself or not, finds something in each file of a project.
pub(crate) fn lines_of(code: &str, files: &[(&str, &str)]) -> Vec<Vec<u32>> {
    let found = only(code, files);
    let line = |text: &str, found: &Diagnostic| LineIndex::new(text).position(found.span.start).line;
    files.iter().zip(found).map(|((_, text), found)| found.iter().map(|found| line(text, found)).collect()).collect()
}

/// The findings of one rule, on by itself or not, in a single file.
pub(crate) fn found_by(code: &str, text: &str) -> Vec<Diagnostic> {
    only(code, &[("test.8K", text)]).concat()
}

/// The findings of one rule. What the parser refuses is heard too, and left out here.
fn only(code: &str, files: &[(&str, &str)]) -> Vec<Vec<Diagnostic>> {
    let mut config = Config::default();
    config.lint.select = Some(vec![code.to_owned()]);
    let mut found = lint_with(acrc_catalog::default_model(), config, files);
    for findings in &mut found {
        findings.retain(|finding| finding.code.id == code);
    }
    found
}

/// The texts at which one rule, on by itself or not, finds something in a single file.
pub(crate) fn spans_of<'t>(code: &str, text: &'t str) -> Vec<&'t str> {
    let found = found_by(code, text);
    found.iter().map(|found| text.get(found.span.range()).unwrap_or_default()).collect()
}

/// The texts at which one rule finds something in the text of program 0, whose axes are X and Y.
pub(crate) fn spans_in_program(code: &str, program: &str) -> Vec<String> {
    let setup = "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \"Y\"\n";
    let text = format!("{setup}PROGRAM\n{program}\nENDP\n");
    spans_of(code, &text).into_iter().map(str::to_owned).collect()
}

/// Lines and codes of what is found in a single file, advice left out.
pub(crate) fn codes(text: &str) -> Vec<(u32, &'static str)> {
    codes_in(text, &lint(&[("test.8K", text)]).concat())
}

/// Lines and codes of findings, advice left out.
pub(crate) fn codes_in(text: &str, found: &[Diagnostic]) -> Vec<(u32, &'static str)> {
    let index = LineIndex::new(text);
    let loud = found.iter().filter(|diagnostic| diagnostic.severity > Severity::Advice);
    loud.map(|diagnostic| (index.position(diagnostic.span.start).line, diagnostic.code.id)).collect()
}

/// A single file after the first fix of each finding of one rule.
pub(crate) fn fixed(code: &str, text: &str) -> String {
    let mut config = Config::default();
    config.lint.select = Some(vec![code.to_owned()]);
    let found = lint_with(acrc_catalog::default_model(), config, &[("test.8K", text)]).concat();
    let fixes: Vec<_> = found.iter().filter_map(|found| found.fixes.first()).collect();
    acrc_diagnostics::apply(text, &fixes).expect("fixes of one rule fit together")
}
