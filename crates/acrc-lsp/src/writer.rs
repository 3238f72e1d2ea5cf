//! The one thread that owns the database. It does what is queued in the order of arrival: edits at once, questions by
//! giving a snapshot to another thread. When nothing is queued any more, the findings are told.

use std::sync::mpsc::Receiver;
use std::thread;
use std::time::{Duration, Instant};

use acrc_analysis::project;
use camino::Utf8PathBuf;
use tower_lsp_server::jsonrpc::ErrorCode;
use tower_lsp_server::ls_types::{MessageType, Uri};

use crate::diagnostics::{self, Publisher, Round};
use crate::outgoing::Outgoing;
use crate::pool::Pool;
use crate::progress::Progress;
use crate::queue::{Queue, Task, Watch, Work};
use crate::scratch::Scratch;
use crate::snapshot::Snapshot;
use crate::workspace::{Changes, Refused, Workspace};

/// An answer that took longer than this is written into the log when times are asked for.
const SLOW: Duration = Duration::from_millis(5);

/// Does what is queued.
pub(crate) struct Writer {
    queue: Queue,
    tasks: Receiver<Task>,
    outgoing: Outgoing,
    publisher: Publisher,
    pool: Pool,
    workspace: Workspace,
    /// Questions that wait for a change.
    watches: Vec<Watch>,
    /// Counts changes.
    revision: u64,
    /// What was not told yet, from changes whose findings were overtaken.
    untold: Changes,
    loading: Option<Loading>,
}

/// Projects that a search found.
struct Loading {
    progress: Progress,
    done: usize,
    all: usize,
}

impl Writer {
    pub(crate) fn new(queue: Queue, tasks: Receiver<Task>, outgoing: Outgoing, pool: Pool, scratch: Scratch) -> Self {
        Self {
            queue,
            tasks,
            publisher: Publisher::new(outgoing.clone()),
            outgoing,
            pool,
            workspace: Workspace::new(scratch),
            watches: Vec::new(),
            revision: 0,
            untold: Changes::default(),
            loading: None,
        }
    }

    /// Works until the session is over.
    pub(crate) fn run(mut self) {
        while let Ok(task) = self.tasks.recv() {
            let mut next = Some(task);
            while let Some(task) = next {
                if matches!(task, Task::Stop) {
                    return;
                }
                self.take(task);
                next = self.tasks.try_recv().ok();
            }
            self.tell();
        }
    }

    fn take(&mut self, task: Task) {
        match task {
            Task::Begin(abilities, roots, settings) => {
                self.workspace.abilities = abilities;
                self.workspace.roots = roots;
                self.workspace.settings = settings.into();
            }
            Task::Ready => self.search(self.workspace.roots.clone()),
            Task::Open(item) => self.workspace.open(item),
            Task::Change(params) => {
                let result = self.workspace.change(&params.text_document, params.content_changes);
                if let Err(refused) = result {
                    self.complain(&params.text_document.uri, refused);
                }
            }
            Task::Close(uri) => self.workspace.close(&uri),
            Task::Watched(params) => params.changes.iter().for_each(|event| self.workspace.disk_changed(&event.uri)),
            Task::Folders(event) => {
                let added = self.workspace.change_folders(&event);
                self.search(added);
            }
            Task::Settings(settings) => {
                self.workspace.settings = settings.into();
                self.workspace.touch_all();
                if self.workspace.abilities.refreshes_hints {
                    // A client that refuses asks when it likes.
                    self.outgoing.converse(|client| async move { drop(client.inlay_hint_refresh().await) });
                }
            }
            Task::Found(found) => self.begin_loading(found),
            Task::Load(found) => self.load(&found),
            Task::Ask(work) => self.ask(work),
            Task::Wait(watch, revision) if revision == self.revision => self.watches.push(watch),
            Task::Watch(watch) | Task::Wait(watch, _) => self.watch(vec![watch]),
            Task::Told(revision) => {
                if revision == self.revision {
                    self.untold = Changes::default();
                }
            }
            // Taken before.
            Task::Stop => {}
        }
    }

    fn ask(&self, work: Work) {
        let snapshot = self.workspace.snapshot();
        let timing = snapshot.settings.trace.timing.then(|| (self.outgoing.clone(), Instant::now()));
        self.pool.answer(move || {
            work(snapshot);
            if let Some((outgoing, asked)) = timing {
                let took = asked.elapsed();
                let kind = if took > SLOW { MessageType::WARNING } else { MessageType::LOG };
                outgoing.log(kind, format!("an answer took {:.1} ms", took.as_secs_f64() * 1000.0));
            }
        });
    }

    fn complain(&self, uri: &Uri, refused: Refused) {
        let why = match refused {
            Refused::NotOpen => "it is not open",
            Refused::Range => "a range ends before it begins",
        };
        self.outgoing.log(MessageType::ERROR, format!("a change of {} was refused: {why}", uri.as_str()));
    }

    /// Looks for projects in folders, in another thread.
    fn search(&mut self, roots: Vec<Utf8PathBuf>) {
        if roots.is_empty() {
            return;
        }
        let queue = self.queue.clone();
        let search = move || {
            let found = roots.iter().filter(|root| project::holds_programs(root));
            queue.send(Task::Found(found.flat_map(|root| project::search(root).projects).collect()));
        };
        if let Err(error) = thread::Builder::new().name("acrc-search".to_owned()).spawn(search) {
            self.outgoing.log(MessageType::ERROR, format!("the folders can't be searched: {error}"));
        }
    }

    fn begin_loading(&mut self, found: Vec<Utf8PathBuf>) {
        if found.is_empty() {
            return;
        }
        let shows = self.workspace.abilities.shows_progress;
        self.loading = Some(Loading {
            progress: Progress::begin(&self.outgoing, shows, "acrc: reading projects"),
            done: 0,
            all: found.len(),
        });
        // One task each: edits and questions come in between.
        for project in found {
            self.queue.send(Task::Load(project));
        }
    }

    fn load(&mut self, found: &camino::Utf8Path) {
        self.workspace.load(found);
        if let Some(loading) = &mut self.loading {
            loading.done += 1;
            loading.progress.report(loading.done, loading.all);
            if loading.done >= loading.all {
                self.loading = None;
            }
        }
    }

    /// Tells what changed. Nobody is told of a state that is no longer the present one: the next edit ends this.
    fn tell(&mut self) {
        let changes = self.workspace.take_changes();
        for path in &changes.gone {
            self.publisher.forget(path);
        }
        for (path, trouble) in &changes.troubles {
            let diagnostics = trouble.iter().map(diagnostics::of_trouble).collect();
            self.publisher.tell_trouble(path, diagnostics);
        }
        if changes.projects.is_empty() {
            return;
        }
        self.revision += 1;
        self.untold.projects.extend(changes.projects);
        self.untold.edited = changes.edited.or(self.untold.edited);
        self.watch(Vec::new());
        let abilities = self.workspace.abilities;
        if !abilities.pulls_diagnostics {
            self.publish();
        } else if changes.edited.is_none() && abilities.refreshes_diagnostics {
            // The client knows of its own edits only.
            self.outgoing.converse(|client| async move { drop(client.workspace_diagnostic_refresh().await) });
        }
    }

    fn publish(&self) {
        let keys = self.untold.projects.iter();
        let projects = keys.filter_map(|key| self.workspace.project_files(key));
        let files = projects.flat_map(|(project, files)| files.into_iter().map(move |file| (project, file)));
        let snapshot = self.workspace.snapshot();
        let round = Round::new(&snapshot, files.collect(), self.untold.edited);
        let (publisher, queue, revision) = (self.publisher.clone(), self.queue.clone(), self.revision);
        self.pool.background(move || {
            if publisher.tell(&snapshot, &round) {
                // The snapshot is given back first, so that the writer need not wait for it.
                drop(snapshot);
                queue.send(Task::Told(revision));
            }
        });
    }

    /// Asks new questions, and those again that wait for a change.
    fn watch(&mut self, new: Vec<Watch>) {
        let mut watches = std::mem::take(&mut self.watches);
        watches.extend(new);
        for watch in watches {
            let (snapshot, queue, revision) = (self.workspace.snapshot(), self.queue.clone(), self.revision);
            self.pool.background(move || ask_again(watch, snapshot, &queue, revision));
        }
    }
}

/// Asks a question that may have no answer yet.
fn ask_again(mut watch: Watch, snapshot: Snapshot, queue: &Queue, revision: u64) {
    let asked = snapshot.answer(|snapshot| Ok(watch(snapshot)));
    drop(snapshot);
    match asked {
        Ok(false) => queue.send(Task::Wait(watch, revision)),
        Err(error) if error.code == ErrorCode::ContentModified => queue.send(Task::Watch(watch)),
        // It is answered; at a mistake of a feature who asked finds the question dropped.
        Ok(true) | Err(_) => {}
    }
}
