//! What showing a finding costs in a large file: 1,000 findings in 3 MB, in every form. Divide by 1,000. A difference has
//! 1,000 changed lines.

use std::hint::black_box;
use std::io::{self, Write};

use acrc_diagnostics::text::{self, Options};
use acrc_diagnostics::{
    Code, Diagnostic, FileReport, LineIndex, SourceFile, Span, checkstyle, concise, github, gitlab, json, jsonl, junit,
    sarif, unified_diff,
};
use criterion::{Criterion, criterion_group, criterion_main};

const SIZE: usize = 3_000_000;
const FINDINGS: usize = 1_000;
const UNDEFINED: Code = Code { id: "ACR101", name: "undefined-label" };
const LINE: &str = "IF (P1 > 100) THEN GOTO RETRACT\n";

type Render = fn(&[FileReport<'_>], &mut dyn Write) -> io::Result<()>;

const FORMATS: &[(&str, Render)] = &[
    ("concise", concise::render),
    ("json", |reports, out| json::render(reports, &[], out)),
    ("jsonl", |reports, out| jsonl::render(reports, &[], out)),
    ("sarif", |reports, out| sarif::render(reports, &[], &|_| None, out)),
    ("github", |reports, out| github::render(reports, &[], out)),
    ("gitlab", |reports, out| gitlab::render(reports, &[], out)),
    ("junit", |reports, out| junit::render(reports, &[], out)),
    ("checkstyle", |reports, out| checkstyle::render(reports, &[], out)),
];

/// A finding at a label that is not defined, at evenly spread lines.
fn findings() -> Vec<Diagnostic> {
    let spacing = SIZE / LINE.len() / FINDINGS;
    let label_column = LINE.find("RETRACT").unwrap_or_default();
    (0..FINDINGS)
        .map(|finding| {
            let start = finding * spacing * LINE.len() + label_column;
            let span = Span::from(start..start + "RETRACT".len());
            Diagnostic::error(UNDEFINED, span, "no line in program 0 has the label RETRACT")
                .with_label("not defined")
                .with_help("define the label, or go to one that is defined")
        })
        .collect()
}

fn render(criterion: &mut Criterion) {
    let source = LINE.repeat(SIZE / LINE.len());
    let findings = findings();
    // The index is built before, as it is in a tool that reports a place for anything else.
    let report = || {
        let file = SourceFile::new("Prog0.8K", &source);
        file.index();
        [FileReport::new(file, &findings)]
    };
    let reports = report();
    let mut out = Vec::new();

    let mut group = criterion.benchmark_group("render");
    for (name, color) in [("text", false), ("text_color", true)] {
        let options = Options { color, context: 0 };
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                out.clear();
                text::render(black_box(&reports), options, &mut out)
            });
        });
    }
    for &(name, render) in FORMATS {
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                out.clear();
                render(black_box(&reports), &mut out)
            });
        });
    }
    group.finish();

    let changed = source.replacen("100", "200", FINDINGS);
    criterion.bench_function("unified_diff", |bencher| {
        bencher.iter(|| {
            out.clear();
            unified_diff("Prog0.8K", black_box(&source), &changed, false, &mut out)
        });
    });
    criterion.bench_function("line_index", |bencher| {
        bencher.iter(|| LineIndex::new(black_box(&source)));
    });
}

criterion_group!(benches, render);
criterion_main!(benches);
