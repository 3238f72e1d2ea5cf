//! What the server offers.

use tower_lsp_server::ls_types::{
    CallHierarchyServerCapability, CodeActionOptions, CodeActionProviderCapability, CodeLensOptions, CompletionOptions,
    DiagnosticOptions, DiagnosticServerCapabilities, DocumentLinkOptions, DocumentOnTypeFormattingOptions,
    ExecuteCommandOptions, FoldingRangeProviderCapability, HoverProviderCapability, InitializeResult, OneOf,
    RenameOptions, SaveOptions, SelectionRangeProviderCapability, SemanticTokensFullOptions, SemanticTokensOptions,
    ServerCapabilities, ServerInfo, SignatureHelpOptions, TextDocumentSyncCapability, TextDocumentSyncKind,
    TextDocumentSyncOptions, TextDocumentSyncSaveOptions, WorkDoneProgressOptions, WorkspaceFoldersServerCapabilities,
    WorkspaceServerCapabilities,
};

use crate::abilities::Abilities;
use crate::{commands, features};

/// The answer to `initialize`.
pub(crate) fn offer(abilities: Abilities) -> InitializeResult {
    InitializeResult {
        capabilities: capabilities(abilities),
        server_info: Some(ServerInfo { name: "acrc".to_owned(), version: Some(env!("CARGO_PKG_VERSION").to_owned()) }),
        ..InitializeResult::default()
    }
}

fn capabilities(abilities: Abilities) -> ServerCapabilities {
    ServerCapabilities {
        position_encoding: Some(abilities.encoding.kind()),
        text_document_sync: Some(sync()),
        workspace: Some(workspace()),
        completion_provider: Some(completion()),
        hover_provider: Some(HoverProviderCapability::Simple(true)),
        signature_help_provider: Some(signature()),
        definition_provider: Some(yes()),
        references_provider: Some(yes()),
        document_highlight_provider: Some(yes()),
        document_symbol_provider: Some(yes()),
        workspace_symbol_provider: Some(yes()),
        call_hierarchy_provider: Some(CallHierarchyServerCapability::Simple(true)),
        folding_range_provider: Some(FoldingRangeProviderCapability::Simple(true)),
        selection_range_provider: Some(SelectionRangeProviderCapability::Simple(true)),
        semantic_tokens_provider: Some(tokens().into()),
        code_action_provider: abilities.code_action_literals.then(actions),
        rename_provider: Some(rename(abilities)),
        document_formatting_provider: Some(yes()),
        document_range_formatting_provider: Some(yes()),
        document_on_type_formatting_provider: on_type(),
        document_link_provider: Some(DocumentLinkOptions {
            resolve_provider: Some(false),
            work_done_progress_options: WorkDoneProgressOptions::default(),
        }),
        inlay_hint_provider: Some(yes()),
        code_lens_provider: Some(CodeLensOptions { resolve_provider: Some(false) }),
        inline_value_provider: Some(yes()),
        execute_command_provider: Some(ExecuteCommandOptions {
            commands: commands::ALL.map(str::to_owned).to_vec(),
            work_done_progress_options: WorkDoneProgressOptions { work_done_progress: Some(true) },
        }),
        diagnostic_provider: abilities.pulls_diagnostics.then(diagnostics),
        ..ServerCapabilities::default()
    }
}

fn sync() -> TextDocumentSyncCapability {
    TextDocumentSyncCapability::Options(TextDocumentSyncOptions {
        open_close: Some(true),
        change: Some(TextDocumentSyncKind::INCREMENTAL),
        save: Some(TextDocumentSyncSaveOptions::SaveOptions(SaveOptions { include_text: Some(false) })),
        ..TextDocumentSyncOptions::default()
    })
}

fn workspace() -> WorkspaceServerCapabilities {
    WorkspaceServerCapabilities {
        workspace_folders: Some(WorkspaceFoldersServerCapabilities {
            supported: Some(true),
            change_notifications: Some(OneOf::Left(true)),
        }),
        ..WorkspaceServerCapabilities::default()
    }
}

fn diagnostics() -> DiagnosticServerCapabilities {
    DiagnosticServerCapabilities::Options(DiagnosticOptions {
        identifier: Some("acrc".to_owned()),
        inter_file_dependencies: true,
        workspace_diagnostics: true,
        work_done_progress_options: WorkDoneProgressOptions::default(),
    })
}

/// What is offered without anything else to say.
fn yes<T>() -> OneOf<bool, T> {
    OneOf::Left(true)
}

fn completion() -> CompletionOptions {
    // A blank after `JOG` or `GOSUB` says as much as a letter.
    let characters = [" ", "_", "(", "#", "$"].map(str::to_owned).to_vec();
    CompletionOptions {
        resolve_provider: Some(true),
        trigger_characters: Some(characters),
        ..CompletionOptions::default()
    }
}

fn signature() -> SignatureHelpOptions {
    SignatureHelpOptions {
        trigger_characters: Some([" ", "(", ","].map(str::to_owned).to_vec()),
        retrigger_characters: Some(vec![")".to_owned()]),
        ..SignatureHelpOptions::default()
    }
}

fn tokens() -> SemanticTokensOptions {
    SemanticTokensOptions {
        legend: features::legend(),
        range: Some(true),
        full: Some(SemanticTokensFullOptions::Delta { delta: Some(true) }),
        ..SemanticTokensOptions::default()
    }
}

fn actions() -> CodeActionProviderCapability {
    CodeActionProviderCapability::Options(CodeActionOptions {
        code_action_kinds: Some(features::KINDS.to_vec()),
        ..CodeActionOptions::default()
    })
}

fn rename(abilities: Abilities) -> OneOf<bool, RenameOptions> {
    let work_done_progress_options = WorkDoneProgressOptions::default();
    if abilities.prepares_rename {
        OneOf::Right(RenameOptions { prepare_provider: Some(true), work_done_progress_options })
    } else {
        OneOf::Left(true)
    }
}

fn on_type() -> Option<DocumentOnTypeFormattingOptions> {
    let mut characters = acrc_ide::TYPED.iter().map(char::to_string);
    Some(DocumentOnTypeFormattingOptions {
        first_trigger_character: characters.next()?,
        more_trigger_character: Some(characters.collect()),
    })
}
