//! The words of a unit with their fields named, for people who look into an image.

use std::fmt::Write;

use crate::error::ImageError;
use crate::layout::{COMMAND_FIELDS, FIRST_FIELD, FieldReader, LAYOUTS, MANY, MARK_BITS, SLOTS, TAG_BITS};
use crate::node::Node;
use crate::text;
use crate::unit::Unit;

/// One line a word: address, hexadecimal word, and its fields that are not zero; at the end the pool.
///
/// # Errors
/// As [`Unit::decode`].
pub fn dump(unit: &Unit) -> Result<String, ImageError> {
    let instructions = unit.decode()?;
    let mut out = Dump { out: String::new(), words: &unit.words, at: 0 };
    for instruction in &instructions {
        out.word(|word| format!("{}: {}", instruction.command.info().name, fields(word, COMMAND_FIELDS)));
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

/// The name and the fields of a node word.
fn node_fields(word: u32) -> String {
    let tag = word & ((1 << TAG_BITS) - 1);
    let Some(layout) = LAYOUTS.iter().find(|layout| layout.tag == tag) else { return format!("tag {tag}") };
    let mark = (word >> TAG_BITS) & ((1 << MARK_BITS) - 1);
    let mark = if mark == 0 { String::new() } else { format!("mark {mark} ") };
    format!("{} {mark}{}", layout.name, fields(word >> FIRST_FIELD, layout.fields))
}

/// The fields of a word that are not zero.
fn fields(bits: u32, fields: &[(&str, u32)]) -> String {
    let mut bits = FieldReader { rest: bits };
    let mut out = String::new();
    for &(name, width) in fields {
        let value = bits.take(width);
        if value != 0 {
            let _ = write!(out, "{name} {value} ");
        }
    }
    out
}
