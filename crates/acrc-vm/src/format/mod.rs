//! How values look when they are printed (guide, "Printing the Current Value").
//!
//! Known: flags print -1 and 0, a positive number has no leading blank, a 64-bit number that is whole has no decimal
//! point. The guide does not give the digits of a fraction, nor when the exponent form begins; what stands here is a
//! choice: the shortest digits that read back, at most 7 of them for 32 bits and 15 for 64 bits, with `e`, a sign and
//! at least two digits for numbers below 0.0001 and fractions or whole numbers that need more.

mod number;
mod picture;
mod print;

pub use number::{double, number, single};
pub use picture::Picture;
pub use print::{Printed, print_line};
