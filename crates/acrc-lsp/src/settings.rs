//! What a person sets in the editor, below `acrc`.

use serde::Deserialize;
use serde_json::Value;

/// The settings. A group that is missing or not understood is as if it were not set.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Settings {
    pub(crate) lint: Lint,
    pub(crate) inlay_hints: InlayHints,
    pub(crate) trace: Trace,
}

/// `acrc.lint`
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(default)]
pub(crate) struct Lint {
    /// Findings are shown.
    pub(crate) enable: bool,
}

/// `acrc.inlayHints`
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(crate) struct InlayHints {
    /// What raw bits and parameters are.
    pub(crate) operands: bool,
    /// How many bytes a program takes.
    pub(crate) program_bytes: bool,
    /// How many bytes a program has taken up to a line.
    pub(crate) line_bytes: bool,
}

/// `acrc.trace`
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(default)]
pub(crate) struct Trace {
    /// How long each answer took is written into the log.
    pub(crate) timing: bool,
}

impl Default for Lint {
    fn default() -> Self {
        Self { enable: true }
    }
}

impl Default for InlayHints {
    fn default() -> Self {
        Self { operands: true, program_bytes: true, line_bytes: false }
    }
}

impl Settings {
    /// Reads settings, which may stand below `acrc` or alone.
    pub(crate) fn of(value: Option<&Value>) -> Self {
        let Some(value) = value.map(|value| value.get("acrc").unwrap_or(value)) else { return Self::default() };
        Self { lint: group(value, "lint"), inlay_hints: group(value, "inlayHints"), trace: group(value, "trace") }
    }
}

/// A group of settings. A mistake in one leaves the others as they are.
fn group<'v, T: Default + Deserialize<'v>>(settings: &'v Value, name: &str) -> T {
    settings.get(name).and_then(|group| T::deserialize(group).ok()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn settings_may_stand_below_their_name() {
        for value in [json!({"acrc": {"lint": {"enable": false}}}), json!({"lint": {"enable": false}, "other": 1})] {
            assert!(!Settings::of(Some(&value)).lint.enable, "{value}");
        }
    }

    #[test]
    fn what_is_not_understood_is_not_set() {
        for value in [json!(null), json!(7), json!({"acrc": {"lint": 7}}), json!({"acrc": null})] {
            assert_eq!(Settings::of(Some(&value)), Settings::default(), "{value}");
        }
    }

    #[test]
    fn a_mistake_in_one_group_leaves_the_others() {
        let settings = Settings::of(Some(&json!({"lint": {"enable": "no"}, "inlayHints": {"lineBytes": true}})));
        assert!(settings.lint.enable && settings.inlay_hints.line_bytes);
    }
}
