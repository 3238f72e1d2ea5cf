//! Renders files with several threads and writes them in their order.

use std::io::{self, Write};
use std::num::NonZeroUsize;
use std::thread;

use crate::FileReport;

/// Findings that are worth the threads, and about as many as are held as text at a time for each of them.
const BATCH: usize = 512;

/// Writes what `render` makes of each file.
pub(super) fn in_order(
    mut reports: &[FileReport<'_>],
    out: &mut dyn Write,
    render: impl Fn(&FileReport<'_>, &mut Vec<u8>) -> io::Result<()> + Sync,
) -> io::Result<()> {
    let pages = |batch: &[FileReport<'_>]| -> io::Result<Vec<u8>> {
        let mut page = Vec::new();
        batch.iter().try_for_each(|report| render(report, &mut page))?;
        Ok(page)
    };
    let threads = thread::available_parallelism().map_or(1, NonZeroUsize::get);
    while !reports.is_empty() {
        let mut batches = Vec::with_capacity(threads);
        while batches.len() < threads && !reports.is_empty() {
            let (batch, rest) = reports.split_at(batch_length(reports));
            batches.push(batch);
            reports = rest;
        }
        if let [only] = batches[..] {
            out.write_all(&pages(only)?)?;
            continue;
        }
        let rendered: Vec<_> = thread::scope(|scope| {
            let running: Vec<_> = batches.iter().map(|batch| scope.spawn(|| pages(batch))).collect();
            running.into_iter().map(thread::ScopedJoinHandle::join).collect()
        });
        for page in rendered {
            let page = page.unwrap_or_else(|panic| std::panic::resume_unwind(panic))?;
            out.write_all(&page)?;
        }
    }
    Ok(())
}

/// How many of the first files have a batch of findings together.
fn batch_length(reports: &[FileReport<'_>]) -> usize {
    let mut findings = 0;
    let is_full = |report: &FileReport<'_>| {
        findings += report.diagnostics().len();
        findings >= BATCH
    };
    reports.iter().position(is_full).map_or(reports.len(), |last| last + 1)
}
