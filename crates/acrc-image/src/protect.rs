//! `PASSWORD`: a controller that does not show its programs (guide, "Block uploading programs from board").
//!
//! The guide names the command and its purpose. That the setup code switches protection on and off, in the order of its statements, for all
//! programs together, is our reading (`docs/fidelity.md`). It keeps tools from listing; the words of the file are not encrypted.

use acrc_catalog::{Keyword, command};

use crate::error::ImageError;
use crate::image::Image;
use crate::instruction::Instruction;
use crate::node::Node;
use crate::text;

impl Image {
    /// The password that protects the programs once the boot unit has run; `None` when nothing does.
    ///
    /// # Errors
    /// As [`crate::Unit::decode`].
    pub fn password(&self) -> Result<Option<String>, ImageError> {
        let mut password = None;
        for statement in self.boot.decode()?.iter().filter(|statement| statement.command == command::PASSWORD) {
            let text = self.text_of(statement);
            let off = statement.items.iter().any(|item| is_off(&item.node));
            match text {
                // Only the right password lifts the protection.
                Some(text) if off && password.as_ref() == Some(&text) => password = None,
                Some(text) if !off && password.is_none() => password = Some(text),
                _ => {}
            }
        }
        Ok(password)
    }

    /// The text behind the command, which may be an alias.
    fn text_of(&self, statement: &Instruction) -> Option<String> {
        statement.items.iter().find_map(|item| match &item.node {
            Node::String { bytes, .. } => Some(text::decode(bytes)),
            Node::Alias { index, .. } => match self.aliases.get(usize::from(*index)).map(|alias| &alias.target) {
                Some(Node::String { bytes, .. }) => Some(text::decode(bytes)),
                _ => None,
            },
            _ => None,
        })
    }
}

fn is_off(node: &Node) -> bool {
    matches!(node, Node::Word { keyword: Keyword::Off, .. })
}
