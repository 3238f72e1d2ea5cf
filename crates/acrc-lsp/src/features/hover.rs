//! What is known of the thing at a place, and the form of what is being written.

use tower_lsp_server::ls_types::{
    Documentation, Hover, HoverContents, HoverParams, ParameterInformation, ParameterLabel, SignatureHelp,
    SignatureHelpParams, SignatureInformation,
};

use super::{Answer, markup};
use crate::snapshot::Snapshot;

pub(crate) fn hover(snapshot: &Snapshot, params: &HoverParams) -> Answer<Hover> {
    let (position, lines) = snapshot.position(&params.text_document_position_params)?;
    let found = acrc_ide::hover(&snapshot.db, position);
    found.map(|found| Hover {
        contents: HoverContents::Markup(markup(found.markdown, snapshot.abilities.hover_markdown)),
        range: Some(lines.range(found.span)),
    })
}

pub(crate) fn signature(snapshot: &Snapshot, params: &SignatureHelpParams) -> Answer<SignatureHelp> {
    let (position, _) = snapshot.position(&params.text_document_position_params)?;
    let help = acrc_ide::signature_help(&snapshot.db, position.file, position.offset)?;
    let shows_markdown = snapshot.abilities.signature_markdown;
    let documentation =
        |text: String| (!text.is_empty()).then(|| Documentation::MarkupContent(markup(text, shows_markdown)));
    let label = |range: std::ops::Range<u32>| {
        // Offsets in a label always count UTF-16 units.
        let units = |end: u32| help.label.get(..end as usize).map_or(0, |text| text.encode_utf16().count() as u32);
        ParameterLabel::LabelOffsets([units(range.start), units(range.end)])
    };
    let parameters = help.arguments.iter().map(|argument| ParameterInformation {
        label: argument.label.clone().map_or_else(|| ParameterLabel::Simple(String::new()), label),
        documentation: documentation(argument.facts.clone()),
    });
    let signature = SignatureInformation {
        parameters: Some(parameters.collect()),
        label: help.label.clone(),
        documentation: documentation(help.summary.clone()),
        active_parameter: help.active,
    };
    Some(SignatureHelp { signatures: vec![signature], active_signature: Some(0), active_parameter: help.active })
}
