//! The words of a unit with their fields named, for people who look into an image.

use std::fmt::Write;

use crate::error::ImageError;
use crate::instruction::{Instruction, Mark, Separator};
use crate::layout::{FIRST_FIELD, FieldReader, LAYOUTS, MANY, SLOTS, TAG_BITS};
use crate::node::Node;
use crate::text;
use crate::unit::Unit;

/// One line a word: address, hexadecimal word, and what it says; at the end the pool.
///
/// # Errors
/// As [`Unit::decode`].
pub fn dump(unit: &Unit) -> Result<String, ImageError> {
    let instructions = unit.decode()?;
    let mut out = Dump { out: String::new(), words: &unit.words, at: 0 };
    for instruction in &instructions {
        out.word(|_| command(instruction));
        for (place, item) in instruction.items.iter().enumerate() {
            if place >= SLOTS && item.node.is_constant() {
                out.word(node_fields);
            }
            out.node(&item.node, 1);
        }
        if instruction.items.len() >= MANY as usize {
            out.word(node_fields);
        }
    }
    if !unit.strings.is_empty() {
        let _ = writeln!(out.out, "pool            {:?}", text::decode(&unit.strings));
    }
    Ok(out.out)
}

struct Dump<'a> {
    out: String,
    words: &'a [u32],
    at: usize,
}

impl Dump<'_> {
    /// Writes the next word.
    fn word(&mut self, describe: impl FnOnce(u32) -> String) {
        let word = self.words.get(self.at).copied().unwrap_or_default();
        let _ = writeln!(self.out, "{:04}  {word:08X}  {}", self.at, describe(word).trim_end());
        self.at += 1;
    }

    /// Writes the words of an operand, indented by its depth.
    fn node(&mut self, node: &Node, depth: usize) {
        let indent = "  ".repeat(depth);
        match node {
            Node::Long(value) => self.word(|_| format!("{indent}long {value}")),
            Node::Single(value) => self.word(|_| format!("{indent}single {value:?}")),
            Node::Double(value) => {
                self.word(|_| format!("{indent}double {value:?}, low word"));
                self.word(|_| format!("{indent}double {value:?}, high word"));
            }
            other => {
                self.word(|word| format!("{indent}{}", node_fields(word)));
                for child in other.children() {
                    self.node(child, depth + 1);
                }
            }
        }
    }
}

/// The command, how it is set off, and the marks behind its items.
fn command(instruction: &Instruction) -> String {
    let mut out = instruction.command.info().name.to_owned();
    match instruction.separator {
        Separator::Blank => {}
        Separator::Colon => out.push_str(", behind a colon"),
        Separator::Line => out.push_str(", on a new line"),
        Separator::Then => out.push_str(", behind THEN"),
    }
    for (place, item) in (1..).zip(&instruction.items) {
        let mark = match item.mark {
            Mark::None => continue,
            Mark::Comma => "comma",
            Mark::Semicolon => "semicolon",
        };
        let _ = write!(out, ", {mark} behind item {place}");
    }
    out
}

/// The name and the fields of a node word.
fn node_fields(word: u32) -> String {
    let tag = word & ((1 << TAG_BITS) - 1);
    let Some(layout) = LAYOUTS.iter().find(|layout| layout.tag == tag) else { return format!("tag {tag}") };
    let mut bits = FieldReader { rest: word >> FIRST_FIELD };
    let mut out = layout.name.to_owned();
    for field in layout.fields {
        if let Some(value) = (field.show)(bits.take(field.width)) {
            let _ = write!(out, " {} {value}", field.name);
        }
    }
    out
}
