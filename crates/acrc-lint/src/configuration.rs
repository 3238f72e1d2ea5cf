//! What a configuration says of rules: whether it can be understood, and what comes of it.

use std::fmt::Write as _;

use acrc_analysis::project::{FileGlobs, LintConfig, LintLevel};
use acrc_analysis::{Database, FileRole, Project, SourceFile, project::Config};
use acrc_diagnostics::{Applicability, Severity};

use crate::registry::RULES;
use crate::rule::{Group, RuleDoc};
use crate::selector::{ALL, Rank, Selector, near};
use crate::settings;

/// A rule as a configuration has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RuleState {
    /// Its page.
    pub doc: &'static RuleDoc,
    /// It is heard.
    pub on: bool,
    /// How loud.
    pub severity: Severity,
}

/// The rules that `acrc lint` knows, in the order of their codes, as they are in a file that no pattern is about. What
/// only the compiler reports is not among them.
pub fn rule_states(config: &LintConfig) -> Vec<RuleState> {
    let Some(settings) = settings::of(config, None) else { return Vec::new() };
    let rules = RULES.iter().enumerate();
    let by_linter = rules.filter(|(_, rule)| rule.doc.group != Group::Compile || !rule.checks.is_empty());
    by_linter
        .map(|(place, rule)| {
            let asked = settings.severity(place).filter(|_| !settings::is_locked(&rule.doc));
            RuleState { doc: &rule.doc, on: settings.on.contains(place), severity: asked.unwrap_or(rule.doc.severity) }
        })
        .collect()
}

/// What is wrong with the selectors of a configuration, a sentence each. The checks go on without those selectors.
pub fn problems(config: &LintConfig) -> Vec<String> {
    let mut problems = Problems(Vec::new());
    problems.choice("", "lint.", config.select.as_deref(), &config.extend_select, &config.ignore);
    problems.levels("lint.severity", config.severity.iter());
    for (glob, selectors) in &config.per_file_ignores.0 {
        problems.ignores(&format!("lint.per-file-ignores, `{}`,", glob.as_str()), selectors);
    }
    for (number, part) in (1..).zip(&config.overrides) {
        let place = format!("lint.override {number}, ");
        problems.choice(&place, "", part.select.as_deref(), &part.extend_select, &part.ignore);
        problems.levels(&format!("{place}severity"), part.severity.iter());
        if part.files.is_empty() {
            problems.0.push(format!("{place}files is empty: name the files that it is about"));
        }
    }
    if let Err(problem) = FileGlobs::new(config.patterns().map(|(glob, _)| glob)) {
        problems.0.push(problem);
    }
    let given = &config.command_line;
    problems.choice("", "--", given.select.as_deref(), &given.extend_select, &given.ignore);
    problems.0
}

struct Problems(Vec<String>);

impl Problems {
    fn choice(&mut self, place: &str, dash: &str, select: Option<&[String]>, also: &[String], ignore: &[String]) {
        for (key, selectors) in [("select", select.unwrap_or_default()), ("extend-select", also)] {
            for selector in selectors {
                self.known(&format!("{place}{dash}{key}"), selector);
            }
        }
        self.ignores(&format!("{place}{dash}ignore"), ignore);
    }

    fn ignores(&mut self, place: &str, selectors: &[String]) {
        for selector in selectors {
            self.may_be_off(place, selector);
        }
    }

    fn levels<'c>(&mut self, place: &str, levels: impl Iterator<Item = (&'c String, &'c LintLevel)>) {
        for (selector, level) in levels {
            match level {
                LintLevel::Off => self.may_be_off(place, selector),
                _ => self.known(place, selector),
            }
        }
    }

    fn known(&mut self, place: &str, selector: &str) {
        if Selector::parse(selector).is_some() {
            return;
        }
        let help = match near(selector) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("`acrc lint --rules` lists all rules; `{ALL}` means every one"),
        };
        self.0.push(format!("{place} names `{selector}`, which is no rule, group or beginning of a code: {help}"));
    }

    /// A rule that is always on must not be turned off by name: the author would think that it is.
    fn may_be_off(&mut self, place: &str, selector: &str) {
        self.known(place, selector);
        let Some(named) = Selector::parse(selector).filter(|named| named.rank == Rank::Rule) else { return };
        let mut meant = RULES.iter().enumerate().filter(|(rule, _)| named.rules.contains(*rule));
        if meant.any(|(_, rule)| settings::is_locked(&rule.doc)) {
            self.0.push(format!(
                "{place} names `{selector}`, which is always on: the controller refuses what can't be read"
            ));
        }
    }
}

impl RuleDoc {
    /// What it finds, in a sentence.
    pub fn summary(&self) -> &'static str {
        let ends = self.what.match_indices(". ").map(|(at, _)| at);
        // `FOR .. NEXT` is no end of a sentence.
        let mut ends = ends.filter(|at| self.what.get(..*at).is_some_and(|text| !text.ends_with(['.', ' '])));
        ends.next().and_then(|end| self.what.get(..end)).unwrap_or(self.what).trim_end_matches('.')
    }

    /// Whether the mistake that its page shows can be repaired, and how freely.
    pub fn fix(&self) -> Option<Applicability> {
        let db = Database::new();
        let name = "example.8K";
        let file = SourceFile::new(&db, name.to_owned(), self.bad.to_owned(), FileRole::of(name), Vec::new());
        let mut config = Config::default();
        config.lint.extend_select.push(self.code.id.to_owned());
        let project = Project::new(&db, vec![file], acrc_catalog::default_model(), config);
        let found = crate::check(&db, project).into_iter().flat_map(|(_, found)| found);
        let fixes = found.filter(|finding| finding.code == self.code).flat_map(|finding| finding.fixes);
        fixes.map(|fix| fix.applicability).filter(|applicability| *applicability < Applicability::DisplayOnly).min()
    }

    /// The page in Markdown.
    pub fn markdown(&self) -> String {
        let Self { what, why, bad, good, guide, .. } = self;
        let mut page = format!("{what}\n\n{why}\n");
        for (title, program) in [("Bad", bad), ("Good", good)] {
            let _ = write!(page, "\n{title}:\n\n```basic\n{}\n```\n", program.trim_end());
        }
        let _ = writeln!(page, "\nGuide: {guide}");
        page
    }

    /// How to turn it off or suppress it, as text ending in a line break. Nothing for what is always reported.
    pub fn configuration(&self) -> String {
        let name = self.code.name;
        if settings::is_locked(self) {
            return "It is always on, and can't be suppressed.\n".to_owned();
        }
        if self.group == Group::Compile {
            return String::new();
        }
        let mut text = String::from("Suppress it\n");
        for (place, words) in [
            ("in the next line", format!("' acrc: allow({name}) -- why")),
            ("in a line", format!("SET 32 : REM acrc: allow({name})")),
            ("in a file", format!("' acrc: allow-file({name})")),
            ("in a project", format!("[lint]  ignore = [\"{name}\"]")),
        ] {
            // Writing to a string does not fail.
            let _ = writeln!(text, "    {place:<18}{words}");
        }
        if !self.enabled {
            let words = format!("[lint]  extend-select = [\"{name}\"]");
            let _ = writeln!(text, "\nTurn it on\n    {:<18}{words}", "in a project");
        }
        text
    }
}
