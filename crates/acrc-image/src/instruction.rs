//! One statement of a unit.

use acrc_catalog::CommandId;

use crate::node::Node;

/// A statement: a command and its items.
#[derive(Clone, Debug, PartialEq)]
pub struct Instruction {
    /// Where its command word stands, in words from the start of the unit.
    pub address: u32,
    /// How it is set off from the statement before it.
    pub separator: Separator,
    /// What it does.
    pub command: CommandId,
    /// Its operands.
    pub items: Vec<Item>,
}

/// One operand of a statement and what stands behind it.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// The operand.
    pub node: Node,
    /// What stands behind it.
    pub mark: Mark,
}

impl From<Node> for Item {
    fn from(node: Node) -> Self {
        Self { node, mark: Mark::None }
    }
}

/// What stands between a statement and the one before it. The values are the code in the command word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Separator {
    /// Blanks or nothing: `ACC10 DEC10`.
    Blank = 0,
    /// A colon.
    Colon = 1,
    /// It begins a line.
    Line = 2,
    /// The `THEN` of the `IF` before it.
    Then = 3,
}

impl Separator {
    /// All, by code.
    pub const ALL: [Self; 4] = [Self::Blank, Self::Colon, Self::Line, Self::Then];
}

/// What stands behind an item. The values are the code in the words.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Mark {
    /// Nothing.
    #[default]
    None = 0,
    /// A comma; behind the condition of `IF`: `THEN`.
    Comma = 1,
    /// A semicolon; behind the first item of `DIM`: it is the number of the block and not a size.
    Semicolon = 2,
}

impl Mark {
    /// All, by code.
    pub const ALL: [Self; 3] = [Self::None, Self::Comma, Self::Semicolon];
}
