//! The virtual machine: executes one stored program against a host.
//!
//! [`Code::load`] verifies a unit of an image and decodes it to a register form once; [`run`] then executes it statement by statement against a [`Host`], which is
//! the controller around it: parameters, flags, motion commands, devices. The machine itself knows expressions, assignments, program flow and local
//! variables (guide, "Program Flow", "Parametric Evaluation", "Variable Memory Allocation") and nothing else. It never sees program text.
//!
//! State is split by its owner, so that a controller can run any mixture of programs, immediate statements and PLC programs:
//! [`Code`] is immutable, [`Frame`] says how far a run has come, [`Locals`] are the variables of a program.
//!
//! ```
//! # use acrc_vm::{Arg, Budget, Call, Code, FaultKind, Frame, Host, Locals, Outcome, Stop, Value, run};
//! # use acrc_catalog::{OperandClass, command};
//! # use acrc_image::{Instruction, Node, Separator, UnitBuilder, UnitName};
//! struct Lamp(bool);
//!
//! impl Host for Lamp {
//!     fn bit(&mut self, _number: i64) -> Result<bool, FaultKind> {
//!         Ok(self.0)
//!     }
//!     fn set_bit(&mut self, _number: i64, state: bool) -> Result<(), FaultKind> {
//!         self.0 = state;
//!         Ok(())
//!     }
//!     // A controller has more to offer here.
//! #   fn parameter(&mut self, number: i64) -> Result<Value, FaultKind> { Err(FaultKind::UnknownParameter(number)) }
//! #   fn set_parameter(&mut self, number: i64, _value: &Value) -> Result<(), FaultKind> { Err(FaultKind::UnknownParameter(number)) }
//! #   fn command(&mut self, call: &Call) -> Result<Outcome, FaultKind> { Err(FaultKind::Unsupported(call.command)) }
//! #   fn random(&mut self, _below: u32) -> u32 { 0 }
//! #   fn take_character(&mut self, _device: i32) -> Result<Option<u8>, FaultKind> { Ok(None) }
//! #   fn character_waits(&mut self, _device: i32) -> Result<bool, FaultKind> { Ok(false) }
//! }
//! ```

mod code;
mod fault;
pub mod format;
mod frame;
mod functions;
mod host;
mod load;
mod locals;
mod op;
mod own;
mod plan;
mod run;
mod text;
mod value;

pub use code::{Code, Doubt, Location, Unconfirmed};
pub use fault::{Fault, FaultKind};
pub use frame::Frame;
pub use functions::AngleUnit;
pub use host::{Arg, ArgValue, Call, Host, Outcome, Reference, Source};
pub use load::{LoadError, LoadErrorKind, LoadOptions};
pub use locals::{Dimension, Locals};
pub use own::executes;
pub use run::{Budget, Run, Stop, run};
pub use text::Text;
pub use value::{Value, double_to_long};
