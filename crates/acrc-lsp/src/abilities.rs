//! What the client can do, as far as anything here depends on it.

use tower_lsp_server::ls_types::{ClientCapabilities, MarkupKind};

use crate::lines::Encoding;

/// What the client can do.
#[expect(clippy::struct_excessive_bools, reason = "each is a capability of the protocol")]
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Abilities {
    pub(crate) encoding: Encoding,
    /// It asks for diagnostics, so that they need not be sent.
    pub(crate) pulls_diagnostics: bool,
    pub(crate) related_documents: bool,
    pub(crate) refreshes_diagnostics: bool,
    pub(crate) related_information: bool,
    pub(crate) diagnostic_tags: bool,
    pub(crate) code_description: bool,
    pub(crate) diagnostic_data: bool,
    pub(crate) registers_watchers: bool,
    pub(crate) registers_configuration: bool,
    pub(crate) has_configuration: bool,
    pub(crate) shows_progress: bool,
    pub(crate) hover_markdown: bool,
    pub(crate) completion_markdown: bool,
    pub(crate) signature_markdown: bool,
    pub(crate) snippets: bool,
    pub(crate) nested_symbols: bool,
    pub(crate) location_links: bool,
    pub(crate) code_action_literals: bool,
    pub(crate) document_changes: bool,
    pub(crate) refreshes_lenses: bool,
    pub(crate) refreshes_hints: bool,
    pub(crate) folds_lines_only: bool,
    pub(crate) prepares_rename: bool,
    pub(crate) shows_documents: bool,
}

impl Abilities {
    pub(crate) fn of(client: &ClientCapabilities) -> Self {
        let general = client.general.as_ref();
        let mut abilities = Self {
            encoding: Encoding::negotiate(general.and_then(|general| general.position_encodings.as_deref())),
            ..Self::default()
        };
        abilities.read_window(client);
        abilities.read_workspace(client);
        abilities.read_text(client);
        abilities
    }

    fn read_window(&mut self, client: &ClientCapabilities) {
        let Some(window) = &client.window else { return };
        self.shows_progress = window.work_done_progress == Some(true);
        self.shows_documents = window.show_document.as_ref().is_some_and(|show| show.support);
    }

    fn read_workspace(&mut self, client: &ClientCapabilities) {
        let Some(workspace) = &client.workspace else { return };
        let registers = |dynamic: Option<bool>| dynamic == Some(true);
        self.registers_watchers =
            workspace.did_change_watched_files.is_some_and(|watch| registers(watch.dynamic_registration));
        self.registers_configuration =
            workspace.did_change_configuration.is_some_and(|change| registers(change.dynamic_registration));
        self.has_configuration = workspace.configuration == Some(true);
        self.document_changes =
            workspace.workspace_edit.as_ref().is_some_and(|edit| edit.document_changes == Some(true));
        self.refreshes_diagnostics =
            workspace.diagnostics.as_ref().is_some_and(|refresh| refresh.refresh_support == Some(true));
        self.refreshes_lenses =
            workspace.code_lens.as_ref().is_some_and(|refresh| refresh.refresh_support == Some(true));
        self.refreshes_hints =
            workspace.inlay_hint.as_ref().is_some_and(|refresh| refresh.refresh_support == Some(true));
    }

    fn read_text(&mut self, client: &ClientCapabilities) {
        let Some(text) = &client.text_document else { return };
        let markdown =
            |kinds: Option<&Vec<MarkupKind>>| kinds.is_some_and(|kinds| kinds.contains(&MarkupKind::Markdown));
        if let Some(publish) = &text.publish_diagnostics {
            self.related_information = publish.related_information == Some(true);
            self.diagnostic_tags = publish.tag_support.is_some();
            self.code_description = publish.code_description_support == Some(true);
            self.diagnostic_data = publish.data_support == Some(true);
        }
        if let Some(pull) = &text.diagnostic {
            self.pulls_diagnostics = true;
            self.related_documents = pull.related_document_support == Some(true);
        }
        self.hover_markdown = markdown(text.hover.as_ref().and_then(|hover| hover.content_format.as_ref()));
        if let Some(item) = text.completion.as_ref().and_then(|completion| completion.completion_item.as_ref()) {
            self.snippets = item.snippet_support == Some(true);
            self.completion_markdown = markdown(item.documentation_format.as_ref());
        }
        let signature = text.signature_help.as_ref().and_then(|help| help.signature_information.as_ref());
        self.signature_markdown = markdown(signature.and_then(|signature| signature.documentation_format.as_ref()));
        self.nested_symbols = text
            .document_symbol
            .as_ref()
            .is_some_and(|symbol| symbol.hierarchical_document_symbol_support == Some(true));
        self.location_links = text.definition.is_some_and(|definition| definition.link_support == Some(true));
        self.code_action_literals =
            text.code_action.as_ref().is_some_and(|action| action.code_action_literal_support.is_some());
        self.folds_lines_only = text.folding_range.as_ref().is_some_and(|fold| fold.line_folding_only == Some(true));
        self.prepares_rename = text.rename.as_ref().is_some_and(|rename| rename.prepare_support == Some(true));
    }
}
