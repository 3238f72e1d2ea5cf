//! Whatever a name, a text, a message and the places in it are, each form stays readable and has every finding.

use std::collections::HashSet;

use acrc_diagnostics::{
    Applicability, Code, Diagnostic, Edit, FileReport, Fix, SourceFile, Span, checkstyle, concise, github, gitlab,
    json, jsonl, junit,
};
use proptest::prelude::*;
use serde_json::Value;

use crate::ci::elements;
use crate::sample::{BLOCK, LABEL, VALUE, written};
use crate::sarif;

/// Texts rich in what the formats and the line index treat in a special way.
const TEXT: &str = "([ -~]|[\\x00-\\x1F\\x7F-\\u{9F}]|[\r\n\t<>&%:,\"'{}\\[\\]()\\\\/#]|[é軸😀\u{2028}\u{202E}\u{FEFF}\u{FFFE}\u{FFFF}]){0,12}";

fn code() -> impl Strategy<Value = Code> {
    prop::sample::select(vec![LABEL, VALUE, BLOCK])
}

fn span() -> impl Strategy<Value = Span> {
    (0u32..40, 0u32..20).prop_map(|(start, length)| Span::new(start, start + length))
}

fn fix() -> impl Strategy<Value = Fix> {
    let applicability =
        prop::sample::select(vec![Applicability::Safe, Applicability::Unsafe, Applicability::DisplayOnly]);
    let edit = (span(), TEXT).prop_map(|(span, text)| Edit::replace(span, text));
    (applicability, TEXT, prop::collection::vec(edit, 0..3))
        .prop_map(|(applicability, title, edits)| Fix::new(applicability, title, edits))
}

fn diagnostic() -> impl Strategy<Value = Diagnostic> {
    let texts = (TEXT, prop::option::of(TEXT), prop::option::of(TEXT), prop::option::of(TEXT));
    let others = (prop::collection::vec((span(), TEXT), 0..3), prop::collection::vec(fix(), 0..3), any::<bool>());
    (code(), span(), texts, others).prop_map(|(code, span, (message, label, help, note), (related, fixes, open))| {
        let mut diagnostic = Diagnostic::error(code, span, message);
        diagnostic = related.into_iter().fold(diagnostic, |found, (span, text)| found.with_related(span, text));
        diagnostic.label = label;
        diagnostic.help = help;
        diagnostic.note = note;
        // Each fix twice: forms that want them to differ have to see to it.
        diagnostic.fixes = fixes.iter().chain(&fixes).cloned().collect();
        if open { diagnostic.unconfirmed() } else { diagnostic }
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]
    #[test]
    fn every_form_is_readable(
        name in TEXT,
        text in TEXT,
        findings in prop::collection::vec(diagnostic(), 0..4),
    ) {
        let reports = [
            FileReport::new(SourceFile::new(&name, &text), &findings),
            FileReport::new(SourceFile::new("Clean.8K", ""), []),
        ];
        let count = findings.len();

        let document: Value = serde_json::from_str(&written(|out| json::render(&reports, &[], out))).expect("JSON");
        prop_assert_eq!(document["diagnostics"].as_array().map(Vec::len), Some(count));

        let lines = written(|out| jsonl::render(&reports, &[], out));
        prop_assert_eq!(lines.lines().count(), count);
        for line in lines.lines() {
            serde_json::from_str::<Value>(line).expect("JSON");
        }

        let log: Value = serde_json::from_str(&sarif::rendered(&reports)).expect("JSON");
        prop_assert_eq!(log["runs"][0]["results"].as_array().map(Vec::len), Some(count));

        let issues: Value = serde_json::from_str(&written(|out| gitlab::render(&reports, &[], out))).expect("JSON");
        let issues = issues.as_array().expect("an array");
        let fingerprints: HashSet<_> = issues.iter().map(|issue| issue["fingerprint"].as_str()).collect();
        prop_assert_eq!((issues.len(), fingerprints.len()), (count, count));

        let commands = written(|out| github::render(&reports, &[], out));
        prop_assert_eq!(commands.lines().filter(|line| line.starts_with("::")).count(), count);
        prop_assert_eq!(commands.lines().count(), count);

        let cases = if count == 0 { 1 } else { 2 * count };
        prop_assert_eq!(elements(&written(|out| junit::render(&reports, &[], out))), 1 + 2 + 1 + cases);
        prop_assert_eq!(elements(&written(|out| checkstyle::render(&reports, &[], out))), 1 + 2 + count);

        written(|out| concise::render(&reports, out));
    }
}
