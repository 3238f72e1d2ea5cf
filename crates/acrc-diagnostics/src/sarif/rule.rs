//! The rules of a report: what a viewer says about a kind of finding.

use std::borrow::Cow;
use std::collections::BTreeMap;

use serde::Serialize;

use super::level;
use crate::{Code, FileReport, Severity};

/// What is known of a rule besides its code.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RuleInfo {
    /// The severity of its findings unless one says otherwise.
    pub severity: Severity,
    /// What it finds, in one sentence.
    pub summary: Cow<'static, str>,
    /// What it finds and why that matters, as plain text.
    pub description: Cow<'static, str>,
    /// The page about it, as plain text.
    pub help: Cow<'static, str>,
    /// The same page in Markdown; no HTML.
    pub help_markdown: Option<Cow<'static, str>>,
    /// Words to group rules by; no word twice.
    pub tags: Vec<Cow<'static, str>>,
}

/// The rules that occur in a report, in the order of their codes.
pub(super) struct Rules {
    pub(super) list: Vec<RuleJson>,
    index: BTreeMap<Code, usize>,
}

impl Rules {
    pub(super) fn of(reports: &[FileReport<'_>], info: &dyn Fn(Code) -> Option<RuleInfo>) -> Self {
        let found = reports.iter().flat_map(FileReport::diagnostics);
        let mut index: BTreeMap<Code, usize> = found.map(|diagnostic| (diagnostic.code, 0)).collect();
        let mut list = Vec::with_capacity(index.len());
        for (code, place) in &mut index {
            *place = list.len();
            list.push(RuleJson::new(*code, info(*code)));
        }
        Self { list, index }
    }

    /// Where the rule stands in the list.
    pub(super) fn index(&self, code: Code) -> Option<usize> {
        self.index.get(&code).copied()
    }
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct RuleJson {
    id: &'static str,
    name: &'static str,
    short_description: Text,
    full_description: Text,
    help: Help,
    #[serde(skip_serializing_if = "Option::is_none")]
    default_configuration: Option<Configuration>,
    #[serde(skip_serializing_if = "Option::is_none")]
    properties: Option<Properties>,
}

impl RuleJson {
    /// A rule of which nothing is known is described by its name: viewers insist on a description.
    fn new(code: Code, info: Option<RuleInfo>) -> Self {
        let Code { id, name } = code;
        let Some(info) = info else {
            let text = || Text { text: Cow::Borrowed(name) };
            return Self {
                id,
                name,
                short_description: text(),
                full_description: text(),
                help: Help { text: Cow::Borrowed(name), markdown: None },
                default_configuration: None,
                properties: None,
            };
        };
        Self {
            id,
            name,
            short_description: Text { text: info.summary },
            full_description: Text { text: info.description },
            help: Help { text: info.help, markdown: info.help_markdown },
            default_configuration: Some(Configuration { level: level(info.severity) }),
            properties: Some(Properties { tags: info.tags }),
        }
    }
}

#[derive(Serialize)]
struct Text {
    text: Cow<'static, str>,
}

#[derive(Serialize)]
struct Help {
    text: Cow<'static, str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    markdown: Option<Cow<'static, str>>,
}

#[derive(Serialize)]
struct Configuration {
    level: &'static str,
}

#[derive(Serialize)]
struct Properties {
    tags: Vec<Cow<'static, str>>,
}
