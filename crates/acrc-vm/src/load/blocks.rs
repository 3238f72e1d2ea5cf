//! The blocks of a program: which statement closes, divides or leaves which (guide, "Program Flow").
//!
//! Blocks are matched by their nesting in the text, once, at load. Nothing about them remains at run time, so a `GOTO`
//! into or out of a block cannot leave one open.

use acrc_catalog::{CommandId, command};
use acrc_image::{Instruction, Mark, Separator};

use super::error::LoadErrorKind;

/// What a statement means to the flow of the program. Numbers are places in the list of instructions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Role {
    /// Nothing.
    #[default]
    Plain,
    /// `IF (c) THEN`: `next_line` is reached when the condition is false.
    IfThen { next_line: usize },
    /// `IF (c)` of a block: `otherwise` is its next branch or its end.
    If { otherwise: usize },
    /// `ELSEIF (c)`: `end` is reached from the branch before it.
    ElseIf { otherwise: usize, end: usize },
    /// `ELSE`
    Else { end: usize },
    /// `WHILE (c)`
    While { end: usize },
    /// `WEND`
    Wend { start: usize },
    /// `FOR`
    For { index: u16, end: usize },
    /// `NEXT`
    Next { start: usize, index: u16 },
    /// `BREAK`; `None` outside of a loop.
    Break { end: Option<usize> },
}

/// The last instruction that depends on one: the end of the block that it opens or divides, the end of the line of a one-line `IF`.
pub(super) fn last_dependent(roles: &[Role], place: usize) -> usize {
    match roles.get(place) {
        Some(Role::IfThen { next_line }) => next_line.saturating_sub(1),
        Some(Role::If { otherwise }) => match roles.get(*otherwise) {
            Some(Role::ElseIf { end, .. } | Role::Else { end }) => *end,
            _ => *otherwise,
        },
        Some(Role::ElseIf { end, .. } | Role::While { end } | Role::For { end, .. }) => *end,
        _ => place,
    }
}

/// A block that is not closed yet.
struct Open {
    command: CommandId,
    start: usize,
    /// The branch of an `IF` that waits for its next branch, and the branches that wait for the end.
    branches: Vec<usize>,
    has_else: bool,
    breaks: Vec<usize>,
    /// It stands behind `THEN`, on this line.
    behind_then: bool,
}

/// Kinds of blocks and the words that messages use.
const fn closer_name(opener: CommandId) -> &'static str {
    match opener {
        command::FOR => "NEXT",
        command::WHILE => "WEND",
        _ => "ENDIF",
    }
}

/// Finds the role of every instruction. The error comes with the place of the statement at fault.
pub(super) fn roles(instructions: &[Instruction]) -> Result<Vec<Role>, (LoadErrorKind, usize)> {
    let mut matcher =
        Matcher { roles: vec![Role::Plain; instructions.len()], open: Vec::new(), behind_then: false, loops: 0 };
    for (place, instruction) in instructions.iter().enumerate() {
        if instruction.separator == Separator::Line {
            matcher.end_line()?;
        }
        matcher.statement(place, instruction, instructions).map_err(|kind| (kind, place))?;
    }
    matcher.end_line()?;
    match matcher.open.pop() {
        None => Ok(matcher.roles),
        Some(open) => Err((not_closed(&open), open.start)),
    }
}

fn not_closed(open: &Open) -> LoadErrorKind {
    LoadErrorKind::NotClosed { opener: open.command, closer: closer_name(open.command) }
}

struct Matcher {
    roles: Vec<Role>,
    open: Vec<Open>,
    /// The rest of this line depends on `THEN`.
    behind_then: bool,
    loops: u16,
}

impl Matcher {
    /// Blocks behind `THEN` have to end on their line.
    fn end_line(&mut self) -> Result<(), (LoadErrorKind, usize)> {
        self.behind_then = false;
        match self.open.last() {
            Some(open) if open.behind_then => Err((LoadErrorKind::BlockAcrossThen(open.command), open.start)),
            _ => Ok(()),
        }
    }

    fn statement(&mut self, place: usize, instruction: &Instruction, all: &[Instruction]) -> Result<(), LoadErrorKind> {
        match instruction.command {
            command::IF if instruction.items.first().is_some_and(|item| item.mark == Mark::Comma) => {
                let line_starts = |instruction: &Instruction| instruction.separator == Separator::Line;
                let rest = all.iter().skip(place + 1).position(line_starts);
                let next_line = rest.map_or(all.len(), |distance| place + 1 + distance);
                self.set(place, Role::IfThen { next_line });
                self.behind_then = true;
            }
            opener @ (command::IF | command::WHILE | command::FOR) => self.open(place, opener),
            closer @ (command::ELSEIF | command::ELSE_IF | command::ELSE) => self.branch(place, closer)?,
            command::ENDIF => self.end_if(place)?,
            command::WEND => self.wend(place)?,
            command::NEXT => self.next(place)?,
            command::BREAK => self.leave(place),
            _ => {}
        }
        Ok(())
    }

    fn set(&mut self, place: usize, role: Role) {
        if let Some(slot) = self.roles.get_mut(place) {
            *slot = role;
        }
    }

    fn open(&mut self, place: usize, command: CommandId) {
        let behind_then = self.behind_then;
        let branches = vec![place];
        self.open.push(Open { command, start: place, branches, has_else: false, breaks: Vec::new(), behind_then });
    }

    /// The innermost open block, which a statement closes or divides.
    fn innermost(
        &mut self,
        closer: CommandId,
        opener: CommandId,
        name: &'static str,
    ) -> Result<&mut Open, LoadErrorKind> {
        let behind_then = self.behind_then;
        let enclosing = self.open.iter().any(|open| open.command == opener);
        match self.open.last_mut() {
            Some(open) if open.command == opener && open.behind_then == behind_then => Ok(open),
            Some(open) if open.command == opener => Err(LoadErrorKind::BlockAcrossThen(closer)),
            Some(open) if enclosing => Err(LoadErrorKind::Crossed { closer, inner: open.command }),
            _ => Err(LoadErrorKind::NotOpen { closer, opener: name }),
        }
    }

    fn branch(&mut self, place: usize, closer: CommandId) -> Result<(), LoadErrorKind> {
        let open = self.innermost(closer, command::IF, "IF")?;
        if open.has_else {
            return Err(LoadErrorKind::BehindElse(closer));
        }
        open.has_else = closer == command::ELSE;
        open.branches.push(place);
        Ok(())
    }

    fn end_if(&mut self, place: usize) -> Result<(), LoadErrorKind> {
        self.innermost(command::ENDIF, command::IF, "IF")?;
        let Some(open) = self.open.pop() else { return Ok(()) };
        let following = open.branches.iter().skip(1).copied().chain([place]);
        for (number, (branch, otherwise)) in open.branches.iter().copied().zip(following).enumerate() {
            let is_else = open.has_else && number + 1 == open.branches.len();
            let role = match number {
                0 => Role::If { otherwise },
                _ if is_else => Role::Else { end: place },
                _ => Role::ElseIf { otherwise, end: place },
            };
            self.set(branch, role);
        }
        self.inherit_breaks(open.breaks);
        Ok(())
    }

    fn wend(&mut self, place: usize) -> Result<(), LoadErrorKind> {
        self.innermost(command::WEND, command::WHILE, "WHILE")?;
        let Some(open) = self.open.pop() else { return Ok(()) };
        self.set(open.start, Role::While { end: place });
        self.set(place, Role::Wend { start: open.start });
        self.end_breaks(&open.breaks, place);
        Ok(())
    }

    fn next(&mut self, place: usize) -> Result<(), LoadErrorKind> {
        self.innermost(command::NEXT, command::FOR, "FOR")?;
        let Some(open) = self.open.pop() else { return Ok(()) };
        let index = self.loops;
        self.loops = self.loops.checked_add(1).ok_or(LoadErrorKind::TooManyLoops)?;
        self.set(open.start, Role::For { index, end: place });
        self.set(place, Role::Next { start: open.start, index });
        self.end_breaks(&open.breaks, place);
        Ok(())
    }

    fn leave(&mut self, place: usize) {
        self.set(place, Role::Break { end: None });
        if let Some(open) = self.open.last_mut() {
            open.breaks.push(place);
        }
    }

    fn end_breaks(&mut self, breaks: &[usize], end: usize) {
        for place in breaks {
            self.set(*place, Role::Break { end: Some(end) });
        }
    }

    /// A `BREAK` in an `IF` leaves the loop around it.
    fn inherit_breaks(&mut self, breaks: Vec<usize>) {
        if let Some(outer) = self.open.last_mut() {
            outer.breaks.extend(breaks);
        }
    }
}
