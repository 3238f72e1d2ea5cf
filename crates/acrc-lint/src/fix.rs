//! Repairs a project: applies the fixes of its findings, again and again until there is nothing more to repair.

use std::collections::BTreeSet;

use acrc_analysis::{Database, Project, SourceFile};
use acrc_diagnostics::{Applicability, Code, Diagnostic, Fix, Severity, Span};
use acrc_syntax::SourceText;

use crate::check;

/// How often a file is looked at again. No fix needs more than a few rounds; this is for one that is wrong.
const MAX_ROUNDS: usize = 100;

/// What became of a project.
#[derive(Clone, Debug, Default)]
pub struct Outcome {
    /// What is found in each file now, in their order.
    pub findings: Vec<(SourceFile, Vec<Diagnostic>)>,
    /// Fixes that were applied, for each file in the same order.
    pub applied: Vec<usize>,
    /// Files that were left as they were, because fixes did harm or never came to an end.
    pub troubles: Vec<Trouble>,
    /// How often the texts were changed and looked at again.
    pub rounds: usize,
}

/// A file that could not be repaired, which is a mistake of this program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Trouble {
    /// The path of the file.
    pub file: String,
    /// What happened.
    pub kind: TroubleKind,
    /// The rules whose fixes took part.
    pub codes: Vec<Code>,
}

/// What went wrong with fixes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TroubleKind {
    /// Behind the fixes the parser refused more than before.
    Harmful,
    /// Every round of fixes left something to fix.
    Endless,
}

/// Applies the fixes that are at most as bold as `boldest` in the files that are `wanted`. `sources` are the texts of the
/// files in their order; they, and the texts in the database, are the repaired ones afterwards. A fix that is only for
/// display is never applied.
pub fn fix(
    db: &mut Database,
    project: Project,
    sources: &mut [SourceText],
    boldest: Applicability,
    wanted: impl Fn(usize) -> bool,
) -> Outcome {
    repair(db, sources, boldest, wanted, |db| check(db, project))
}

/// What is found in each file.
type Findings = Vec<(SourceFile, Vec<Diagnostic>)>;

fn repair(
    db: &mut Database,
    sources: &mut [SourceText],
    boldest: Applicability,
    wanted: impl Fn(usize) -> bool,
    look: impl Fn(&Database) -> Findings,
) -> Outcome {
    let boldest = boldest.min(Applicability::Unsafe);
    let mut findings = look(db);
    let files = findings.iter().map(|(file, _)| *file).zip(sources).enumerate();
    let mut files: Vec<State<'_>> =
        files.map(|(place, (file, source))| State::new(db, file, source, wanted(place))).collect();
    let mut rounds = 0;
    loop {
        let mut changed = false;
        for (state, (_, found)) in files.iter_mut().zip(&findings) {
            changed |= if rounds < MAX_ROUNDS { state.step(db, found, boldest) } else { state.give_up(db) };
        }
        if !changed {
            break;
        }
        rounds += 1;
        findings = look(db);
    }
    Outcome {
        findings,
        applied: files.iter().map(|state| state.applied).collect(),
        troubles: files.into_iter().filter_map(|state| state.trouble).collect(),
        rounds,
    }
}

/// A file on its way.
struct State<'a> {
    file: SourceFile,
    source: &'a mut SourceText,
    original: SourceText,
    errors: usize,
    /// It takes part.
    active: bool,
    applied: usize,
    /// The rules whose fixes were applied in the last round.
    last: Vec<Code>,
    trouble: Option<Trouble>,
}

impl<'a> State<'a> {
    fn new(db: &Database, file: SourceFile, source: &'a mut SourceText, active: bool) -> Self {
        let original = source.clone();
        Self { file, source, original, errors: errors(db, file), active, applied: 0, last: Vec::new(), trouble: None }
    }

    /// One round; whether the text is another one.
    fn step(&mut self, db: &mut Database, found: &[Diagnostic], boldest: Applicability) -> bool {
        if !self.active {
            return false;
        }
        if !self.last.is_empty() && errors(db, self.file) > self.errors {
            return self.stop(db, TroubleKind::Harmful);
        }
        let (fixes, codes): (Vec<&Fix>, Vec<Code>) = choose(found, boldest).into_iter().unzip();
        // Edits that do not fit their text repair nothing.
        let repaired = acrc_diagnostics::apply(&self.source.text, &fixes).ok();
        let Some(repaired) = repaired.filter(|repaired| *repaired != self.source.text) else {
            self.active = false;
            return false;
        };
        self.source.text = repaired;
        // Without its typographic characters a text may be plain ASCII, which is no longer a matter of encodings.
        if let Ok(as_saved) = SourceText::decode(&self.source.encode()) {
            *self.source = as_saved;
        }
        db.replace(self.file, self.source);
        self.applied += codes.len();
        self.last = codes;
        true
    }

    /// Ends a file whose fixes do not come to an end.
    fn give_up(&mut self, db: &mut Database) -> bool {
        self.active && self.stop(db, TroubleKind::Endless)
    }

    fn stop(&mut self, db: &mut Database, kind: TroubleKind) -> bool {
        let codes: BTreeSet<Code> = self.last.iter().copied().collect();
        let trouble = Trouble { file: self.file.name(db).to_owned(), kind, codes: codes.into_iter().collect() };
        self.trouble = Some(trouble);
        self.active = false;
        self.applied = 0;
        self.source.clone_from(&self.original);
        db.replace(self.file, self.source);
        true
    }
}

/// How much of a file the parser refuses.
fn errors(db: &Database, file: SourceFile) -> usize {
    acrc_analysis::parse(db, file).errors().iter().filter(|error| error.severity == Severity::Error).count()
}

/// Of each finding the best fix that is not too bold, as far as they can be applied together; the rest waits for
/// another look at the changed text.
fn choose(found: &[Diagnostic], boldest: Applicability) -> Vec<(&Fix, Code)> {
    let mut taken = Taken::default();
    let best = |finding: &'_ Diagnostic| finding.fixes.iter().position(|fix| fix.applicability <= boldest);
    let candidates = found.iter().filter_map(|finding| Some((finding.fixes.get(best(finding)?)?, finding.code)));
    candidates.filter(|(fix, _)| taken.take(fix)).collect()
}

/// The places that are changed already.
#[derive(Default)]
struct Taken(BTreeSet<Span>);

impl Taken {
    /// Takes the places of a fix, if all of them are free.
    fn take(&mut self, fix: &Fix) -> bool {
        let mut own = Self::default();
        let free = fix.edits.iter().all(|edit| {
            let free = self.is_free(edit.span) && own.is_free(edit.span);
            own.0.insert(edit.span);
            free
        });
        if free {
            self.0.append(&mut own.0);
        }
        free
    }

    /// Whether nothing is changed at a place. What is inserted stays clear of other changes: a colon that is inserted
    /// before a remark means nothing where the remark goes.
    fn is_free(&self, span: Span) -> bool {
        let apart = |left: Span, right: Span| {
            left.end < right.start || left.end == right.start && !left.is_empty() && !right.is_empty()
        };
        let before = self.0.range(..=span).next_back();
        let after = self.0.range(span..).next();
        before.is_none_or(|before| apart(*before, span)) && after.is_none_or(|after| apart(span, *after))
    }
}

#[cfg(test)]
mod tests {
    use acrc_analysis::FileRole;
    use acrc_diagnostics::Edit;

    use super::*;

    const CODE: Code = Code { id: "ACR999", name: "bad-fix" };

    /// Repairs a text with a fix that is made of the text anew in each round.
    fn repair_with(text: &str, fix: impl Fn(&str) -> Fix) -> (String, String, Outcome) {
        let mut db = Database::new();
        let file = SourceFile::new(&db, "a.8K".to_owned(), text.to_owned(), FileRole::Any, Vec::new());
        let mut sources =
            [SourceText { text: text.to_owned(), encoding: acrc_syntax::Encoding::Utf8, end_mark: false }];
        let look = |db: &Database| {
            let finding = Diagnostic::advice(CODE, Span::empty(0), "bad").with_fix(fix(file.text(db)));
            vec![(file, vec![finding])]
        };
        let outcome = repair(&mut db, &mut sources, Applicability::Safe, |_| true, look);
        (file.text(&db).to_owned(), sources[0].text.clone(), outcome)
    }

    #[test]
    fn a_fix_that_never_ends_leaves_the_file_as_it_was() {
        let endless = |_: &str| Fix::safe("longer", vec![Edit::insert(0, "REM x\n")]);
        let (text, source, outcome) = repair_with("SET 32\n", endless);
        assert_eq!((text.as_str(), source.as_str(), &outcome.applied[..]), ("SET 32\n", "SET 32\n", &[0][..]));
        let trouble = Trouble { file: "a.8K".to_owned(), kind: TroubleKind::Endless, codes: vec![CODE] };
        assert_eq!(outcome.troubles, [trouble]);
    }

    #[test]
    fn a_fix_that_breaks_a_statement_leaves_the_file_as_it_was() {
        let harmful = |text: &str| Fix::safe("break", vec![Edit::insert(text.len() as u32, "P0 = (\n")]);
        let (text, source, outcome) = repair_with("SET 32\n", harmful);
        assert_eq!((text.as_str(), source.as_str()), ("SET 32\n", "SET 32\n"));
        assert_eq!(outcome.troubles.first().map(|trouble| trouble.kind), Some(TroubleKind::Harmful));
    }

    #[test]
    fn edits_that_do_not_fit_their_text_repair_nothing() {
        let (text, _, outcome) = repair_with("SET 32\n", |_| Fix::safe("miss", vec![Edit::insert(99, "x")]));
        assert_eq!((text.as_str(), outcome.rounds, outcome.troubles.len()), ("SET 32\n", 0, 0));
    }

    fn fix_at(spans: &[(u32, u32)]) -> Fix {
        let edit = |&(start, end)| acrc_diagnostics::Edit::delete(Span::new(start, end));
        Fix::safe("", spans.iter().map(edit).collect())
    }

    #[test]
    fn places_are_taken_once() {
        let mut taken = Taken::default();
        assert!(taken.take(&fix_at(&[(2, 4), (8, 8)])));
        assert!(taken.take(&fix_at(&[(4, 7)])));
        assert!(!taken.take(&fix_at(&[(8, 8)])), "two insertions at a place");
        assert!(!taken.take(&fix_at(&[(8, 9)])), "an insertion and a change at a place");
        assert!(!taken.take(&fix_at(&[(0, 1), (3, 5)])));
        assert!(taken.take(&fix_at(&[(0, 2)])), "a refused fix takes nothing");
        assert!(!taken.take(&fix_at(&[(10, 12), (11, 13)])), "nor does one that overlaps itself");
    }
}
