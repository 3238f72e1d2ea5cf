//! The forms that other programs read: reports for build services, and differences.

mod any;
mod ci;
mod diff;
mod sample;
mod sarif;
