//! Which rules are heard in a file, and how loud.
//!
//! What is said of rules comes in layers: the rules that are on by themselves, `[lint]`, each `[[lint.override]]` that
//! is about the file, the command line. A layer with `select` begins anew, one without adds to the layer before. Within
//! a layer the more exact selector counts, and `ignore` between equally exact ones. Last of all come the
//! `per-file-ignores`. What the parser reports as an error is always heard.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use acrc_analysis::FileContext;
use acrc_analysis::project::{FileGlob, FileGlobs, LintConfig, LintLevel, Override, PatternUse, Selection};
use acrc_diagnostics::{Diagnostic, Severity};

use crate::plan::Plan;
use crate::registry::RULES;
use crate::rule::{Group, RuleDoc};
use crate::selector::{RuleSet, Selector};

/// The rules that are heard in a file.
pub(crate) struct Settings {
    /// The rules that are on.
    pub(crate) on: RuleSet,
    /// Severities that differ from those of the rules, by place in the registry.
    severities: Vec<Option<Severity>>,
    /// The checks of the rules that are on.
    pub(crate) plan: Plan,
}

impl Settings {
    /// Whether a finding is heard. One of an unknown code is.
    pub(crate) fn hear(&self, finding: &Diagnostic) -> bool {
        place_of(finding.code.id).is_none_or(|place| self.on.contains(place) || is_refused(place, finding))
    }

    /// Gives a finding the severity that was asked for.
    pub(crate) fn set_severity(&self, finding: &mut Diagnostic) {
        let Some(place) = place_of(finding.code.id) else { return };
        if let Some(severity) = self.severity(place).filter(|_| !is_refused(place, finding)) {
            // What no document settles must not stop a build.
            let highest = if finding.unconfirmed { Severity::Warning } else { Severity::Error };
            finding.severity = severity.min(highest);
        }
    }

    /// Whether what a rule finds is heard, and as an error.
    pub(crate) fn is_error(&self, doc: &RuleDoc) -> bool {
        let heard = place_of(doc.code.id).filter(|place| self.on.contains(*place));
        heard.is_some_and(|place| self.severity(place).unwrap_or(doc.severity) == Severity::Error)
    }

    /// The severity of a rule, when it is not its own.
    pub(crate) fn severity(&self, place: usize) -> Option<Severity> {
        self.severities.get(place).copied().flatten()
    }
}

/// Whether the parser refuses the text with this finding, which is then heard in any case. The finding has the severity
/// that it was made with.
pub(crate) fn is_refused(place: usize, finding: &Diagnostic) -> bool {
    finding.severity == Severity::Error && RULES.get(place).is_some_and(|rule| rule.doc.group == Group::Syntax)
}

/// The place of a rule in the registry, by its code.
pub(crate) fn place_of(code: &str) -> Option<usize> {
    RULES.binary_search_by_key(&code, |rule| rule.doc.code.id).ok()
}

/// Whether a rule is always on: the parser reports its findings, as errors.
pub(crate) fn is_locked(doc: &RuleDoc) -> bool {
    doc.group == Group::Syntax && doc.severity == Severity::Error
}

/// What is heard in a file; `None` when it is not checked.
pub(crate) fn of_file(file: &FileContext<'_>) -> Option<Arc<Settings>> {
    of(file.lint, Some(file.name))
}

/// What is heard in the file of this name, or in one that no pattern is about.
pub(crate) fn of(config: &LintConfig, name: Option<&str>) -> Option<Arc<Settings>> {
    let prepare = || Prepared::new(config);
    match config.prepared.get_or_init(prepare) {
        Some(prepared) => prepared.of_file(config, name),
        None => prepare().of_file(config, name),
    }
}

/// What a configuration says, with its selectors and patterns understood.
struct Prepared {
    lint: Layer,
    command_line: Layer,
    /// All patterns.
    globs: FileGlobs,
    /// What each of them is for.
    uses: Vec<PatternUse>,
    overrides: Vec<Layer>,
    /// In the order of [`LintConfig::per_file_ignores`].
    ignores: Vec<RuleSet>,
    /// For files that no pattern is about.
    general: Arc<Settings>,
    /// For files that some patterns are about, by those patterns: many files share one.
    special: Mutex<BTreeMap<Vec<usize>, Arc<Settings>>>,
}

impl Prepared {
    fn new(config: &LintConfig) -> Self {
        let lint = Layer::new(config.select.as_deref(), &config.extend_select, &config.ignore, &config.severity);
        let of_override =
            |part: &Override| Layer::new(part.select.as_deref(), &part.extend_select, &part.ignore, &part.severity);
        let Selection { select, extend_select, ignore } = &config.command_line;
        let command_line = Layer::new(select.as_deref(), extend_select, ignore, &BTreeMap::new());
        let (globs, uses): (Vec<&FileGlob>, Vec<PatternUse>) = config.patterns().unzip();
        Self {
            // What is too long is told by `problems`.
            globs: FileGlobs::new(globs).unwrap_or_default(),
            uses,
            general: Arc::new(resolve(&[&lint, &command_line], RuleSet::default())),
            overrides: config.overrides.iter().map(of_override).collect(),
            ignores: config.per_file_ignores.0.iter().map(|(_, selectors)| union(selectors)).collect(),
            special: Mutex::default(),
            lint,
            command_line,
        }
    }

    fn of_file(&self, config: &LintConfig, name: Option<&str>) -> Option<Arc<Settings>> {
        let matching = match name {
            Some(name) if !self.uses.is_empty() => self.globs.matching(config.relative(name)),
            _ => Vec::new(),
        };
        if matching.is_empty() {
            return Some(Arc::clone(&self.general));
        }
        let mut overrides = Vec::new();
        let mut ignored = RuleSet::default();
        for usage in matching.iter().filter_map(|place| self.uses.get(*place)) {
            match *usage {
                PatternUse::Exclude => return None,
                PatternUse::Override(place) => overrides.push(place),
                PatternUse::Ignore(place) => ignored.add(self.ignores.get(place).copied().unwrap_or_default()),
            }
        }
        // What another thread was doing when it panicked does no harm here: the map only ever grows.
        let mut special = self.special.lock().unwrap_or_else(PoisonError::into_inner);
        let settings = special.entry(matching).or_insert_with(|| {
            overrides.dedup();
            let overrides = overrides.iter().filter_map(|place| self.overrides.get(*place));
            let layers: Vec<&Layer> = [&self.lint].into_iter().chain(overrides).chain([&self.command_line]).collect();
            Arc::new(resolve(&layers, ignored))
        });
        Some(Arc::clone(settings))
    }
}

fn union(selectors: &[String]) -> RuleSet {
    let mut rules = RuleSet::default();
    for selector in selectors.iter().filter_map(|selector| Selector::parse(selector)) {
        rules.add(selector.rules);
    }
    rules
}

/// What one place says of rules.
struct Layer {
    /// The layer begins anew instead of changing what was said before.
    selects: bool,
    /// In the order of their ranks.
    choices: Vec<(Selector, Choice)>,
    /// In the order of their ranks.
    levels: Vec<(Selector, LintLevel)>,
}

/// What happens to the rules of a selector.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Choice {
    On,
    Off,
    /// The severity `off`: one more way to ignore, which a later severity takes back.
    Silent,
}

impl Layer {
    fn new(
        select: Option<&[String]>,
        extend_select: &[String],
        ignore: &[String],
        severity: &BTreeMap<String, LintLevel>,
    ) -> Self {
        let read = |selectors: &[String], choice: Choice| {
            let parsed = selectors.iter().filter_map(|selector| Selector::parse(selector));
            parsed.map(|selector| (selector, choice)).collect::<Vec<_>>()
        };
        let mut choices = read(select.unwrap_or_default(), Choice::On);
        choices.extend(read(extend_select, Choice::On));
        choices.extend(read(ignore, Choice::Off));
        let mut levels: Vec<_> =
            severity.iter().filter_map(|(selector, level)| Some((Selector::parse(selector)?, *level))).collect();
        levels.sort_by_key(|(selector, _)| selector.rank);
        for (place, (selector, level)) in levels.iter().enumerate() {
            if *level == LintLevel::Off {
                let mut silent = selector.clone();
                silent.rules.remove(loud(levels.get(place..).unwrap_or_default()));
                choices.push((silent, Choice::Silent));
            }
        }
        choices.sort_by_key(|(selector, _)| selector.rank);
        Self { selects: select.is_some(), choices, levels }
    }

    /// The rules that are on after this layer. Those of `loud` have a severity in a later one.
    fn apply(&self, before: RuleSet, loud: RuleSet) -> RuleSet {
        let mut on = if self.selects { RuleSet::default() } else { before };
        let mut choices = self.choices.iter().peekable();
        while let Some((first, _)) = choices.peek() {
            let rank = first.rank;
            let mut ignored = RuleSet::default();
            while let Some((selector, choice)) = choices.next_if(|(selector, _)| selector.rank == rank) {
                let mut rules = selector.rules;
                match choice {
                    Choice::On => on.add(rules),
                    Choice::Off => ignored.add(rules),
                    Choice::Silent => {
                        rules.remove(loud);
                        ignored.add(rules);
                    }
                }
            }
            on.remove(ignored);
        }
        on
    }
}

/// The rules that are given a severity other than `off`.
fn loud(levels: &[(Selector, LintLevel)]) -> RuleSet {
    let mut rules = RuleSet::default();
    for (selector, _) in levels.iter().filter(|(_, level)| *level != LintLevel::Off) {
        rules.add(selector.rules);
    }
    rules
}

fn resolve(layers: &[&Layer], ignored: RuleSet) -> Settings {
    let mut on = RuleSet::of(|doc| doc.enabled);
    let mut severities = Vec::new();
    for (place, layer) in layers.iter().enumerate() {
        let mut loud_later = RuleSet::default();
        for later in layers.iter().skip(place + 1) {
            loud_later.add(loud(&later.levels));
        }
        on = layer.apply(on, loud_later);
        if !layer.levels.is_empty() {
            severities.resize(RULES.len(), None);
        }
        for (selector, level) in &layer.levels {
            let chosen = severities.iter_mut().enumerate().filter(|(place, _)| selector.rules.contains(*place));
            chosen.for_each(|(_, severity)| *severity = level.severity());
        }
    }
    on.remove(ignored);
    on.add(RuleSet::of(is_locked));
    Settings { plan: Plan::new(on), on, severities }
}
