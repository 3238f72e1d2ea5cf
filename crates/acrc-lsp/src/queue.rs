//! The one queue of everything that is to be done, in the order of arrival.

use std::future::Future;
use std::sync::Arc;
use std::sync::mpsc::{Sender, channel};

use acrc_analysis::Canceller;
use camino::Utf8PathBuf;
use parking_lot::Mutex;
use tokio::sync::oneshot;
use tower_lsp_server::jsonrpc::{Error, Result};
use tower_lsp_server::ls_types::{
    DidChangeTextDocumentParams, DidChangeWatchedFilesParams, TextDocumentItem, Uri, WorkspaceFoldersChangeEvent,
};

use crate::abilities::Abilities;
use crate::settings::Settings;
use crate::snapshot::Snapshot;

/// Something for the writer to do.
pub(crate) enum Task {
    /// The client introduced itself: what it can do, its folders, its settings.
    Begin(Abilities, Vec<Utf8PathBuf>, Settings),
    /// The client is ready: the folders may be searched.
    Ready,
    Open(TextDocumentItem),
    Change(DidChangeTextDocumentParams),
    Close(Uri),
    Watched(DidChangeWatchedFilesParams),
    Folders(WorkspaceFoldersChangeEvent),
    Settings(Settings),
    /// The search of the folders found these projects.
    Found(Vec<Utf8PathBuf>),
    /// A project of the search, to be loaded when there is time.
    Load(Utf8PathBuf),
    /// A question, with what answers it from a snapshot.
    Ask(Work),
    /// A question that is asked again after each change, until it has an answer.
    Watch(Watch),
    /// Such a question, which had no answer at this revision.
    Wait(Watch, u64),
    /// The findings of this revision were told.
    Told(u64),
    /// The session is over.
    Stop,
}

/// Answers one question from a snapshot, in some thread.
pub(crate) type Work = Box<dyn FnOnce(Snapshot) + Send>;

/// Answers from a snapshot if there is something to say, and tells whether it did.
pub(crate) type Watch = Box<dyn FnMut(&Snapshot) -> bool + Send>;

/// The sending side.
#[derive(Clone)]
pub(crate) struct Queue(Sender<Task>);

impl Queue {
    pub(crate) fn new() -> (Self, std::sync::mpsc::Receiver<Task>) {
        let (sender, receiver) = channel();
        (Self(sender), receiver)
    }

    pub(crate) fn send(&self, task: Task) {
        // After the end nobody takes tasks, and nobody waits for them.
        let _ = self.0.send(task);
    }

    /// Asks a question. It is queued now, not when the answer is awaited; who stops waiting ends the work on it.
    pub(crate) fn ask<T, W>(&self, work: W) -> impl Future<Output = Result<T>> + Send + use<T, W>
    where
        T: Send + 'static,
        W: FnOnce(&Snapshot) -> Result<T> + Send + 'static,
    {
        let (sender, receiver) = oneshot::channel();
        let interest = Arc::new(Mutex::new(Interest::Waiting));
        let guard = Guard(Arc::clone(&interest));
        self.send(Task::Ask(Box::new(move |snapshot| {
            if begin(&interest, &snapshot) {
                let _ = sender.send(snapshot.answer(work));
            }
        })));
        async move {
            let _guard = guard;
            receiver.await.unwrap_or_else(|_| Err(Error::request_cancelled()))
        }
    }
}

/// Whether somebody still waits for an answer.
enum Interest {
    /// Nobody works on it yet.
    Waiting,
    /// A thread works on it.
    Working(Canceller),
    Lost,
}

/// Marks the beginning of work, unless nobody waits for it.
fn begin(interest: &Mutex<Interest>, snapshot: &Snapshot) -> bool {
    let mut interest = interest.lock();
    if matches!(*interest, Interest::Lost) {
        return false;
    }
    *interest = Interest::Working(snapshot.db.canceller());
    true
}

/// Ends the work when the future that waits for it is dropped.
struct Guard(Arc<Mutex<Interest>>);

impl Drop for Guard {
    fn drop(&mut self) {
        if let Interest::Working(canceller) = std::mem::replace(&mut *self.0.lock(), Interest::Lost) {
            canceller.cancel();
        }
    }
}
