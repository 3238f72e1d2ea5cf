//! A whole ACR controller in virtual time: memory, parameters and flags, attachments, masters, programs and their scheduler, and the world of
//! scripted inputs around it.
//!
//! A [`Controller`] boots an image (`acrc_image`): it executes the setup code, installs the stored programs and runs them in the VM over the
//! motion core. A run is a pure function of image, world and seed; nothing here reads a clock, a file or a socket.
//!
//! What is simulated and what is assumed is listed in `docs/fidelity.md`. A command outside of that is refused before a run starts
//! ([`Controller::unsupported`]); it is never skipped.

mod aliases;
mod axis;
mod command;
mod controller;
mod coordination;
mod error;
mod flags;
mod footprint;
mod host;
mod host_interface;
mod machine;
mod master;
mod mechanics;
mod memory;
mod motion;
mod network;
pub mod nonvolatile;
mod orders;
mod plc;
mod program;
mod registers;
mod report;
mod request;
mod scheduler;
mod settings;
mod streams;
mod task;
mod terminal;
pub mod time;
mod watch;
pub mod world;

pub use acrc_motion::axis::BacklashRule;
pub use acrc_vm::AngleUnit;
pub use axis::AxisStatistics;
pub use controller::{Controller, Observer, Options, Sent, Standing, Stopped, Unsupported, View};
pub use error::ControllerError;
pub use host_interface::{
    AlarmKind, CONFIGURATION_BYTES, Conversion, Coordinate, FAST_STATUS_GROUPS, FastStatus, HostAlarm, HostArc,
    HostError, HostMove, HostPath, MoveExtras, MoveMode, MoveStart, Override, Queued,
};
pub use master::MasterStatistics;
pub use program::State;
pub use report::{AxisReport, FaultReport, MasterReport, ProgramReport};
pub use streams::{DeviceError, Port};
pub use terminal::{ChannelId, PromptState, StreamError, StreamName, Traffic};
