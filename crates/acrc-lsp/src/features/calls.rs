//! Who calls whom.

use acrc_ide::{Calls, FilePosition, Routine};
use tower_lsp_server::ls_types::{
    CallHierarchyIncomingCall, CallHierarchyIncomingCallsParams, CallHierarchyItem, CallHierarchyOutgoingCall,
    CallHierarchyOutgoingCallsParams, CallHierarchyPrepareParams, Range, SymbolKind, TextDocumentIdentifier,
    TextDocumentPositionParams,
};

use super::Answer;
use crate::snapshot::Snapshot;

pub(crate) fn prepare(snapshot: &Snapshot, params: &CallHierarchyPrepareParams) -> Answer<Vec<CallHierarchyItem>> {
    let (position, _) = snapshot.position(&params.text_document_position_params)?;
    let routine = acrc_ide::routine_at(&snapshot.db, position);
    routine.and_then(|routine| item(snapshot, routine)).map(|item| vec![item])
}

pub(crate) fn incoming(
    snapshot: &Snapshot,
    params: &CallHierarchyIncomingCallsParams,
) -> Answer<Vec<CallHierarchyIncomingCall>> {
    let position = position_of(snapshot, &params.item)?;
    let call = |calls: Calls| {
        let from_ranges = ranges(snapshot, calls.routine.target.file, &calls);
        Some(CallHierarchyIncomingCall { from: item(snapshot, calls.routine)?, from_ranges })
    };
    Some(acrc_ide::incoming_calls(&snapshot.db, position).into_iter().filter_map(call).collect())
}

pub(crate) fn outgoing(
    snapshot: &Snapshot,
    params: &CallHierarchyOutgoingCallsParams,
) -> Answer<Vec<CallHierarchyOutgoingCall>> {
    let position = position_of(snapshot, &params.item)?;
    let call = |calls: Calls| {
        let from_ranges = ranges(snapshot, position.file, &calls);
        Some(CallHierarchyOutgoingCall { to: item(snapshot, calls.routine)?, from_ranges })
    };
    Some(acrc_ide::outgoing_calls(&snapshot.db, position).into_iter().filter_map(call).collect())
}

fn ranges(snapshot: &Snapshot, file: acrc_analysis::SourceFile, calls: &Calls) -> Vec<Range> {
    let lines = snapshot.lines(file);
    calls.places.iter().map(|place| lines.range(*place)).collect()
}

fn position_of(snapshot: &Snapshot, item: &CallHierarchyItem) -> Option<FilePosition> {
    let document = TextDocumentIdentifier { uri: item.uri.clone() };
    let at = TextDocumentPositionParams { text_document: document, position: item.selection_range.start };
    snapshot.position(&at).map(|(position, _)| position)
}

fn item(snapshot: &Snapshot, routine: Routine) -> Option<CallHierarchyItem> {
    let lines = snapshot.lines(routine.target.file);
    Some(CallHierarchyItem {
        name: routine.name,
        kind: if routine.is_main { SymbolKind::MODULE } else { SymbolKind::FUNCTION },
        tags: None,
        detail: Some(routine.program),
        uri: snapshot.uri(routine.target.file)?,
        range: lines.range(routine.target.whole),
        selection_range: lines.range(routine.target.name),
        data: None,
    })
}
