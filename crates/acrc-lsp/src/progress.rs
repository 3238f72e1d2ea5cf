//! Work that takes a while, shown by the client if it can.

use tokio::sync::mpsc::{UnboundedReceiver, UnboundedSender, unbounded_channel};
use tower_lsp_server::Client;
use tower_lsp_server::ls_types::ProgressToken;

use crate::outgoing::Outgoing;

/// Shows how far something is until it is dropped.
pub(crate) struct Progress(Option<UnboundedSender<(usize, usize)>>);

impl Progress {
    /// Begins to show, when the client can.
    pub(crate) fn begin(outgoing: &Outgoing, shows: bool, title: &'static str) -> Self {
        if !shows {
            return Self(None);
        }
        let (sender, receiver) = unbounded_channel();
        outgoing.converse(move |client| show(client, title, receiver));
        Self(Some(sender))
    }

    pub(crate) fn report(&self, done: usize, all: usize) {
        if let Some(sender) = &self.0 {
            // A client that shows nothing need not be told.
            let _ = sender.send((done, all));
        }
    }
}

async fn show(client: Client, title: &'static str, mut reports: UnboundedReceiver<(usize, usize)>) {
    let token = ProgressToken::String(format!("acrc/{}", client.next_request_id()));
    if client.create_work_done_progress(token.clone()).await.is_err() {
        return;
    }
    let progress = client.progress(token, title).with_percentage(0).begin().await;
    while let Some((done, all)) = reports.recv().await {
        let percent = (done * 100).checked_div(all).unwrap_or(100).min(100) as u32;
        progress.report_with_message(format!("{done}/{all}"), percent).await;
    }
    progress.finish().await;
}
