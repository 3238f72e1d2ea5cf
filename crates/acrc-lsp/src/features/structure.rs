//! What can be folded, and what a growing selection takes in.

use acrc_diagnostics::Span;
use acrc_ide::FoldKind;
use tower_lsp_server::ls_types::{
    FoldingRange, FoldingRangeKind, FoldingRangeParams, SelectionRange, SelectionRangeParams,
};

use super::Answer;
use crate::snapshot::Snapshot;

pub(crate) fn folds(snapshot: &Snapshot, params: &FoldingRangeParams) -> Answer<Vec<FoldingRange>> {
    let place = snapshot.place(&params.text_document.uri)?;
    let lines = snapshot.lines(place.file);
    let whole_lines = snapshot.abilities.folds_lines_only;
    let folds = acrc_ide::folds(&snapshot.db, place.file).into_iter().map(|fold| {
        let range = lines.range(fold.span);
        FoldingRange {
            start_line: range.start.line,
            // The fold begins behind the text of its first line.
            start_character: None,
            end_line: range.end.line,
            end_character: (!whole_lines).then_some(range.end.character),
            kind: match fold.kind {
                FoldKind::Code => None,
                FoldKind::Comments => Some(FoldingRangeKind::Comment),
                FoldKind::Definitions => Some(FoldingRangeKind::Region),
            },
            collapsed_text: None,
        }
    });
    Some(folds.collect())
}

pub(crate) fn selections(snapshot: &Snapshot, params: &SelectionRangeParams) -> Answer<Vec<SelectionRange>> {
    let place = snapshot.place(&params.text_document.uri)?;
    let lines = snapshot.lines(place.file);
    let of_position = |position| {
        let spans = acrc_ide::selection_ranges(&snapshot.db, place.file, lines.offset(position));
        let nest = |inner: Option<Box<SelectionRange>>, span: &Span| {
            Some(Box::new(SelectionRange { range: lines.range(*span), parent: inner }))
        };
        let nested = spans.iter().rev().fold(None, nest);
        // Each position needs an answer.
        nested.map_or_else(|| SelectionRange { range: lines.range(Span::empty(0)), parent: None }, |nested| *nested)
    };
    Some(params.positions.iter().copied().map(of_position).collect())
}
