//! Saves what the controller keeps, on a thread of its own: neither the controller nor the log waits for a disk.

use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;

use acrc_controller::nonvolatile::Saved;

use super::log::Log;
use crate::commands::nonvolatile::State;

/// What is to be saved. Each state is a whole one, so only the latest counts.
#[derive(Clone, Default)]
pub(super) struct ToSave(Arc<Shared>);

#[derive(Default)]
struct Shared {
    slot: Mutex<Slot>,
    changed: Condvar,
}

#[derive(Default)]
struct Slot {
    latest: Option<Box<Saved>>,
    /// Nothing more comes.
    ended: bool,
}

impl ToSave {
    /// Leaves a state to be saved soon.
    pub(super) fn put(&self, saved: &Saved) {
        let saved = Box::new(saved.clone());
        self.slot().latest = Some(saved);
        self.0.changed.notify_one();
    }

    fn end(&self) {
        self.slot().ended = true;
        self.0.changed.notify_one();
    }

    /// Waits for a state; `None` at the end.
    fn take(&self) -> Option<Box<Saved>> {
        let waits = |slot: &mut Slot| slot.latest.is_none() && !slot.ended;
        let slot = self.0.changed.wait_while(self.slot(), waits);
        slot.unwrap_or_else(PoisonError::into_inner).latest.take()
    }

    fn slot(&self) -> MutexGuard<'_, Slot> {
        self.0.slot.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The thread that saves.
pub(super) struct Saver {
    waiting: ToSave,
    thread: JoinHandle<Folder>,
}

impl Saver {
    pub(super) fn start(state: State, waiting: ToSave, log: Log) -> Self {
        let (mut folder, own) = (Folder { state, failure: None, log }, waiting.clone());
        let thread = std::thread::spawn(move || {
            while let Some(saved) = own.take() {
                folder.save(&saved);
            }
            folder
        });
        Self { waiting, thread }
    }

    /// Saves what waits, and then the state in which the controller was switched off.
    pub(super) fn finish(self, last: Option<&Saved>) -> anyhow::Result<()> {
        self.waiting.end();
        let Ok(mut folder) = self.thread.join() else { anyhow::bail!("the state was not saved") };
        match last {
            Some(last) => folder.save(last),
            None => anyhow::bail!("the state was not saved"),
        }
        folder.failure.map_or(Ok(()), Err)
    }
}

struct Folder {
    state: State,
    /// Why something could not be saved, the first time.
    failure: Option<anyhow::Error>,
    log: Log,
}

impl Folder {
    fn save(&mut self, saved: &Saved) {
        if let Err(error) = self.state.save(saved) {
            self.log.failure(format!("{error:#}"));
            self.failure.get_or_insert(error);
        }
    }
}
