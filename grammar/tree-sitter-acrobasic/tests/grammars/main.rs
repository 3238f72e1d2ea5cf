//! The grammars of this folder against the compiler, the catalogue and each other.

mod blocks;
mod classes;
mod ebnf;
mod programs;
mod textmate;
mod tokens;
mod trees;
