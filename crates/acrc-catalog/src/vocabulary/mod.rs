//! The closed vocabularies of the language and of the data files.
//!
//! These declarations are compiled twice: into the crate, and into its build script, which refuses a data row that uses another word.

mod access;
mod confidence;
mod keyword;
mod levels;
mod object;
mod operand;
mod operator;
mod shape;
mod space;
mod types;

pub use access::{Access, BitKind};
pub use confidence::Confidence;
pub use keyword::Keyword;
pub use levels::Levels;
pub use object::ObjectKind;
pub use operand::OperandClass;
pub use operator::{Operator, UnaryOperator};
pub use shape::Shape;
pub use space::Space;
pub use types::{TypeClass, ValueType};
