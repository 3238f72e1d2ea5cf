//! Instructions to words.

use acrc_catalog::CommandId;

use crate::debug::{DebugMap, Location};
use crate::error::{EncodeError, Problem};
use crate::field::{Kind, fit};
use crate::instruction::{Instruction, Item, Separator};
use crate::layout::{self, CommandWord, END, FIRST_FIELD, FieldWriter, MANY, SLOTS, Slot, TAG_BITS};
use crate::node::{Node, Role};
use crate::unit::{Unit, UnitName, memory};
use crate::verify::{self, Labels};
use crate::{MAX_DEPTH, instruction::Mark};

/// Encodes the statements of a unit; the inverse of [`Unit::decode`]. The addresses of the instructions do not matter.
pub fn encode(name: UnitName, instructions: &[Instruction]) -> Result<Unit, EncodeError> {
    let mut builder = UnitBuilder::new(name);
    for instruction in instructions {
        builder.push(instruction.separator, instruction.command, &instruction.items)?;
    }
    builder.finish()
}

/// Encodes a unit statement by statement.
#[derive(Debug)]
pub struct UnitBuilder {
    name: UnitName,
    out: Encoder,
    labels: Labels,
    debug: Option<DebugMap>,
    /// The statement before is an `IF` with `THEN`.
    after_then: bool,
}

impl UnitBuilder {
    /// An empty unit.
    pub fn new(name: UnitName) -> Self {
        Self { name, out: Encoder::default(), labels: Labels::default(), debug: None, after_then: false }
    }

    /// Adds a statement and returns its address. After an error the unit is without it.
    pub fn push(&mut self, separator: Separator, command: CommandId, items: &[Item]) -> Result<u32, EncodeError> {
        let (words, strings) = (self.out.words.len(), self.out.strings.len());
        let pushed = self.try_push(separator, command, items);
        if pushed.is_err() {
            self.out.words.truncate(words);
            self.out.strings.truncate(strings);
        }
        pushed.map(|()| words as u32)
    }

    fn try_push(&mut self, separator: Separator, command: CommandId, items: &[Item]) -> Result<(), EncodeError> {
        verify::statement(separator, self.after_then, command, items)?;
        self.out.instruction(separator, command, items)?;
        self.labels.add(command, items);
        self.after_then = verify::opens_then(command, items);
        Ok(())
    }

    /// Says where the statement at `address` stands in the source.
    pub fn locate(&mut self, address: u32, location: Location) {
        self.debug.get_or_insert_default().push(address, location);
    }

    /// The memory that the statements added so far take, in bytes ([`Unit::memory`]).
    pub fn memory(&self) -> u32 {
        memory(&self.out.words, &self.out.strings)
    }

    /// The unit.
    pub fn finish(self) -> Result<Unit, EncodeError> {
        self.labels.check().map_err(|(_, problem)| problem)?;
        fit("the number of words of a unit", self.out.words.len() as u64, u64::from(u32::MAX) / 8)?;
        fit("the length of all texts of a unit", self.out.strings.len() as u64, u64::from(u32::MAX) / 2)?;
        Ok(Unit { name: self.name, words: self.out.words, strings: self.out.strings, debug: self.debug })
    }
}

/// Collects words and bytes.
#[derive(Debug, Default)]
pub(crate) struct Encoder {
    words: Vec<u32>,
    strings: Vec<u8>,
    depth: usize,
}

impl Encoder {
    /// One operand alone, as in the alias table: its kind and its words and bytes.
    pub(crate) fn single(node: &Node) -> Result<(u8, Vec<u32>, Vec<u8>), EncodeError> {
        let mut out = Self::default();
        out.operand(node, Role::Expression)?;
        Ok((Kind::of(node) as u8, out.words, out.strings))
    }

    /// Adds a word.
    pub(crate) fn word(&mut self, word: u32) {
        self.words.push(word);
    }

    /// Adds a text to the pool.
    pub(crate) fn text(&mut self, bytes: &[u8]) {
        self.strings.extend_from_slice(bytes);
    }

    /// Adds an operand whose kind the word before announces.
    pub(crate) fn operand(&mut self, node: &Node, role: Role) -> Result<(), EncodeError> {
        if !role.admits(node) {
            return Err(Problem::Misplaced(verify::describe(node)).into());
        }
        match Kind::of(node) {
            Kind::Node => self.node(node, Mark::None),
            _ => self.constant(node),
        }
    }

    fn node(&mut self, node: &Node, mark: Mark) -> Result<(), EncodeError> {
        if self.depth == MAX_DEPTH {
            return Err(Problem::TooDeep.into());
        }
        self.depth += 1;
        let stored = layout::store(node, mark as u32, self);
        self.depth -= 1;
        stored
    }

    /// Adds the raw words of a constant.
    fn constant(&mut self, node: &Node) -> Result<(), EncodeError> {
        match *node {
            Node::Long(value) => self.word(value.cast_unsigned()),
            Node::Single(value) if value.is_finite() => self.word(value.to_bits()),
            Node::Double(value) if value.is_finite() => {
                let bits = value.to_bits();
                self.word(bits as u32);
                self.word((bits >> 32) as u32);
            }
            _ => return Err(Problem::NotFinite.into()),
        }
        Ok(())
    }

    fn instruction(&mut self, separator: Separator, command: CommandId, items: &[Item]) -> Result<(), EncodeError> {
        let opcode = fit("an opcode", u64::from(command.0), 1023)?;
        let slot = |place: usize| {
            items
                .get(place)
                .map_or(Slot::default(), |item| Slot { kind: Kind::of(&item.node) as u32, mark: item.mark as u32 })
        };
        let count = u32::try_from(items.len()).unwrap_or(MANY).min(MANY);
        let head = CommandWord { separator: separator as u32, opcode, count, slots: std::array::from_fn(slot) };
        self.word(head.pack());
        for (place, item) in items.iter().enumerate() {
            match (place < SLOTS, Kind::of(&item.node)) {
                (true, _) => self.operand(&item.node, Role::Item)?,
                (false, Kind::Node) => self.node(&item.node, item.mark)?,
                (false, kind) => self.wrapped(&item.node, kind, item.mark)?,
            }
        }
        if count == MANY {
            self.word(END);
        }
        Ok(())
    }

    /// Adds a constant that has no slot in the command word.
    fn wrapped(&mut self, node: &Node, kind: Kind, mark: Mark) -> Result<(), EncodeError> {
        let mut word = FieldWriter { word: layout::CONST | (mark as u32) << TAG_BITS, at: FIRST_FIELD };
        word.put(kind as u32, Kind::BITS);
        self.word(word.word);
        self.constant(node)
    }
}
