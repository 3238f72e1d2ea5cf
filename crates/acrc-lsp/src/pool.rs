//! The threads that answer questions.

use std::num::NonZeroUsize;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread;

use parking_lot::Mutex;

/// More threads than this only wait for each other: most questions are about one file.
const MOST_THREADS: usize = 4;

/// Something to do in another thread.
type Job = Box<dyn FnOnce() + Send>;

/// Threads for questions, and one for what nobody waits for.
pub(crate) struct Pool {
    questions: Sender<Job>,
    background: Sender<Job>,
}

impl Pool {
    pub(crate) fn new() -> std::io::Result<Self> {
        let processors = thread::available_parallelism().map_or(1, NonZeroUsize::get);
        let (questions, jobs) = channel();
        let jobs = Arc::new(Mutex::new(jobs));
        for _ in 0..processors.clamp(2, MOST_THREADS) {
            start("acrc-question", Arc::clone(&jobs))?;
        }
        let (background, jobs) = channel();
        start("acrc-findings", Arc::new(Mutex::new(jobs)))?;
        Ok(Self { questions, background })
    }

    /// Does something as soon as a thread is free.
    pub(crate) fn answer(&self, job: impl FnOnce() + Send + 'static) {
        let _ = self.questions.send(Box::new(job));
    }

    /// Does something after everything else that nobody waits for.
    pub(crate) fn background(&self, job: impl FnOnce() + Send + 'static) {
        let _ = self.background.send(Box::new(job));
    }
}

fn start(name: &str, jobs: Arc<Mutex<Receiver<Job>>>) -> std::io::Result<()> {
    // A deep expression is read by recursion, in tests without optimisation.
    let builder = thread::Builder::new().name(name.to_owned()).stack_size(8 << 20);
    let work = move || {
        loop {
            let job = jobs.lock().recv();
            match job {
                Ok(job) => job(),
                Err(_) => return,
            }
        }
    };
    builder.spawn(work).map(drop)
}
