//! What is written to mean rules: `ALL`, a group, the beginning of a code, a code, a name.

use acrc_analysis::nearest;

use crate::registry::RULES;
use crate::rule::{Group, RuleDoc};

/// The selector that means every rule.
pub(crate) const ALL: &str = "ALL";
/// What every code begins with.
const CODE_PREFIX: &str = "ACR";

/// How exactly a selector names what it means; of two that disagree the more exact one counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Rank {
    /// `ALL`
    All,
    /// `flow`
    Group,
    /// `ACR1`, by its length
    Prefix(usize),
    /// `ACR101`, `undefined-label`
    Rule,
}

/// A selector that was understood.
#[derive(Clone, Debug)]
pub(crate) struct Selector {
    pub(crate) rank: Rank,
    pub(crate) rules: RuleSet,
}

impl Selector {
    /// Reads a selector, upper and lower case alike; `None` when it means nothing.
    pub(crate) fn parse(text: &str) -> Option<Self> {
        let (rank, rules) = if text.eq_ignore_ascii_case(ALL) {
            (Rank::All, RuleSet::of(|_| true))
        } else if let Some(group) = group(text) {
            (Rank::Group, RuleSet::of(|doc| doc.group == group))
        } else if RULES.iter().any(|rule| rule.doc.code.id.eq_ignore_ascii_case(text)) {
            (Rank::Rule, RuleSet::of(|doc| doc.code.id.eq_ignore_ascii_case(text)))
        } else if starts_with(text, CODE_PREFIX) {
            (Rank::Prefix(text.len()), RuleSet::of(|doc| starts_with(doc.code.id, text)))
        } else {
            (Rank::Rule, RuleSet::of(|doc| doc.code.name.eq_ignore_ascii_case(text)))
        };
        // A group may be empty in this version.
        (!rules.is_empty() || rank == Rank::Group).then_some(Self { rank, rules })
    }
}

fn starts_with(text: &str, start: &str) -> bool {
    text.get(..start.len()).is_some_and(|head| head.eq_ignore_ascii_case(start))
}

fn group(text: &str) -> Option<Group> {
    Group::ALL.into_iter().find(|group| group.as_str().eq_ignore_ascii_case(text))
}

/// What an unknown selector was probably meant to be.
pub(crate) fn near(text: &str) -> Option<&'static str> {
    let docs = || RULES.iter().map(|rule| &rule.doc);
    let (lower, upper) = (text.to_ascii_lowercase().replace('_', "-"), text.to_ascii_uppercase());
    let names = docs().map(|doc| doc.code.name).chain(Group::ALL.iter().map(|group| group.as_str()));
    let same = names.clone().find(|name| *name == lower);
    same.or_else(|| nearest(&lower, names)).or_else(|| nearest(&upper, docs().map(|doc| doc.code.id).chain([ALL])))
}

/// A set of rules, by their places in the registry.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct RuleSet([u64; RuleSet::WORDS]);

impl RuleSet {
    const WORDS: usize = 4;

    /// The rules with some property.
    pub(crate) fn of(has: impl Fn(&RuleDoc) -> bool) -> Self {
        let mut set = Self::default();
        for (place, rule) in RULES.iter().enumerate() {
            if has(&rule.doc) {
                set.insert(place);
            }
        }
        set
    }

    pub(crate) fn is_empty(self) -> bool {
        self == Self::default()
    }

    pub(crate) fn contains(self, place: usize) -> bool {
        self.0.get(place / 64).is_some_and(|word| word >> (place % 64) & 1 == 1)
    }

    pub(crate) fn insert(&mut self, place: usize) {
        if let Some(word) = self.0.get_mut(place / 64) {
            *word |= 1 << (place % 64);
        }
    }

    pub(crate) fn add(&mut self, other: Self) {
        self.0.iter_mut().zip(other.0).for_each(|(word, other)| *word |= other);
    }

    pub(crate) fn remove(&mut self, other: Self) {
        self.0.iter_mut().zip(other.0).for_each(|(word, other)| *word &= !other);
    }
}

const _: () = assert!(RULES.len() <= RuleSet::WORDS * 64, "a set of rules has a bit for each");

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_selector_means_rules_and_has_a_rank() {
        let read = |text: &str| {
            let selector = Selector::parse(text)?;
            let codes = RULES.iter().enumerate().filter(|(place, _)| selector.rules.contains(*place));
            Some((selector.rank, codes.map(|(_, rule)| rule.doc.code.id).collect::<Vec<_>>()))
        };
        assert_eq!(read("acr101"), Some((Rank::Rule, vec!["ACR101"])));
        assert_eq!(read("undefined-label"), Some((Rank::Rule, vec!["ACR021", "ACR101"])));
        assert_eq!(read("ACR10").map(|found| found.0), Some(Rank::Prefix(5)));
        assert_eq!(read("Flow").map(|found| found.0), Some(Rank::Group));
        assert_eq!(read("all").map(|found| found.1.len()), Some(RULES.len()));
        for unknown in ["", "ACR9999", "ACR1x", "flows", "undefined label", "*", "\u{e4}"] {
            assert_eq!(read(unknown), None, "{unknown}");
        }
    }

    #[test]
    fn a_slip_is_recognised() {
        assert_eq!(near("undefined_label"), Some("undefined-label"));
        assert_eq!(near("undefned-label"), Some("undefined-label"));
        assert_eq!(near("flwo"), Some("flow"));
        assert_eq!(near("ARC101"), Some("ACR101"));
        assert_eq!(near("everything"), None);
    }
}
