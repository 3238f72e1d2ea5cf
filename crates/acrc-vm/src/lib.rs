//! The virtual machine: executes one stored program against a host.
//!
//! [`Code::load`] verifies a unit of an image and decodes it to a register form once; [`run`] then executes it
//! statement by statement against a [`Host`], which is the controller around it: parameters, flags, motion commands,
//! devices. The machine itself knows expressions, assignments, program flow and local variables (guide, "Program Flow",
//! "Parametric Evaluation", "Variable Memory Allocation") and nothing else. It never sees program text.
//!
//! State is split by its owner, so that a controller can run any mixture of programs, immediate statements and PLC
//! programs: [`Code`] is immutable, [`Frame`] says how far a run has come, [`Locals`] are the variables of a program.
//!
//! - One line or one statement at a time: [`Budget::lines`] or [`Budget::statements`] of 1. A line that was begun ends
//!   with its line, wherever in it the run starts. [`Host::statement`] tells the places on the way.
//! - A statement that is typed at a program's prompt is code of its own and runs with [`Frame::beside`] the program's
//!   frame on the program's [`Locals`].
//! - Text that is edited gives new [`Code`]; [`Frame::reset`] takes it up, the [`Locals`] stay.
//! - [`Locals::image`] and [`Locals::restore`] keep variables beyond a run.
//!
//! ```
//! # use acrc_catalog::{OperandClass, UnaryOperator, command};
//! # use acrc_image::{Node, Separator, UnitBuilder, UnitName};
//! # use acrc_vm::{Budget, Call, Code, FaultKind, Frame, Host, Locals, Outcome, Stop, Value, run};
//! struct Lamp(bool);
//!
//! impl Host for Lamp {
//!     fn bit(&mut self, _number: i64) -> Result<bool, FaultKind> {
//!         Ok(self.0)
//!     }
//!
//!     fn set_bit(&mut self, _number: i64, state: bool) -> Result<(), FaultKind> {
//!         self.0 = state;
//!         Ok(())
//!     }
//!
//!     // This controller has nothing but a lamp.
//!     fn parameter(&mut self, number: i64) -> Result<Value, FaultKind> {
//!         Err(FaultKind::UnknownParameter(number))
//!     }
//!     // ...
//! #   fn set_parameter(&mut self, number: i64, _: &Value) -> Result<(), FaultKind> { Err(FaultKind::UnknownParameter(number)) }
//! #   fn command(&mut self, call: &Call) -> Result<Outcome, FaultKind> { Err(FaultKind::Unsupported(call.command)) }
//! #   fn random(&mut self, _: u32) -> u32 { 0 }
//! #   fn take_character(&mut self, _: i32) -> Result<Option<u8>, FaultKind> { Ok(None) }
//! #   fn character_waits(&mut self, _: i32) -> Result<bool, FaultKind> { Ok(false) }
//! }
//!
//! // BIT 32 = NOT BIT 32
//! let flag = Node::scalar(OperandClass::Bit, 32);
//! let toggled = Node::Unary { op: UnaryOperator::Not, operand: Box::new(flag.clone()), parens: 0 };
//! let mut builder = UnitBuilder::new(UnitName::Program(0));
//! builder.push(Separator::Line, command::ASSIGNMENT, &[flag.into(), toggled.into()])?;
//!
//! let code = Code::load(&builder.finish()?, &[])?;
//! let mut lamp = Lamp(false);
//! let outcome = run(&code, &mut Frame::new(), &mut Locals::new(0), &mut lamp, Budget::lines(4));
//! assert_eq!(outcome.stop, Stop::Ended);
//! assert!(lamp.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod account;
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
mod snapshot;
mod text;
mod value;

pub use code::{Code, Doubt, Location, Unconfirmed};
pub use fault::{Fault, FaultKind};
pub use frame::Frame;
pub use functions::AngleUnit;
pub use host::{Arg, ArgValue, Call, Host, Outcome, Reference, Source};
pub use load::{LoadError, LoadErrorKind, LoadOptions};
pub use locals::{Dimension, Locals, LocalsImage, RestoreError, TextsImage};
pub use own::executes;
pub use run::{Budget, Run, Stop, input_fits, run};
pub use snapshot::Snapshot;
pub use text::Text;
pub use value::{Value, double_to_long};
