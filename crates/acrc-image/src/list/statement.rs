//! Statements as the lister writes them.

use acrc_catalog::{Command, Shape, command};

use super::Lister;
use crate::error::Problem;
use crate::instruction::{Instruction, Item, Mark};
use crate::node::Node;
use crate::text;

impl Lister<'_> {
    /// One statement.
    pub(super) fn statement(&mut self, instruction: &Instruction) -> Result<(), Problem> {
        let command = instruction.command.info();
        let items = instruction.items.as_slice();
        match (command.shape, items) {
            (Shape::Label, [item, ..]) => self.raw_text("_", item),
            (Shape::Text, [item, ..]) => self.raw_text(command.name, item),
            (Shape::LineNumber, [item, ..]) => self.expression(&item.node),
            (Shape::Assignment, [target, value]) => {
                self.expression(&target.node)?;
                self.out.push_str(" = ");
                self.expression(&value.node)
            }
            (Shape::If | Shape::Condition, [condition]) => {
                self.out.push_str(command.name);
                self.out.push(' ');
                self.condition(condition)
            }
            (Shape::For, items) => self.counted_loop(command, items),
            (Shape::Dim, items) => self.dim(command, items),
            (Shape::Input, items) => self.input(command, items),
            (Shape::Define, [item, ..]) => self.define(command, item),
            (Shape::Open, [path, device]) => {
                self.out.push_str(command.name);
                self.spaced(path)?;
                self.out.push_str(" AS");
                self.spaced(device)
            }
            _ => self.command(command, items),
        }
    }

    /// A word and the bytes of a text as they are.
    fn raw_text(&mut self, word: &str, item: &Item) -> Result<(), Problem> {
        self.out.push_str(word);
        match &item.node {
            Node::String { bytes, .. } => {
                self.out.push_str(&text::decode(bytes));
                Ok(())
            }
            other => self.expression(other),
        }
    }

    /// A condition always stands in parentheses; behind that of a one-line `IF` stands `THEN`.
    fn condition(&mut self, item: &Item) -> Result<(), Problem> {
        if item.node.is_constant() {
            self.parenthesised(&item.node)?;
        } else {
            self.expression(&item.node)?;
        }
        if item.mark == Mark::Comma {
            self.out.push_str(" THEN");
        }
        Ok(())
    }

    fn counted_loop(&mut self, command: &Command, items: &[Item]) -> Result<(), Problem> {
        self.out.push_str(command.name);
        for (item, before) in items.iter().zip([" ", " = ", " TO ", " STEP "]) {
            self.out.push_str(before);
            self.expression(&item.node)?;
        }
        Ok(())
    }

    /// The first item is the number of the block when a semicolon marks it.
    fn dim(&mut self, command: &Command, items: &[Item]) -> Result<(), Problem> {
        self.out.push_str(command.name);
        let (number, sizes) =
            items.split_at(usize::from(items.first().is_some_and(|item| item.mark == Mark::Semicolon)));
        if let [number] = number {
            self.index(&number.node)?;
        }
        if sizes.is_empty() { Ok(()) } else { self.tuple(sizes.iter().map(|item| &item.node)) }
    }

    /// A semicolon behind the last variable is the one behind the word.
    fn input(&mut self, command: &Command, items: &[Item]) -> Result<(), Problem> {
        self.out.push_str(command.name);
        let stays = items.last().is_some_and(|item| item.mark == Mark::Semicolon);
        if stays {
            self.out.push(';');
        }
        for (place, item) in items.iter().enumerate() {
            self.out.push(' ');
            self.item(&item.node)?;
            self.mark(if stays && place + 1 == items.len() { Mark::None } else { item.mark });
        }
        Ok(())
    }

    fn define(&mut self, command: &Command, item: &Item) -> Result<(), Problem> {
        self.out.push_str(command.name);
        self.spaced(item)?;
        let Node::Alias { index, .. } = item.node else { return Ok(()) };
        let aliases = self.aliases;
        if let Some(alias) = aliases.get(usize::from(index)) {
            self.out.push(' ');
            self.expression(&alias.target)?;
        }
        Ok(())
    }

    /// Every other command: prefix, words, items.
    fn command(&mut self, command: &Command, items: &[Item]) -> Result<(), Problem> {
        let mut words = if command.id == command::AXIS_MOVE { "" } else { command.name };
        let mut items = items;
        if let Some((first, rest)) = items.split_first()
            && let Node::Object { kind, prefix: true, .. } = first.node
        {
            self.item(&first.node)?;
            words = without_first(words, kind.name());
            if !words.is_empty() {
                self.out.push(' ');
            }
            items = rest;
        }
        if let Some(Item { node: Node::Object { kind, .. }, .. }) = items.first() {
            words = without_last(words, kind.name());
        }
        self.out.push_str(words);
        for item in items {
            self.spaced(item)?;
        }
        Ok(())
    }

    /// An item and its mark, set off from what is before it.
    fn spaced(&mut self, item: &Item) -> Result<(), Problem> {
        if !self.out.is_empty() && !self.out.ends_with([' ', '\n']) {
            self.out.push(' ');
        }
        self.item(&item.node)?;
        self.mark(item.mark);
        Ok(())
    }

    fn mark(&mut self, mark: Mark) {
        match mark {
            Mark::None => {}
            Mark::Comma => self.out.push(','),
            Mark::Semicolon => self.out.push(';'),
        }
    }

    /// One operand of a statement.
    pub(super) fn item(&mut self, node: &Node) -> Result<(), Problem> {
        match node {
            Node::LabelRef(ordinal) => {
                let unknown = Problem::NoSuchLabel { ordinal: *ordinal, labels: self.labels.len() };
                self.out.push_str(self.labels.get(usize::from(*ordinal)).ok_or(unknown)?);
            }
            Node::Axis { name, slash, value } => {
                self.out.push_str(&name.to_string());
                self.value(*slash, value.as_deref(), true)?;
            }
            Node::Object { kind, index, slash, value, .. } => {
                self.numbered(kind.name(), *index);
                self.value(*slash, value.as_deref(), index.is_none())?;
            }
            Node::Tuple(nodes) => self.tuple(nodes)?,
            Node::Word { keyword, index } => self.numbered(keyword.name(), *index),
            Node::Interpolation(command) => self.out.push_str(command.info().name),
            Node::Device(number) => {
                self.out.push('#');
                self.expression(number)?;
            }
            expression => self.expression(expression)?,
        }
        Ok(())
    }

    /// The value of an axis or an object. Numbers and parentheses may touch a name, but not another number.
    fn value(&mut self, slash: bool, value: Option<&Node>, touches: bool) -> Result<(), Problem> {
        if slash {
            self.out.push('/');
        }
        let Some(value) = value else { return Ok(()) };
        let closed = value.is_constant() || value.parens() > 0 || matches!(value, Node::Tuple(_));
        if !(closed && (touches || slash)) {
            self.out.push(' ');
        }
        self.item(value)
    }

    fn numbered(&mut self, word: &str, number: Option<u16>) {
        self.out.push_str(word);
        if let Some(number) = number {
            self.out.push_str(&number.to_string());
        }
    }
}

/// The words of a command whose first word is already written as its prefix: `ENC RES` behind `ENC0`.
fn without_first<'a>(words: &'a str, object: &str) -> &'a str {
    match words.strip_prefix(object) {
        Some("") => "",
        Some(rest) if rest.starts_with(' ') => rest.trim_start(),
        _ => words,
    }
}

/// The words of a command whose last word is written by its first item: `ATTACH AXIS` before `AXIS0`.
fn without_last<'a>(words: &'a str, object: &str) -> &'a str {
    match words.strip_suffix(object) {
        Some("") => "",
        Some(rest) if rest.ends_with(' ') => rest.trim_end(),
        _ => words,
    }
}
