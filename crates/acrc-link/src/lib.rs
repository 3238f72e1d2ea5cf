//! The host's side of a controller, real or virtual: connections, what is read and written over them, download and upload.
//!
//! - [`Console`] is a command line of a controller: a line goes out, an [`Answer`] comes back. What a host does is written
//!   against it, and knows nothing of sockets.
//! - [`LinkError`] says why something could not be done, with the value that failed.

mod answer;
mod console;
mod error;

pub use answer::{Answer, parse_prompt};
pub use console::Console;
pub use error::LinkError;
