//! Giving up questions whose answers nobody waits for any more: an edit ends what other threads ask of snapshots, and
//! whoever asked can end it.

use std::fmt;
use std::panic::AssertUnwindSafe;

use salsa::Database as _;

use crate::Database;

/// Ends the questions that are asked of one snapshot, from any thread.
#[derive(Clone)]
pub struct Canceller(salsa::CancellationToken);

impl Canceller {
    /// The next step of a question under way is its last.
    pub fn cancel(&self) {
        self.0.cancel();
    }
}

impl fmt::Debug for Canceller {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Canceller").finish_non_exhaustive()
    }
}

/// A question was given up: the database is about to change, or somebody ended it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cancelled;

impl Database {
    /// Ends what is asked of this snapshot.
    pub fn canceller(&self) -> Canceller {
        Canceller(self.cancellation_token())
    }
}

/// Asks questions of a snapshot, which may be given up on the way. Panics go on.
pub fn unless_cancelled<T>(questions: impl FnOnce() -> T) -> Result<T, Cancelled> {
    // A snapshot whose questions were given up is in order: what was not finished is not remembered.
    salsa::Cancelled::catch(AssertUnwindSafe(questions)).map_err(|_| Cancelled)
}
