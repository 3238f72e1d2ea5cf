//! What a program does on the controller, seen from outside: one short test for each rule of `docs/fidelity.md` and of the guide.

mod moves;
mod support;
mod waiting;
