//! The host's side of a controller, real or virtual: connections, what is read and written over them, download and upload.
//!
//! - [`Console`] is a command line of a controller: a line goes out, an [`Answer`] comes back. What a host does is written
//!   against it, and knows nothing of sockets.
//! - [`Connection`] is one over TCP, on port 5002 (text) or 5006 (text and packets), or over any other [`Transport`].
//! - [`download`] brings a project to a controller and reads back what it has.
//! - [`LinkError`] says why something could not be done, with the value that failed.
//!
//! Nothing here guesses where a controller is, and nothing waits without an end: every wait has a time after which it is
//! an error, and ends when [`Settings::interrupted`] says so.

mod answer;
mod connection;
mod console;
pub mod download;
mod endpoint;
mod error;
pub mod fast_status;
pub mod motion;
mod packets;
mod question;
mod reply;
mod settings;
mod transport;
pub mod values;

pub use answer::{Answer, parse_prompt};
pub use connection::{Connection, ESCAPE};
pub use console::Console;
pub use endpoint::{Endpoint, EndpointError, Protocol};
pub use error::LinkError;
pub use reply::split_prompt;
pub use settings::Settings;
pub use transport::{Tcp, Transport};
