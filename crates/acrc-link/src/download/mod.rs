//! Brings a project to a controller: plan, send, verify; and reads back what a controller has.
//!
//! Everything here talks to a [`crate::Console`] and does no input or output of its own. A download consists of
//!
//! 1. [`Script::of`]: the project as the lines that are typed,
//! 2. [`survey`]: what the controller has and does,
//! 3. [`Plan::new`]: what is erased, sent and kept, or what speaks against it,
//! 4. [`send`]: every line and its answer, then every program listed and compared.
//!
//! Whoever is cut off does the same again: the survey shows what is there already.

mod compare;
mod demand;
mod immediate;
mod listing;
mod objection;
mod plan;
mod problem;
mod script;
mod send;
mod state;
mod survey;
mod upload;
mod verify;

pub use compare::{Comparison, Entry, Pair, Standing, compare};
pub use immediate::{Detached, Special, Traits};
pub use listing::{Difference, Listing, Names, unit_lines};
pub use objection::Objection;
pub use plan::{Deed, Erased, NOTHING_STORED, Plan, Save, Settings, Step};
pub use problem::{Problem, codes};
pub use script::{Kind, LONGEST_LINE, Place, Script, ScriptFile, ScriptLine, level_of, unit_at};
pub use send::{Cause, Event, Failure, Watcher, send};
pub use state::{Fate, State};
pub use survey::{Survey, survey};
pub use upload::{Upload, UploadedFile, upload};
pub use verify::verify;
