//! Places that lead somewhere: rules in comments, files in an `acrc.toml`.

use acrc_ide::{Link, LinkTarget};
use tower_lsp_server::ls_types::{DocumentLink, DocumentLinkParams, Uri};

use super::Answer;
use crate::lines::Lines;
use crate::snapshot::Snapshot;
use crate::uri::{path_of, uri_of};

pub(crate) fn links(snapshot: &Snapshot, params: &DocumentLinkParams) -> Answer<Vec<DocumentLink>> {
    let uri = &params.text_document.uri;
    if let Some(place) = snapshot.place(uri) {
        let lines = snapshot.lines(place.file);
        return Some(convert(snapshot, uri, &lines, acrc_ide::links(&snapshot.db, place.file)));
    }
    let path = snapshot.documents.by_uri.get(uri.as_str());
    let text = path.and_then(|path| snapshot.configs.get(path))?;
    let lines = Lines::new(text, snapshot.abilities.encoding);
    Some(convert(snapshot, uri, &lines, acrc_ide::project_links(text)))
}

fn convert(snapshot: &Snapshot, uri: &Uri, lines: &Lines, links: Vec<Link>) -> Vec<DocumentLink> {
    let target = |to: &LinkTarget| match to {
        LinkTarget::Rule(code) => snapshot.scratch.rule_page(code.id),
        LinkTarget::File(name) => uri_of(&path_of(uri).parent()?.join(name)),
    };
    let link = |link: Link| {
        Some(DocumentLink { range: lines.range(link.span), target: Some(target(&link.to)?), tooltip: None, data: None })
    };
    links.into_iter().filter_map(link).collect()
}
