//! What the flags and parameters of a line are called.

use acrc_catalog::{Known, OperandClass, Shape, Space, bit, parameter};

use crate::image::Alias;
use crate::instruction::Instruction;
use crate::node::Node;

/// The names of the flags and parameters in some statements, each once; `None` when nothing in them has a name.
pub(super) fn comment(statements: &[Instruction], aliases: &[Alias]) -> Option<String> {
    let mut names = Names { aliases, found: Vec::new() };
    for statement in statements {
        let takes_flag = matches!(statement.command.info().shape, Shape::Bit | Shape::BitMove);
        for (place, item) in statement.items.iter().enumerate() {
            match item.node {
                // A flag behind `SET` or `LD` is a plain number, with its sign.
                Node::Long(number) if takes_flag && place == 0 => names.flag("", number.unsigned_abs()),
                _ => names.node(&item.node),
            }
        }
    }
    (!names.found.is_empty()).then(|| names.found.join("; "))
}

struct Names<'a> {
    aliases: &'a [Alias],
    found: Vec<String>,
}

impl Names<'_> {
    fn node(&mut self, node: &Node) {
        match node {
            Node::Alias { index, .. } => {
                if let Some(Alias { name, target }) = self.aliases.get(usize::from(*index)) {
                    self.operand(&format!("{name} is "), target);
                }
            }
            _ => self.operand("", node),
        }
        for child in node.children() {
            self.node(child);
        }
    }

    fn operand(&mut self, before: &str, node: &Node) {
        let Node::Scalar { class, index, .. } = node else { return };
        let Node::Long(number) = **index else { return };
        match (class, u32::try_from(number)) {
            (OperandClass::Bit, Ok(number)) => self.flag(before, number),
            (OperandClass::Parameter, Ok(number)) => {
                let info = parameter(number);
                let name = Name { title: info.title, owner: info.owner(), object: info.object, element: info.element };
                self.add(info.known, &format!("{before}P{number}"), &name);
            }
            _ => {}
        }
    }

    fn flag(&mut self, before: &str, number: u32) {
        let info = bit(number);
        let name = Name { title: info.title, owner: info.owner(), object: info.object, element: info.element };
        self.add(info.known, &format!("{before}BIT{number}"), &name);
    }

    /// Notes what a row of the catalogue names. The user's own parameters and flags have no name there.
    fn add(&mut self, known: Known, number: &str, name: &Name) {
        if known != Known::Row || name.object == Space::User {
            return;
        }
        let Name { title, owner, object, element } = name;
        let name = match element {
            Some(element) if !object.is_numbered() => format!("{number}: {title} {element}"),
            _ if owner.is_empty() => format!("{number}: {title}"),
            _ => format!("{number}: {title}, {owner}"),
        };
        if !self.found.contains(&name) {
            self.found.push(name);
        }
    }
}

/// What the catalogue says of a number.
struct Name {
    title: &'static str,
    owner: String,
    object: Space,
    /// Which of several things of one title.
    element: Option<u32>,
}
