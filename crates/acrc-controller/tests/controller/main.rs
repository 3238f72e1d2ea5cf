//! What a program does on the controller, seen from outside: one short test for each rule of the guide and of `docs/fidelity.md`.

mod arcs;
mod attachments;
mod bits;
mod catalogue;
mod devices;
mod extremes;
mod follow;
mod holds;
mod interrupts;
mod memory;
mod moves;
mod nonvolatile;
mod parameters;
mod path;
mod plcs;
mod polling;
mod programs;
mod properties;
mod reports;
mod settings;
mod setup;
mod stepping;
mod support;
mod time;
mod timebase;
mod world;
