//! The messages of the protocol. A handler queues its work before its first await, and waits for the answer.

use std::sync::Arc;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};

use camino::Utf8PathBuf;
use serde_json::json;
use tokio::sync::oneshot;
use tower_lsp_server::jsonrpc::{Error, Result};
use tower_lsp_server::ls_types::{
    CallHierarchyIncomingCall, CallHierarchyIncomingCallsParams, CallHierarchyItem, CallHierarchyOutgoingCall,
    CallHierarchyOutgoingCallsParams, CallHierarchyPrepareParams, CodeActionParams, CodeActionResponse, CodeLens,
    CodeLensParams, CompletionItem, CompletionParams, CompletionResponse, ConfigurationItem,
    DidChangeConfigurationParams, DidChangeTextDocumentParams, DidChangeWatchedFilesParams,
    DidChangeWorkspaceFoldersParams, DidCloseTextDocumentParams, DidOpenTextDocumentParams, DidSaveTextDocumentParams,
    DocumentDiagnosticParams, DocumentDiagnosticReportResult, DocumentFormattingParams, DocumentHighlight,
    DocumentHighlightParams, DocumentLink, DocumentLinkParams, DocumentOnTypeFormattingParams,
    DocumentRangeFormattingParams, DocumentSymbolParams, DocumentSymbolResponse, ExecuteCommandParams, FileChangeType,
    FileEvent, FoldingRange, FoldingRangeParams, GotoDefinitionParams, GotoDefinitionResponse, Hover, HoverParams,
    InitializeParams, InitializeResult, InitializedParams, InlayHint, InlayHintParams, InlineValue, InlineValueParams,
    LSPAny, Location, PrepareRenameResponse, ReferenceParams, Registration, RenameParams, SelectionRange,
    SelectionRangeParams, SemanticTokensDeltaParams, SemanticTokensFullDeltaResult, SemanticTokensParams,
    SemanticTokensRangeParams, SemanticTokensRangeResult, SemanticTokensResult, SignatureHelp, SignatureHelpParams,
    TextDocumentPositionParams, TextEdit, WorkspaceDiagnosticParams, WorkspaceDiagnosticReportResult, WorkspaceEdit,
    WorkspaceSymbolParams, WorkspaceSymbolResponse,
};
use tower_lsp_server::{Client, LanguageServer};

use crate::abilities::Abilities;
use crate::commands::{self, Outcomes, Target};
use crate::features::{self, Tokens};
use crate::outgoing::Outgoing;
use crate::queue::{Queue, Task};
use crate::settings::Settings;
use crate::snapshot::Snapshot;
use crate::uri::path_of;
use crate::workspace::real;
use crate::{capabilities, diagnostics};

/// Takes messages.
pub(crate) struct Server {
    queue: Queue,
    outgoing: Outgoing,
    abilities: OnceLock<Abilities>,
    tokens: Tokens,
    outcomes: Outcomes,
    client: Client,
    /// The client asked for the end, so that the process ends well.
    pub(crate) asked_to_end: Arc<AtomicBool>,
}

impl Server {
    pub(crate) fn new(
        client: Client,
        queue: Queue,
        outgoing: Outgoing,
        outcomes: Outcomes,
        asked_to_end: Arc<AtomicBool>,
    ) -> Self {
        Self { queue, outgoing, abilities: OnceLock::new(), tokens: Tokens::default(), outcomes, client, asked_to_end }
    }

    fn abilities(&self) -> Abilities {
        self.abilities.get().copied().unwrap_or_default()
    }

    /// Queues a question that nothing can be wrong with.
    fn read<T: Send + 'static>(
        &self,
        question: impl FnOnce(&Snapshot) -> T + Send + 'static,
    ) -> impl Future<Output = Result<T>> + Send {
        self.queue.ask(move |snapshot| Ok(question(snapshot)))
    }

    /// Asks the client for its settings.
    fn fetch_settings(&self) {
        let queue = self.queue.clone();
        self.outgoing.converse(|client: Client| async move {
            let item = ConfigurationItem { scope_uri: None, section: Some("acrc".to_owned()) };
            if let Ok(values) = client.configuration(vec![item]).await {
                queue.send(Task::Settings(Settings::of(values.first())));
            }
        });
    }

    /// Asks to be told what this server can't see by itself.
    fn register(&self) {
        let abilities = self.abilities();
        let registration = |method: &str, options| Registration {
            id: method.to_owned(),
            method: method.to_owned(),
            register_options: options,
        };
        let mut wanted = Vec::new();
        if abilities.registers_watchers {
            let watchers =
                json!({ "watchers": [{ "globPattern": "**/*.[8][kK]" }, { "globPattern": "**/acrc.toml" }] });
            wanted.push(registration("workspace/didChangeWatchedFiles", Some(watchers)));
        }
        if abilities.registers_configuration {
            wanted.push(registration("workspace/didChangeConfiguration", Some(json!({ "section": "acrc" }))));
        }
        if !wanted.is_empty() {
            self.outgoing.converse(|client: Client| async move {
                // A client that refuses goes on without.
                let _ = client.register_capability(wanted).await;
            });
        }
    }
}

/// The folders that the client works in.
#[expect(deprecated, reason = "older clients name one folder only")]
fn roots(params: &InitializeParams) -> Vec<Utf8PathBuf> {
    let folders = params.workspace_folders.iter().flatten().map(|folder| &folder.uri);
    let mut roots: Vec<Utf8PathBuf> = folders.map(|uri| real(&path_of(uri))).collect();
    if params.workspace_folders.is_none() {
        roots.extend(params.root_uri.as_ref().map(|uri| real(&path_of(uri))));
    }
    roots.retain(|root| root.is_absolute());
    roots
}

impl LanguageServer for Server {
    async fn initialize(&self, params: InitializeParams) -> Result<InitializeResult> {
        let abilities = *self.abilities.get_or_init(|| Abilities::of(&params.capabilities));
        let settings = Settings::of(params.initialization_options.as_ref());
        self.queue.send(Task::Begin(abilities, roots(&params), settings));
        Ok(capabilities::offer(abilities))
    }

    async fn initialized(&self, _: InitializedParams) {
        self.queue.send(Task::Ready);
        self.register();
        if self.abilities().has_configuration {
            self.fetch_settings();
        }
    }

    async fn shutdown(&self) -> Result<()> {
        self.asked_to_end.store(true, Ordering::SeqCst);
        Ok(())
    }

    async fn did_open(&self, params: DidOpenTextDocumentParams) {
        self.queue.send(Task::Open(params.text_document));
    }

    async fn did_change(&self, params: DidChangeTextDocumentParams) {
        self.queue.send(Task::Change(params));
    }

    async fn did_close(&self, params: DidCloseTextDocumentParams) {
        self.queue.send(Task::Close(params.text_document.uri));
    }

    async fn did_save(&self, params: DidSaveTextDocumentParams) {
        if !self.abilities().registers_watchers {
            // Nobody else says that the file is there now.
            let event = FileEvent { uri: params.text_document.uri, typ: FileChangeType::CHANGED };
            self.queue.send(Task::Watched(DidChangeWatchedFilesParams { changes: vec![event] }));
        }
    }

    async fn did_change_watched_files(&self, params: DidChangeWatchedFilesParams) {
        self.queue.send(Task::Watched(params));
    }

    async fn did_change_workspace_folders(&self, params: DidChangeWorkspaceFoldersParams) {
        self.queue.send(Task::Folders(params.event));
    }

    async fn did_change_configuration(&self, params: DidChangeConfigurationParams) {
        if self.abilities().has_configuration {
            self.fetch_settings();
        } else {
            self.queue.send(Task::Settings(Settings::of(Some(&params.settings))));
        }
    }

    async fn diagnostic(&self, params: DocumentDiagnosticParams) -> Result<DocumentDiagnosticReportResult> {
        let answer = self.read(move |snapshot| diagnostics::document(snapshot, &params));
        answer.await.map_err(diagnostics::overtaken)
    }

    async fn workspace_diagnostic(&self, params: WorkspaceDiagnosticParams) -> Result<WorkspaceDiagnosticReportResult> {
        let (sender, answer) = oneshot::channel();
        let mut sender = Some(sender);
        self.queue.send(Task::Watch(Box::new(move |snapshot| {
            if sender.as_ref().is_none_or(oneshot::Sender::is_closed) {
                return true;
            }
            let report = diagnostics::workspace(snapshot, &params);
            let told = report.map(|report| sender.take().map(|sender| sender.send(report)));
            told.is_some()
        })));
        answer.await.map(Into::into).map_err(|_| Error::internal_error())
    }

    async fn hover(&self, params: HoverParams) -> Result<Option<Hover>> {
        self.read(move |snapshot| features::hover(snapshot, &params)).await
    }

    async fn signature_help(&self, params: SignatureHelpParams) -> Result<Option<SignatureHelp>> {
        self.read(move |snapshot| features::signature(snapshot, &params)).await
    }

    async fn completion(&self, params: CompletionParams) -> Result<Option<CompletionResponse>> {
        self.read(move |snapshot| features::complete(snapshot, &params)).await
    }

    async fn goto_definition(&self, params: GotoDefinitionParams) -> Result<Option<GotoDefinitionResponse>> {
        self.read(move |snapshot| features::definition(snapshot, &params)).await
    }

    async fn references(&self, params: ReferenceParams) -> Result<Option<Vec<Location>>> {
        self.read(move |snapshot| features::references(snapshot, &params)).await
    }

    async fn document_highlight(&self, params: DocumentHighlightParams) -> Result<Option<Vec<DocumentHighlight>>> {
        self.read(move |snapshot| features::highlights(snapshot, &params)).await
    }

    async fn document_symbol(&self, params: DocumentSymbolParams) -> Result<Option<DocumentSymbolResponse>> {
        self.read(move |snapshot| features::of_document(snapshot, &params)).await
    }

    async fn symbol(&self, params: WorkspaceSymbolParams) -> Result<Option<WorkspaceSymbolResponse>> {
        self.read(move |snapshot| Some(features::of_workspace(snapshot, &params))).await
    }

    async fn prepare_call_hierarchy(
        &self,
        params: CallHierarchyPrepareParams,
    ) -> Result<Option<Vec<CallHierarchyItem>>> {
        self.read(move |snapshot| features::prepare_calls(snapshot, &params)).await
    }

    async fn incoming_calls(
        &self,
        params: CallHierarchyIncomingCallsParams,
    ) -> Result<Option<Vec<CallHierarchyIncomingCall>>> {
        self.read(move |snapshot| features::incoming(snapshot, &params)).await
    }

    async fn outgoing_calls(
        &self,
        params: CallHierarchyOutgoingCallsParams,
    ) -> Result<Option<Vec<CallHierarchyOutgoingCall>>> {
        self.read(move |snapshot| features::outgoing(snapshot, &params)).await
    }

    async fn folding_range(&self, params: FoldingRangeParams) -> Result<Option<Vec<FoldingRange>>> {
        self.read(move |snapshot| features::folds(snapshot, &params)).await
    }

    async fn selection_range(&self, params: SelectionRangeParams) -> Result<Option<Vec<SelectionRange>>> {
        self.read(move |snapshot| features::selections(snapshot, &params)).await
    }

    async fn semantic_tokens_range(
        &self,
        params: SemanticTokensRangeParams,
    ) -> Result<Option<SemanticTokensRangeResult>> {
        self.read(move |snapshot| features::tokens_in_range(snapshot, &params)).await
    }

    async fn completion_resolve(&self, item: CompletionItem) -> Result<CompletionItem> {
        self.read(move |snapshot| features::resolve_completion(snapshot, item)).await
    }

    async fn semantic_tokens_full(&self, params: SemanticTokensParams) -> Result<Option<SemanticTokensResult>> {
        let tokens = self.tokens.clone();
        self.read(move |snapshot| tokens.full(snapshot, &params)).await
    }

    async fn semantic_tokens_full_delta(
        &self,
        params: SemanticTokensDeltaParams,
    ) -> Result<Option<SemanticTokensFullDeltaResult>> {
        let tokens = self.tokens.clone();
        self.read(move |snapshot| tokens.delta(snapshot, &params)).await
    }

    async fn code_action(&self, params: CodeActionParams) -> Result<Option<CodeActionResponse>> {
        self.read(move |snapshot| features::actions(snapshot, &params)).await
    }

    async fn prepare_rename(&self, params: TextDocumentPositionParams) -> Result<Option<PrepareRenameResponse>> {
        self.queue.ask(move |snapshot| features::prepare_rename(snapshot, &params)).await
    }

    async fn rename(&self, params: RenameParams) -> Result<Option<WorkspaceEdit>> {
        self.queue.ask(move |snapshot| features::rename(snapshot, &params)).await
    }

    async fn inlay_hint(&self, params: InlayHintParams) -> Result<Option<Vec<InlayHint>>> {
        self.read(move |snapshot| features::hints(snapshot, &params)).await
    }

    async fn code_lens(&self, params: CodeLensParams) -> Result<Option<Vec<CodeLens>>> {
        let outcomes = self.outcomes.clone();
        self.read(move |snapshot| features::lenses(snapshot, &params, &outcomes)).await
    }

    async fn inline_value(&self, params: InlineValueParams) -> Result<Option<Vec<InlineValue>>> {
        let outcomes = self.outcomes.clone();
        self.read(move |snapshot| features::values(snapshot, &params, &outcomes)).await
    }

    async fn execute_command(&self, params: ExecuteCommandParams) -> Result<Option<LSPAny>> {
        let target = Arc::new(Target::of(&params)?);
        let asked = Arc::clone(&target);
        let plan = self.queue.ask(move |snapshot| asked.plan(snapshot)).await?;
        commands::execute(self.client.clone(), &self.outcomes, params, &target, plan).await
    }

    async fn formatting(&self, params: DocumentFormattingParams) -> Result<Option<Vec<TextEdit>>> {
        self.read(move |snapshot| features::format(snapshot, &params)).await
    }

    async fn range_formatting(&self, params: DocumentRangeFormattingParams) -> Result<Option<Vec<TextEdit>>> {
        self.read(move |snapshot| features::format_range(snapshot, &params)).await
    }

    async fn on_type_formatting(&self, params: DocumentOnTypeFormattingParams) -> Result<Option<Vec<TextEdit>>> {
        self.read(move |snapshot| features::format_typed(snapshot, &params)).await
    }

    async fn document_link(&self, params: DocumentLinkParams) -> Result<Option<Vec<DocumentLink>>> {
        self.read(move |snapshot| features::links(snapshot, &params)).await
    }
}
