//! A state in a folder: what is saved is there, whatever happens while it is saved.

mod crash;
mod disk;
mod form;
mod kill;
mod support;
