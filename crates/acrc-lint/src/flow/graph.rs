//! Which statement of a section can be followed by which.

use acrc_analysis::{SectionIndex, walk};
use acrc_catalog::{CommandId, Keyword, ObjectKind, command};
use acrc_syntax::Tree;
use acrc_syntax::ast::{Argument, Command, Expr, Separator, Statement, StatementKind};
use acrc_syntax::blocks::Block;
use acrc_syntax::units::Level;

use super::steps::{Step, Via};

/// The statements that begin another branch of a block.
const BRANCHES: [CommandId; 3] = [command::ELSE, command::ELSEIF, command::ELSE_IF];

/// Collects the steps of a section whose blocks are balanced.
pub(super) struct Graph<'a> {
    tree: &'a Tree,
    section: &'a SectionIndex,
    start: u32,
    pub(super) count: u32,
    pub(super) steps: Vec<Step>,
    /// By statement: the first one of the next line.
    next_line: Vec<u32>,
    /// Every statement could be read, and every jump leads somewhere.
    pub(super) is_complete: bool,
}

impl<'a> Graph<'a> {
    pub(super) fn new(tree: &'a Tree, section: &'a SectionIndex) -> Self {
        let range = &section.section.statements;
        let count = range.end.saturating_sub(range.start);
        let steps = Vec::with_capacity(count as usize + section.jumps.len() + 1);
        let is_complete = section.jumps.iter().all(|jump| jump.to.is_some());
        let mut graph = Self { tree, section, start: range.start, count, steps, next_line: Vec::new(), is_complete };
        graph.find_lines();
        for at in 0..count {
            graph.add_steps(at);
        }
        graph.add_jumps();
        graph
    }

    pub(super) fn statement(&self, at: u32) -> Option<&'a Statement> {
        self.tree.statements().get((self.start + at) as usize)
    }

    fn find_lines(&mut self) {
        self.next_line = vec![self.count; self.count as usize];
        let mut next = self.count;
        for at in (0..self.count).rev() {
            if let Some(place) = self.next_line.get_mut(at as usize) {
                *place = next;
            }
            if self.statement(at).is_some_and(|statement| statement.separator == Separator::Line) {
                next = at;
            }
        }
    }

    /// Adds where the statement `at` can go.
    fn add_steps(&mut self, at: u32) {
        let Some(statement) = self.statement(at) else { return };
        match &statement.kind {
            StatementKind::If(head) if head.then.is_some() => {
                self.go_on(at, at + 1, Via::Straight);
                let next_line = self.next_line.get(at as usize).copied().unwrap_or(self.count);
                self.go_on(at, next_line, Via::Straight);
            }
            StatementKind::If(_) => self.add_branch(at),
            StatementKind::For(_) => self.add_loop(at, false),
            StatementKind::Command(command) => self.add_command(at, command),
            StatementKind::Error => {
                self.is_complete = false;
                self.go_on(at, at + 1, Via::Doubtful);
            }
            _ => self.go_on(at, at + 1, Via::Straight),
        }
    }

    fn add_command(&mut self, at: u32, command: &Command) {
        match command.id {
            // Jumps are added from the index of the section.
            command::RETURN | command::END | command::GOTO => {}
            command::GOSUB => self.go_on(at, at + 1, Via::Returned),
            command::BREAK => self.add_break(at),
            command::ELSEIF | command::ELSE_IF => self.add_branch(at),
            command::WHILE => self.add_loop(at, command.arguments.iter().any(always_true)),
            command::NEXT | command::WEND => self.add_back(at),
            _ if may_end(command, self.section.section.level) => self.go_on(at, at + 1, Via::Doubtful),
            _ => self.go_on(at, at + 1, Via::Straight),
        }
    }

    fn step(&mut self, from: u32, to: u32, via: Via) {
        self.steps.push(Step { from, to: to.min(self.count), via });
    }

    /// On to `to` in the order of the text. Whoever comes to an ELSE or ELSEIF that way leaves the block.
    fn go_on(&mut self, from: u32, to: u32, via: Via) {
        let is_branch = self.statement(to).is_some_and(|statement| match &statement.kind {
            StatementKind::Command(command) => BRANCHES.contains(&command.id),
            _ => false,
        });
        let block = if is_branch && to < self.count { self.block_with(to) } else { None };
        match block {
            Some(block) => self.step(from, self.behind(block), via),
            None => self.step(from, to, via),
        }
    }

    /// IF, ELSEIF: into the branch, or on to the next condition, the ELSE or the ENDIF.
    fn add_branch(&mut self, at: u32) {
        self.go_on(at, at + 1, Via::Straight);
        let Some(block) = self.block_with(at) else { return };
        let here = self.start + at;
        let place = block.branches.partition_point(|branch| *branch <= here);
        if let Some(next) = block.branches.get(place).copied().or(block.closer) {
            self.step(at, next.saturating_sub(self.start), Via::Straight);
        }
    }

    /// FOR, WHILE: into the loop, and past it.
    fn add_loop(&mut self, at: u32, endless: bool) {
        self.go_on(at, at + 1, Via::Straight);
        if !endless && let Some(block) = self.block_with(at) {
            self.step(at, self.behind(block), Via::Straight);
        }
    }

    /// NEXT, WEND: back to the test.
    fn add_back(&mut self, at: u32) {
        if let Some(block) = self.block_with(at) {
            self.step(at, block.opener.saturating_sub(self.start), Via::Straight);
        }
    }

    fn add_break(&mut self, at: u32) {
        match self.section.blocks.enclosing_loop(self.start + at) {
            Some(block) => self.step(at, self.behind(block), Via::Straight),
            None => self.go_on(at, at + 1, Via::Straight),
        }
    }

    fn add_jumps(&mut self) {
        for jump in &self.section.jumps {
            if let Some(to) = jump.to {
                let via = if jump.call { Via::Call } else { Via::Jump };
                self.step(jump.statement.saturating_sub(self.start), to.saturating_sub(self.start), via);
            }
        }
    }

    /// The block that statement `at` opens, divides or closes.
    fn block_with(&self, at: u32) -> Option<&'a Block> {
        self.section.blocks.block_of(self.start + at)
    }

    fn behind(&self, block: &Block) -> u32 {
        block.closer.map_or(self.count, |closer| closer.saturating_sub(self.start) + 1)
    }
}

/// A condition that is a number other than zero.
fn always_true(argument: &Argument) -> bool {
    let constant = |expr: &Expr| walk::literal(expr).is_some_and(|value| value != 0.0);
    matches!(argument, Argument::Value(expr) if constant(expr))
}

/// Whether a program of `level` may end, or begin anew, with this command.
fn may_end(command: &Command, level: Level) -> bool {
    match command.id {
        command::REBOOT => true,
        command::HALT | command::NEW | command::RUN | command::LRUN => {
            command.arguments.is_empty() || command.arguments.iter().any(|argument| names(argument, level))
        }
        _ => false,
    }
}

/// Whether `ALL`, `PROG1` or `PLC1` includes the program of `level`. A number that is not written may be any.
fn names(argument: &Argument, level: Level) -> bool {
    let own = match level {
        Level::Program(number) => Some((ObjectKind::Prog, number)),
        Level::Plc(number) => Some((ObjectKind::Plc, number)),
        Level::System => None,
    };
    match argument {
        Argument::Object(object) => own.is_some_and(|(kind, number)| {
            object.kind == kind && object.index.is_none_or(|index| index == u32::from(number))
        }),
        Argument::Word(word) => word.keyword == Keyword::All,
        _ => true,
    }
}
