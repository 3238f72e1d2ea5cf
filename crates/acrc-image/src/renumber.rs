//! The same text for another alias table: a controller that keeps programs over a download has one table for old and new ones.

use std::collections::BTreeSet;

use crate::encode::encode;
use crate::error::{ImageError, Problem};
use crate::instruction::Instruction;
use crate::node::Node;
use crate::unit::Unit;

impl Unit {
    /// The aliases that the unit refers to, by their places.
    ///
    /// # Errors
    /// As [`Unit::decode`].
    pub fn aliases(&self) -> Result<BTreeSet<u16>, ImageError> {
        let instructions = self.decode()?;
        let mut waiting: Vec<&Node> = instructions.iter().flat_map(|i| i.items.iter().map(|item| &item.node)).collect();
        let mut aliases = BTreeSet::new();
        while let Some(node) = waiting.pop() {
            if let Node::Alias { index, .. } = node {
                aliases.insert(*index);
            }
            waiting.extend(node.children());
        }
        Ok(aliases)
    }

    /// The unit with alias `n` replaced by alias `places[n]`. Addresses and places in the source stay.
    ///
    /// # Errors
    /// As [`Unit::decode`], and when the unit uses an alias that `places` does not have.
    pub fn renumber_aliases(&self, places: &[u16]) -> Result<Self, ImageError> {
        let mut instructions = self.decode()?;
        for instruction in &mut instructions {
            renumber(instruction, places).map_err(|problem| ImageError::Word {
                unit: self.name,
                address: instruction.address,
                problem,
            })?;
        }
        let encoded = encode(self.name, &instructions);
        let encoded = encoded.map_err(|_| ImageError::Malformed("a text cannot be stored with other aliases"))?;
        Ok(Self { debug: self.debug.clone(), ..encoded })
    }
}

fn renumber(instruction: &mut Instruction, places: &[u16]) -> Result<(), Problem> {
    let mut waiting: Vec<&mut Node> = instruction.items.iter_mut().map(|item| &mut item.node).collect();
    while let Some(node) = waiting.pop() {
        if let Node::Alias { index, .. } = node {
            let place = places.get(usize::from(*index));
            *index = *place.ok_or(Problem::NoSuchAlias { index: *index, aliases: places.len() })?;
        }
        waiting.extend(node.children_mut());
    }
    Ok(())
}
