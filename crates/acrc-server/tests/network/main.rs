//! The server as its clients see it, over the loopback interface.

mod common;
mod contract;
mod fast_status;
mod management;
mod mixed;
mod robust;
mod text;
