//! Findings that the author of a program suppresses with a comment.
//!
//! A comment on a line of its own is about the next line with a statement that is no remark, one behind statements
//! about its line, and `allow-file` about the file. A finding belongs to the line on which it begins. What the parser
//! refuses can't be suppressed: the controller refuses it too.

mod comment;
mod remove;

use std::ops::RangeInclusive;

use acrc_analysis::FileContext;
use acrc_diagnostics::{Diagnostic, Span};
use acrc_syntax::Tree;
use acrc_syntax::ast::{Line, Statement, StatementKind};

pub(crate) use self::comment::Mistake;
use self::comment::{Allow, Scope};
use crate::consequences::Consequences;
use crate::registry::RULES;
use crate::rule::{Group, RuleDoc};
use crate::rules::suppressions::{unknown_suppression, unused_suppression};
use crate::settings::{Settings, is_locked, is_refused, place_of};

/// How many unknown names of a file are compared with those of all rules.
const MAX_SUGGESTIONS: usize = 50;

/// A comment that suppresses findings, and its place in the file.
struct Suppression {
    allow: Allow,
    site: Site,
    /// Lines, counted from 0.
    lines: RangeInclusive<usize>,
}

impl Suppression {
    /// The text that it is about.
    fn part(&self, file: &FileContext<'_>) -> Span {
        let line = |at: usize| file.tree.lines().get(at).map_or(Span::empty(0), |line| line.span);
        match self.allow.scope {
            Scope::File => Span::new(0, file.text.len() as u32),
            Scope::Line => Span::cover(line(*self.lines.start()), line(*self.lines.end())),
        }
    }
}

/// Where a comment stands.
#[derive(Clone, Copy)]
pub(crate) struct Site {
    /// With its apostrophe or `REM`.
    span: Span,
    /// Counted from 0.
    line: usize,
    /// The statement that it is; `None` for an apostrophe comment.
    remark: Option<u32>,
    /// Nothing else stands on the line, but perhaps its number.
    alone: bool,
}

/// One rule that a comment allows.
struct Use {
    /// Of the comment, and of the name in it.
    place: (usize, usize),
    /// Of the rule in the registry.
    rule: usize,
    /// It suppressed something.
    used: bool,
}

/// Takes out what comments of the file suppress, and adds what is to say about those comments.
pub(crate) fn apply(
    file: &FileContext<'_>,
    settings: &Settings,
    consequences: &Consequences,
    found: &mut Vec<Diagnostic>,
) {
    let mut said = Vec::new();
    let suppressions = collect(file.tree, file.text, &mut said);
    if suppressions.is_empty() && said.is_empty() {
        return;
    }
    let mut uses = resolve(file.text, &suppressions, &mut said);
    let index = Index::new(&suppressions, &uses);
    let starts = line_starts(file.tree);
    found.retain(|finding| {
        let Some(rule) = place_of(finding.code.id).filter(|rule| !is_refused(*rule, finding)) else { return true };
        let hit = index.find(rule, line_of(&starts, finding.span)).and_then(|hit| uses.get_mut(hit));
        hit.map(|hit| hit.used = true).is_none()
    });
    let judged: Vec<Use> = uses
        .into_iter()
        .filter(|usage| {
            let suppression = suppressions.get(usage.place.0);
            suppression.is_some_and(|suppression| !consequences.touch(suppression.part(file)))
        })
        .collect();
    report_unused(file, settings, &suppressions, &judged, &mut said);
    let allowed_in_file = |finding: &Diagnostic| place_of(finding.code.id).and_then(|rule| index.in_file(rule));
    said.retain(|finding| settings.hear(finding) && allowed_in_file(finding).is_none());
    found.append(&mut said);
}

/// Whether a comment of a text suppresses what a rule finds at a place.
pub(crate) fn is_allowed(tree: &Tree, text: &str, place: Span, doc: &RuleDoc) -> bool {
    let suppressions = collect(tree, text, &mut Vec::new());
    let uses = resolve(text, &suppressions, &mut Vec::new());
    let line = line_of(&line_starts(tree), place);
    place_of(doc.code.id).is_some_and(|rule| Index::new(&suppressions, &uses).find(rule, line).is_some())
}

/// The rules that comments of a text name to allow them, and where; what names no rule is left out.
pub fn allowed_rules(tree: &Tree, text: &str) -> Vec<(Span, &'static RuleDoc)> {
    let suppressions = collect(tree, text, &mut Vec::new());
    let names = suppressions.iter().flat_map(|suppression| &suppression.allow.names);
    names
        .filter_map(|span| {
            let rule = RULES.get(rule_named(text.get(span.range())?)?)?;
            Some((*span, &rule.doc))
        })
        .collect()
}

fn line_starts(tree: &Tree) -> Vec<u32> {
    tree.lines().iter().map(|line| line.span.start).collect()
}

/// The line on which a finding begins, counted from 0.
fn line_of(starts: &[u32], place: Span) -> usize {
    starts.partition_point(|start| *start <= place.start).saturating_sub(1)
}

/// The comments of a file, in order.
fn collect(tree: &Tree, text: &str, said: &mut Vec<Diagnostic>) -> Vec<Suppression> {
    let lines = tree.lines();
    let mut suppressions: Vec<Suppression> = Vec::new();
    // The first of those that still wait for the line that they are about.
    let mut waiting = 0;
    for (at, line) in lines.iter().enumerate() {
        let statements = statements_of(tree, line);
        if statements.iter().any(|statement| !matches!(statement.kind, StatementKind::Remark(_))) {
            for earlier in suppressions.iter_mut().skip(waiting).filter(|earlier| earlier.site.alone) {
                earlier.lines = *earlier.lines.start()..=at;
            }
            waiting = suppressions.len();
        }
        let Some((site, body)) = site(text, line, at, statements) else { continue };
        let (allow, mistake) = comment::read(text.get(body.range()).unwrap_or_default(), body.start, site.alone);
        said.extend(mistake.map(unknown_suppression::mistake));
        suppressions.extend(allow.map(|allow| Suppression { allow, site, lines: at..=at }));
    }
    suppressions
}

/// The comment of a line, and its text.
fn site(text: &str, line: &Line, at: usize, statements: &[Statement]) -> Option<(Site, Span)> {
    if let Some(span) = line.comment {
        // The apostrophe may be a curly one.
        let apostrophe = text.get(span.range())?.chars().next().map_or(0, char::len_utf8) as u32;
        let body = Span::new(span.start + apostrophe, span.end);
        return Some((Site { span, line: at, remark: None, alone: statements.is_empty() }, body));
    }
    let (last, before) = statements.split_last()?;
    let StatementKind::Remark(body) = last.kind else { return None };
    let remark = line.statements.end.checked_sub(1);
    Some((Site { span: last.span, line: at, remark, alone: before.is_empty() }, body))
}

fn statements_of<'t>(tree: &'t Tree, line: &Line) -> &'t [Statement] {
    tree.statements().get(line.statements.start as usize..line.statements.end as usize).unwrap_or_default()
}

/// Finds the rules that the comments name.
fn resolve(text: &str, suppressions: &[Suppression], said: &mut Vec<Diagnostic>) -> Vec<Use> {
    let mut uses = Vec::new();
    let mut unknown = 0;
    for (comment, suppression) in suppressions.iter().enumerate() {
        for (name, span) in suppression.allow.names.iter().enumerate() {
            let written = text.get(span.range()).unwrap_or_default();
            match rule_named(written) {
                Some(rule) if RULES.get(rule).is_some_and(|found| is_locked(&found.doc)) => {
                    said.push(unknown_suppression::locked(*span, written));
                }
                Some(rule) => uses.push(Use { place: (comment, name), rule, used: false }),
                None => {
                    unknown += 1;
                    said.push(unknown_suppression::unknown(*span, written, unknown <= MAX_SUGGESTIONS));
                }
            }
        }
    }
    uses
}

/// The rule of a code or name; of the linter, where the compiler has one of the same name.
fn rule_named(written: &str) -> Option<usize> {
    let rules = || RULES.iter().enumerate();
    let is_reported = |group: Group, checks: usize| group != Group::Compile || checks > 0;
    let by = |has: &dyn Fn(&acrc_diagnostics::Code) -> bool| {
        let found = rules().find(|(_, rule)| is_reported(rule.doc.group, rule.checks.len()) && has(&rule.doc.code));
        found.map(|(place, _)| place)
    };
    by(&|code| code.id.eq_ignore_ascii_case(written)).or_else(|| by(&|code| code.name.eq_ignore_ascii_case(written)))
}

/// Finds the comment that allows a rule on a line.
struct Index {
    /// Rule, first line, last line, use; in this order. Of one rule, a later first line never has an earlier last one.
    lines: Vec<(usize, usize, usize, usize)>,
    /// Rule and use, in this order.
    file: Vec<(usize, usize)>,
}

impl Index {
    fn new(suppressions: &[Suppression], uses: &[Use]) -> Self {
        let mut index = Self { lines: Vec::new(), file: Vec::new() };
        for (place, usage) in uses.iter().enumerate() {
            let Some(suppression) = suppressions.get(usage.place.0) else { continue };
            let (first, last) = (*suppression.lines.start(), *suppression.lines.end());
            match suppression.allow.scope {
                Scope::Line => index.lines.push((usage.rule, first, last, place)),
                Scope::File => index.file.push((usage.rule, place)),
            }
        }
        index.lines.sort_unstable();
        index.file.sort_unstable();
        index
    }

    fn find(&self, rule: usize, line: usize) -> Option<usize> {
        let after = self.lines.partition_point(|(other, first, ..)| (*other, *first) <= (rule, line));
        let nearest = after.checked_sub(1).and_then(|before| self.lines.get(before));
        let on_line = nearest.filter(|(other, _, last, _)| *other == rule && line <= *last);
        on_line.map(|(.., place)| *place).or_else(|| self.in_file(rule))
    }

    fn in_file(&self, rule: usize) -> Option<usize> {
        let at = self.file.partition_point(|(other, _)| *other < rule);
        self.file.get(at).filter(|(other, _)| *other == rule).map(|(_, place)| *place)
    }
}

/// Says which names of which comments suppress nothing. A rule that is off could not have found anything, nor could one
/// beside a statement that can't be read, where `uses` are left out.
fn report_unused(
    file: &FileContext<'_>,
    settings: &Settings,
    suppressions: &[Suppression],
    uses: &[Use],
    said: &mut Vec<Diagnostic>,
) {
    let own = |rule: usize| RULES.get(rule).is_some_and(|rule| rule.doc.group == Group::Suppressions);
    let is_unused = |usage: &Use| !usage.used && settings.on.contains(usage.rule) && !own(usage.rule);
    for of_comment in uses.chunk_by(|a, b| a.place.0 == b.place.0) {
        let unused: Vec<usize> =
            of_comment.iter().filter(|usage| is_unused(usage)).map(|usage| usage.place.1).collect();
        let comment = of_comment.first().and_then(|usage| suppressions.get(usage.place.0));
        let (Some(Suppression { allow, site, .. }), false) = (comment, unused.is_empty()) else { continue };
        let names: Vec<Span> = unused.iter().filter_map(|name| allow.names.get(*name).copied()).collect();
        let all = names.len() == allow.names.len();
        let fix = if all { remove::comment(file, *site) } else { remove::names(file, allow, &unused) };
        let span = if all { site.span } else { names.first().copied().unwrap_or(allow.list) };
        let names = names.iter().filter_map(|name| file.text.get(name.range()));
        said.push(unused_suppression::finding(span, names, allow.scope == Scope::File, fix));
    }
}
