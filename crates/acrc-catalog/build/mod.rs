//! The catalogue at build time: rows as they are written, their checks, and the tables made of them.

pub mod check;
pub mod emit;
pub mod read;
pub mod rows;
