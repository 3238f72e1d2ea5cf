//! Words to instructions: the verifier. What it lets through has exactly one encoding, and everything in it is known to the catalogue.

use crate::MAX_DEPTH;
use crate::error::{ImageError, Problem};
use crate::field::{Code, Kind};
use crate::instruction::{Instruction, Item, Mark, Separator};
use crate::layout::{self, CONST, CommandWord, END, FIRST_FIELD, FieldReader, MANY, MARK_BITS, SLOTS, TAG_BITS};
use crate::node::{Node, Role};
use crate::unit::Unit;
use crate::verify::{self, Labels};
use acrc_catalog::CommandId;

impl Unit {
    /// The statements of the unit, verified: every code is known, every word has its one valid form, all texts and labels are there.
    ///
    /// # Errors
    /// [`ImageError::Word`] with the first word that is wrong. No words make it panic or use memory out of proportion to their number.
    pub fn decode(&self) -> Result<Vec<Instruction>, ImageError> {
        let mut input = Decoder::new(&self.words, &self.strings);
        let (mut instructions, mut labels, mut after_then) = (Vec::new(), Labels::default(), false);
        while !input.at_end() {
            let instruction = input.instruction().map_err(|problem| self.problem(input.last(), problem))?;
            let Instruction { address, separator, command, ref items } = instruction;
            verify::statement(separator, after_then, command, items)
                .map_err(|problem| self.problem(address, problem))?;
            labels.add_at(address, command, items);
            after_then = verify::opens_then(command, items);
            instructions.push(instruction);
        }
        labels.check().map_err(|(address, problem)| self.problem(address, problem))?;
        input.finish().map_err(|problem| self.problem(input.last(), problem))?;
        Ok(instructions)
    }

    fn problem(&self, address: u32, problem: Problem) -> ImageError {
        ImageError::Word { unit: self.name, address, problem }
    }
}

/// Reads words and texts in the order of the stream.
pub(crate) struct Decoder<'a> {
    words: &'a [u32],
    at: usize,
    strings: &'a [u8],
    depth: usize,
}

impl<'a> Decoder<'a> {
    /// At the start of a stream.
    pub(crate) fn new(words: &'a [u32], strings: &'a [u8]) -> Self {
        Self { words, at: 0, strings, depth: 0 }
    }

    /// Are all words read?
    pub(crate) fn at_end(&self) -> bool {
        self.at == self.words.len()
    }

    /// Address of the word read last.
    pub(crate) fn last(&self) -> u32 {
        self.at.saturating_sub(1) as u32
    }

    /// Everything must have been read.
    pub(crate) fn finish(&self) -> Result<(), Problem> {
        match self.strings.len() {
            0 => Ok(()),
            left => Err(Problem::UnusedText(left)),
        }
    }

    fn word(&mut self) -> Result<u32, Problem> {
        let word = self.words.get(self.at).copied().ok_or(Problem::EndOfWords)?;
        self.at += 1;
        Ok(word)
    }

    /// The next text of the pool.
    pub(crate) fn text(&mut self, length: usize) -> Result<&'a [u8], Problem> {
        let missing = Problem::EndOfText { needed: length, left: self.strings.len() };
        let (text, rest) = self.strings.split_at_checked(length).ok_or(missing)?;
        self.strings = rest;
        Ok(text)
    }

    /// An operand whose kind the word before announced.
    pub(crate) fn operand(&mut self, kind: Kind, role: Role) -> Result<Node, Problem> {
        let node = match kind {
            Kind::Node => {
                let word = self.word()?;
                if mark_bits(word) != 0 {
                    return Err(Problem::NotCanonical(word));
                }
                self.node(word)?
            }
            _ => self.constant(kind)?,
        };
        if role.admits(&node) { Ok(node) } else { Err(Problem::Misplaced(verify::describe(&node))) }
    }

    fn node(&mut self, word: u32) -> Result<Node, Problem> {
        if self.depth == MAX_DEPTH {
            return Err(Problem::TooDeep);
        }
        self.depth += 1;
        let node = layout::load(word, self);
        self.depth -= 1;
        node
    }

    /// The raw words of a constant.
    fn constant(&mut self, kind: Kind) -> Result<Node, Problem> {
        let low = self.word()?;
        let node = match kind {
            Kind::Double => Node::Double(f64::from_bits(u64::from(low) | u64::from(self.word()?) << 32)),
            Kind::Single => Node::Single(f32::from_bits(low)),
            _ => Node::Long(low.cast_signed()),
        };
        match node {
            Node::Double(value) if !value.is_finite() => Err(Problem::NotFinite),
            Node::Single(value) if !value.is_finite() => Err(Problem::NotFinite),
            _ => Ok(node),
        }
    }

    fn instruction(&mut self) -> Result<Instruction, Problem> {
        let address = self.at as u32;
        let word = self.word()?;
        let head = CommandWord::unpack(word);
        let command =
            CommandId::from_code(head.opcode).ok_or(Problem::Unknown { what: "opcode", code: head.opcode })?;
        let separator = Separator::ALL
            .into_iter()
            .find(|&separator| separator as u32 == head.separator)
            .ok_or(Problem::NotCanonical(word))?;
        let mut items = Vec::new();
        for (place, slot) in head.slots.iter().enumerate() {
            if (place as u32) < head.count {
                let node = self.operand(Kind::from_bits(slot.kind), Role::Item)?;
                items.push(Item { node, mark: mark(slot.mark)? });
            } else if slot.kind != 0 || slot.mark != 0 {
                return Err(Problem::NotCanonical(word));
            }
        }
        self.further_items(head.count, &mut items)?;
        Ok(Instruction { address, separator, command, items })
    }

    /// The items that have no slot in the command word.
    fn further_items(&mut self, count: u32, items: &mut Vec<Item>) -> Result<(), Problem> {
        let mut left = if count == MANY { u32::MAX } else { count.saturating_sub(SLOTS as u32) };
        while left > 0 {
            let word = self.word()?;
            let tag = word & ((1 << TAG_BITS) - 1);
            if tag == END && count == MANY {
                let closes = word == END && items.len() >= MANY as usize;
                return if closes { Ok(()) } else { Err(Problem::NotCanonical(word)) };
            }
            let mark = mark(mark_bits(word))?;
            let node = if tag == CONST { self.wrapped(word)? } else { self.node(word)? };
            items.push(Item { node, mark });
            left -= 1;
        }
        Ok(())
    }

    /// A constant that has no slot in the command word.
    fn wrapped(&mut self, word: u32) -> Result<Node, Problem> {
        let mut bits = FieldReader { rest: word >> FIRST_FIELD };
        let kind = Kind::from_bits(bits.take(Kind::BITS));
        if bits.rest != 0 || kind == Kind::Node {
            return Err(Problem::NotCanonical(word));
        }
        self.constant(kind)
    }
}

fn mark_bits(word: u32) -> u32 {
    (word >> TAG_BITS) & ((1 << MARK_BITS) - 1)
}

fn mark(code: u32) -> Result<Mark, Problem> {
    Mark::ALL.into_iter().find(|&mark| mark as u32 == code).ok_or(Problem::Unknown { what: "mark", code })
}
