//! The functions of the language (guide, "Parametric Evaluation").

mod math;
mod text;

pub use math::AngleUnit;
pub(crate) use math::{Math, power};
pub(crate) use text::{TextFunction, TextResult, leading_number};
