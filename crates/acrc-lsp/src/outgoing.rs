//! What is sent to the client without being asked, in the order in which it is said, from any thread.

use std::future::Future;
use std::pin::Pin;

use tokio::sync::mpsc::{UnboundedReceiver, UnboundedSender, unbounded_channel};
use tower_lsp_server::Client;
use tower_lsp_server::ls_types::notification::{LogMessage, Notification, PublishDiagnostics};
use tower_lsp_server::ls_types::{Diagnostic, LogMessageParams, MessageType, PublishDiagnosticsParams, Uri};

/// Something to say.
type Saying = Box<dyn FnOnce(Client) -> Pin<Box<dyn Future<Output = ()> + Send>> + Send>;

/// The way to the client.
#[derive(Clone)]
pub(crate) struct Outgoing(UnboundedSender<Saying>);

impl Outgoing {
    pub(crate) fn new() -> (Self, Incoming) {
        let (sender, receiver) = unbounded_channel();
        (Self(sender), Incoming(receiver))
    }

    /// Sends a notification after all those before it.
    pub(crate) fn notify<N: Notification>(&self, params: N::Params)
    where
        N::Params: Send + 'static,
    {
        self.say(|client| async move { client.send_notification::<N>(params).await });
    }

    /// Begins a conversation of its own, which holds up nothing else.
    pub(crate) fn converse<F: Future<Output = ()> + Send + 'static>(
        &self,
        conversation: impl FnOnce(Client) -> F + Send + 'static,
    ) {
        self.say(move |client| {
            tokio::spawn(conversation(client));
            std::future::ready(())
        });
    }

    pub(crate) fn publish(&self, uri: Uri, diagnostics: Vec<Diagnostic>, version: Option<i32>) {
        self.notify::<PublishDiagnostics>(PublishDiagnosticsParams { uri, diagnostics, version });
    }

    /// Writes a line into the log of the client.
    pub(crate) fn log(&self, typ: MessageType, message: impl Into<String>) {
        self.notify::<LogMessage>(LogMessageParams { typ, message: message.into() });
    }

    fn say<F: Future<Output = ()> + Send + 'static>(&self, saying: impl FnOnce(Client) -> F + Send + 'static) {
        // Without a client there is nobody to tell.
        let _ = self.0.send(Box::new(|client| Box::pin(saying(client))));
    }
}

/// What is waiting to be said.
pub(crate) struct Incoming(UnboundedReceiver<Saying>);

impl Incoming {
    /// Says everything, one after the other.
    pub(crate) async fn say_to(mut self, client: Client) {
        while let Some(saying) = self.0.recv().await {
            saying(client.clone()).await;
        }
    }
}
