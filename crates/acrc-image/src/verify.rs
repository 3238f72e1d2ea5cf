//! What the operands of a statement must be, whatever encoded it. The virtual machine and the lister rely on it.

use acrc_catalog::{CommandId, Shape, command};

use crate::error::Problem;
use crate::instruction::{Item, Mark, Separator};
use crate::node::Node;

/// Checks the operands of one statement and how it is set off.
pub(crate) fn statement(
    separator: Separator,
    after_then: bool,
    command: CommandId,
    items: &[Item],
) -> Result<(), Problem> {
    if CommandId::from_opcode(command.0).is_none() {
        return Err(Problem::Unknown { what: "opcode", code: command.0.into() });
    }
    if separator == Separator::Then && !after_then {
        return Err(Problem::Operands("a statement follows THEN without an IF before it"));
    }
    operands(command, items).map_or(Ok(()), |wrong| Err(Problem::Operands(wrong)))
}

/// Is the statement an `IF` with `THEN`, so that what follows on the line depends on it?
pub(crate) fn opens_then(command: CommandId, items: &[Item]) -> bool {
    command == command::IF && items.first().is_some_and(|item| item.mark == Mark::Comma)
}

/// What is wrong with the operands of a command whose form is fixed. Other commands are checked by what executes them.
fn operands(command: CommandId, items: &[Item]) -> Option<&'static str> {
    let nodes: Vec<&Node> = items.iter().map(|item| &item.node).collect();
    let expressions = nodes.iter().all(|node| node.is_expression());
    let (valid, wrong) = match command.info().shape {
        Shape::Label => {
            (matches!(nodes.as_slice(), [Node::String { parens: 0, .. }]), "a label is defined by one text")
        }
        Shape::Text => (matches!(nodes.as_slice(), [Node::String { parens: 0, .. }]), "a remark is one text"),
        Shape::LineNumber => {
            (matches!(nodes.as_slice(), [Node::Long(0..)]), "a line number is one long that is not negative")
        }
        Shape::Define => (matches!(nodes.as_slice(), [Node::Alias { parens: 0, .. }]), "a definition names one alias"),
        Shape::Assignment => (expressions && nodes.len() == 2, "an assignment has a target and a value"),
        Shape::If | Shape::Condition => (expressions && nodes.len() == 1, "a condition is one expression"),
        Shape::For => {
            (expressions && (3..=4).contains(&nodes.len()), "FOR has a counter, a start, an end and possibly a step")
        }
        Shape::Dim => (expressions && nodes.len() <= 3, "DIM has at most a number and two sizes"),
        Shape::Target => (
            matches!(nodes.as_slice(), [] | [Node::LabelRef(_) | Node::Long(0..)]),
            "a jump goes to a label or a line number",
        ),
        _ => (true, ""),
    };
    (!valid).then_some(wrong)
}

/// The labels that a unit defines and refers to.
#[derive(Debug, Default)]
pub(crate) struct Labels {
    defined: usize,
    /// The greatest number referred to, and where.
    greatest: Option<(u16, u32)>,
}

impl Labels {
    /// Takes note of a statement.
    pub(crate) fn add(&mut self, command: CommandId, items: &[Item]) {
        self.add_at(0, command, items);
    }

    /// Takes note of the statement at `address`.
    pub(crate) fn add_at(&mut self, address: u32, command: CommandId, items: &[Item]) {
        if command == command::LABEL {
            self.defined += 1;
        }
        for item in items {
            if let Node::LabelRef(ordinal) = item.node
                && self.greatest.is_none_or(|(greatest, _)| greatest < ordinal)
            {
                self.greatest = Some((ordinal, address));
            }
        }
    }

    /// Is every label that is referred to defined?
    pub(crate) fn check(&self) -> Result<(), (u32, Problem)> {
        match self.greatest {
            Some((ordinal, address)) if usize::from(ordinal) >= self.defined => {
                Err((address, Problem::NoSuchLabel { ordinal, labels: self.defined }))
            }
            _ => Ok(()),
        }
    }
}

/// The greatest alias number below `node`.
pub(crate) fn greatest_alias(node: &Node) -> Option<u16> {
    let own = if let Node::Alias { index, .. } = node { Some(*index) } else { None };
    node.children().into_iter().filter_map(greatest_alias).chain(own).max()
}

/// What a node is, for messages.
pub(crate) fn describe(node: &Node) -> &'static str {
    match node {
        Node::Long(_) | Node::Single(_) | Node::Double(_) => "a constant",
        Node::String { .. } => "a text",
        Node::Scalar { .. } | Node::Array { .. } => "a variable",
        Node::Alias { .. } => "an alias",
        Node::Unary { .. } | Node::Binary { .. } | Node::Call { .. } => "an expression",
        Node::LabelRef(_) => "a label",
        Node::Axis { .. } => "an axis",
        Node::Object { .. } => "an object",
        Node::Tuple(_) => "a tuple",
        Node::Word { .. } => "a keyword",
        Node::Interpolation(_) => "an interpolation",
        Node::Device(_) => "a device",
    }
}
