//! Statements to instructions.

use std::ops::Range;

use acrc_catalog::{CommandId, Keyword, Shape, command};
use acrc_diagnostics::Span;
use acrc_image::{EncodeError, Instruction, Item, Mark, Node, Problem, Separator, UnitBuilder, UnitName};
use acrc_syntax::Tree;
use acrc_syntax::ast::{self, Argument, Command, Dim, For, Input, Print, PrintSeparator, Statement, StatementKind};

use crate::encoder::Encoder;
use crate::error::{CompileError, CompileErrorKind};
use crate::scope::{AnyNames, Scope};
use crate::text;

/// Encodes statements by themselves, as a terminal needs them. Addresses count from the first of them.
///
/// # Errors
/// All mistakes, with file 0.
pub fn encode_statements(
    tree: &Tree,
    text: &str,
    range: Range<u32>,
    scope: &dyn Scope,
) -> Result<Vec<Instruction>, Vec<CompileError>> {
    let mut encoder = Encoder::new(text, scope);
    let mut builder = UnitBuilder::new(UnitName::Boot);
    let mut instructions = Vec::new();
    for statement in tree.statements().get(range.start as usize..range.end as usize).unwrap_or_default() {
        let Some((command, items)) = encoder.statement(statement) else { continue };
        let separator = separator(statement.separator);
        if let Some(address) = encoder.push(&mut builder, statement.span, separator, command, &items) {
            instructions.push(Instruction { address, separator, command, items });
        }
    }
    if encoder.errors.is_empty() {
        return Ok(instructions);
    }
    Err(encoder.errors.into_iter().map(|(span, kind)| CompileError { file: 0, span, kind }).collect())
}

/// The command and the items of one statement, for who wants to know what it costs and not where its words lie.
///
/// # Errors
/// The mistakes in it.
pub fn encode_statement(
    text: &str,
    statement: &Statement,
    scope: &dyn Scope,
) -> Result<(CommandId, Vec<Item>), Vec<CompileErrorKind>> {
    let mut encoder = Encoder::new(text, scope);
    match encoder.statement(statement) {
        Some(encoded) if encoder.errors.is_empty() => Ok(encoded),
        _ => Err(encoder.errors.into_iter().map(|(_, kind)| kind).collect()),
    }
}

/// What statements that follow each other take of program memory when they are stored. Names that nothing defines yet cost what others cost.
///
/// # Errors
/// The mistakes in them.
pub fn stored_bytes(text: &str, statements: &[Statement]) -> Result<u32, Vec<CompileErrorKind>> {
    let mut encoder = Encoder::new(text, &AnyNames);
    let mut builder = UnitBuilder::new(UnitName::Boot);
    for statement in statements {
        if let Some((command, items)) = encoder.statement(statement) {
            encoder.push(&mut builder, statement.span, separator(statement.separator), command, &items);
        }
    }
    if encoder.errors.is_empty() {
        return Ok(builder.memory());
    }
    Err(encoder.errors.into_iter().map(|(_, kind)| kind).collect())
}

/// How a statement is set off.
pub(crate) fn separator(separator: ast::Separator) -> Separator {
    match separator {
        ast::Separator::Line => Separator::Line,
        ast::Separator::Colon => Separator::Colon,
        ast::Separator::Blank => Separator::Blank,
        ast::Separator::Then => Separator::Then,
    }
}

impl Encoder<'_> {
    /// Adds a statement to a unit and notes what does not fit into words. Gives its address.
    pub(crate) fn push(
        &mut self,
        unit: &mut UnitBuilder,
        span: Span,
        separator: Separator,
        command: CommandId,
        items: &[Item],
    ) -> Option<u32> {
        let kind = match unit.push(separator, command, items) {
            Ok(address) => return Some(address),
            Err(EncodeError::TooLarge { what, value, limit }) => CompileErrorKind::Limit { what, value, limit },
            Err(EncodeError::Invalid(Problem::TooDeep)) => CompileErrorKind::TooDeep,
            Err(other) => CompileErrorKind::Unstorable(other),
        };
        // A statement with a mistake holds a zero in its place, which the words may refuse too.
        if !self.errors.iter().any(|&(mistake, _)| Span::cover(span, mistake) == span) {
            self.errors.push((span, kind));
        }
        None
    }

    /// The command and the items of a statement; `None` when it cannot be read.
    pub(crate) fn statement(&mut self, statement: &Statement) -> Option<(CommandId, Vec<Item>)> {
        Some(match &statement.kind {
            StatementKind::Remark(span) => (command::REM, vec![Node::string(text::remark(self.slice(*span))).into()]),
            StatementKind::Label(label) => (command::LABEL, vec![self.string(label.name).into()]),
            StatementKind::Assign(assign) => (
                command::ASSIGNMENT,
                vec![self.expression(&assign.target).into(), self.expression(&assign.value).into()],
            ),
            StatementKind::If(statement) => {
                let mark = if statement.then.is_some() { Mark::Comma } else { Mark::None };
                (command::IF, vec![Item { node: self.expression(&statement.condition), mark }])
            }
            StatementKind::For(statement) => (command::FOR, self.counted_loop(statement)),
            StatementKind::Print(print) => (command::PRINT, self.print(print)),
            StatementKind::Input(input) => (command::INPUT, self.input(input)),
            StatementKind::Dim(dim) => (dim.id, self.dim(dim)),
            StatementKind::Define(define) => {
                let name = self.slice(define.name);
                let node = match self.scope.alias(name) {
                    Some(index) => Node::Alias { index, parens: 0 },
                    None => self.mistake(define.name, CompileErrorKind::UndefinedAlias(name.to_owned())),
                };
                (command::DEFINE, vec![node.into()])
            }
            StatementKind::Command(command) => (command.id, self.command(command)),
            StatementKind::Error => {
                self.mistake(statement.span, CompileErrorKind::Syntax);
                return None;
            }
        })
    }

    fn counted_loop(&mut self, statement: &For) -> Vec<Item> {
        let parts = [&statement.variable, &statement.start, &statement.end].into_iter().chain(&statement.step);
        parts.map(|part| self.expression(part).into()).collect()
    }

    /// Device, picture, values; each with the mark behind it.
    fn print(&mut self, print: &Print) -> Vec<Item> {
        let mut items = Vec::new();
        if let Some(device) = &print.device {
            let alone = print.using.is_none() && print.items.is_empty();
            items.push(Item { node: self.device(device), mark: if alone { Mark::None } else { Mark::Comma } });
        }
        if let Some(picture) = &print.using {
            items.push(Node::Word { keyword: Keyword::Using, index: None }.into());
            let mark = if print.items.is_empty() { Mark::None } else { Mark::Semicolon };
            items.push(Item { node: self.expression(picture), mark });
        }
        items.extend(
            print
                .items
                .iter()
                .map(|item| Item { node: self.expression(&item.value), mark: item.separator.map_or(Mark::None, mark) }),
        );
        items
    }

    /// Device, prompt, variables; a semicolon behind the last variable keeps the cursor on the line.
    fn input(&mut self, input: &Input) -> Vec<Item> {
        let mut items = Vec::new();
        if let Some(device) = &input.device {
            items.push(Item { node: self.device(device), mark: Mark::Comma });
        }
        if let Some((prompt, separator)) = &input.prompt {
            items.push(Item { node: self.expression(prompt), mark: mark(*separator) });
        }
        items
            .extend(input.variables.iter().map(|variable| Item { node: self.expression(variable), mark: Mark::Comma }));
        if let Some(last) = items.last_mut() {
            last.mark = if input.stay { Mark::Semicolon } else { Mark::None };
        }
        items
    }

    /// The number of the block, marked by a semicolon, and the sizes.
    fn dim(&mut self, dim: &Dim) -> Vec<Item> {
        let number = dim.index.as_ref().map(|index| Item { node: self.unwrapped(index), mark: Mark::Semicolon });
        number.into_iter().chain(dim.sizes.iter().map(|size| Item::from(self.expression(size)))).collect()
    }

    fn command(&mut self, command: &Command) -> Vec<Item> {
        let prefix = command.prefix.as_ref().map(|prefix| Item::from(self.object(prefix, true)));
        // The `AS` of an `OPEN` is part of its form.
        let silent = |argument: &&Argument| !matches!(argument, Argument::Word(word) if word.keyword == Keyword::As);
        let arguments: Vec<&Argument> = match command.id.info().shape {
            Shape::Open => command.arguments.iter().filter(silent).collect(),
            _ => command.arguments.iter().collect(),
        };
        prefix.into_iter().chain(arguments.into_iter().map(|argument| Item::from(self.argument(argument)))).collect()
    }
}

fn mark(separator: PrintSeparator) -> Mark {
    match separator {
        PrintSeparator::Comma => Mark::Comma,
        PrintSeparator::Semicolon => Mark::Semicolon,
    }
}
