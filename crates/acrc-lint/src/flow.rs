//! The ways through a section: which statement can be followed by which.

use acrc_analysis::{SectionIndex, walk};
use acrc_catalog::command;
use acrc_syntax::Tree;
use acrc_syntax::ast::{Argument, Expr, Separator, Statement, StatementKind};
use acrc_syntax::blocks::Block;

/// What the statements of a section can reach.
pub(crate) struct Flow {
    /// Index of the first statement of the section.
    start: u32,
    /// By statement: the end of the text is reached without a GOTO.
    falls_off: Vec<bool>,
    /// By statement: the end of the text is reached somehow.
    reaches_end: Vec<bool>,
    /// By statement: a RETURN or END is reached.
    reaches_stop: Vec<bool>,
}

/// A step from one statement to another, both counted from the start of the section.
#[derive(Clone, Copy)]
struct Step {
    from: u32,
    to: u32,
    /// It is a GOTO.
    jump: bool,
}

impl Flow {
    /// Follows all ways through `section`, whose blocks must be balanced.
    pub(crate) fn new(tree: &Tree, section: &SectionIndex) -> Self {
        let mut graph = Graph::new(tree, section);
        let count = graph.count;
        for at in 0..count {
            graph.add_steps(at);
        }
        graph.add_jumps();
        let stops: Vec<u32> = (0..count).filter(|at| graph.stops(*at)).collect();
        let back = BackSteps::new(&graph.steps, count);
        Self {
            start: section.section.statements.start,
            falls_off: back.reaching(&[count], false),
            reaches_end: back.reaching(&[count], true),
            reaches_stop: back.reaching(&stops, true),
        }
    }

    /// Whether a subroutine that begins at statement `entry` can run off the end of the text: straight on, or by a
    /// jump when it has no other end.
    pub(crate) fn runs_off_the_end(&self, entry: u32) -> bool {
        let at = entry.saturating_sub(self.start) as usize;
        let is = |set: &[bool]| set.get(at).copied().unwrap_or(false);
        is(&self.falls_off) || (is(&self.reaches_end) && !is(&self.reaches_stop))
    }
}

struct Graph<'a> {
    tree: &'a Tree,
    section: &'a SectionIndex,
    start: u32,
    count: u32,
    steps: Vec<Step>,
}

impl<'a> Graph<'a> {
    fn new(tree: &'a Tree, section: &'a SectionIndex) -> Self {
        let range = &section.section.statements;
        let count = range.end.saturating_sub(range.start);
        Self { tree, section, start: range.start, count, steps: Vec::with_capacity(count as usize + 1) }
    }

    fn statement(&self, at: u32) -> Option<&'a Statement> {
        self.tree.statements().get((self.start + at) as usize)
    }

    fn stops(&self, at: u32) -> bool {
        matches!(self.statement(at).map(|s| &s.kind), Some(StatementKind::Command(c)) if c.id == command::RETURN || c.id == command::END)
    }

    /// Adds where the statement `at` can go.
    fn add_steps(&mut self, at: u32) {
        let Some(statement) = self.statement(at) else { return };
        match &statement.kind {
            StatementKind::If(head) if head.then.is_some() => {
                self.go_on(at, at + 1);
                let next_line = self.first_of_next_line(at);
                self.go_on(at, next_line);
            }
            StatementKind::If(_) => self.add_branch(at),
            StatementKind::For(_) => self.add_loop(at, false),
            StatementKind::Command(command) => match command.id {
                // Jumps are added from the index of the section.
                command::RETURN | command::END | command::GOTO => {}
                command::BREAK => self.add_break(at),
                command::ELSEIF | command::ELSE_IF => self.add_branch(at),
                command::WHILE => self.add_loop(at, command.arguments.iter().any(always_true)),
                command::NEXT | command::WEND => self.add_back(at),
                _ => self.go_on(at, at + 1),
            },
            _ => self.go_on(at, at + 1),
        }
    }

    fn step(&mut self, from: u32, to: u32, jump: bool) {
        self.steps.push(Step { to: to.min(self.count), from, jump });
    }

    /// On to `to` in the order of the text. Whoever comes to an ELSE or ELSEIF that way leaves the block.
    fn go_on(&mut self, from: u32, to: u32) {
        let block = self.block_with(to).filter(|block| block.branches.contains(&(self.start + to)));
        match block {
            Some(block) => self.step(from, self.behind(block), false),
            None => self.step(from, to, false),
        }
    }

    /// IF, ELSEIF: into the branch, or on to the next condition, the ELSE or the ENDIF.
    fn add_branch(&mut self, at: u32) {
        self.go_on(at, at + 1);
        let Some(block) = self.block_with(at) else { return };
        let here = self.start + at;
        let next = block.branches.iter().copied().find(|branch| *branch > here).or(block.closer);
        if let Some(next) = next {
            self.step(at, next.saturating_sub(self.start), false);
        }
    }

    /// FOR, WHILE: into the loop, and past it.
    fn add_loop(&mut self, at: u32, endless: bool) {
        self.go_on(at, at + 1);
        if !endless && let Some(block) = self.block_with(at) {
            self.step(at, self.behind(block), false);
        }
    }

    /// NEXT, WEND: back to the test.
    fn add_back(&mut self, at: u32) {
        if let Some(block) = self.block_with(at) {
            self.step(at, block.opener.saturating_sub(self.start), false);
        }
    }

    fn add_break(&mut self, at: u32) {
        match self.section.blocks.enclosing_loop(self.start + at) {
            Some(block) => self.step(at, self.behind(block), false),
            None => self.go_on(at, at + 1),
        }
    }

    fn add_jumps(&mut self) {
        for jump in self.section.jumps.iter().filter(|jump| !jump.call) {
            if let Some(to) = jump.to {
                self.step(jump.statement.saturating_sub(self.start), to.saturating_sub(self.start), true);
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

    fn first_of_next_line(&self, at: u32) -> u32 {
        let continues = |at: &u32| self.statement(*at).is_some_and(|statement| statement.separator != Separator::Line);
        (at + 1..self.count).find(|at| !continues(at)).unwrap_or(self.count)
    }
}

/// The steps by where they lead.
struct BackSteps {
    /// By statement: where its steps begin in `steps`; the next entry is where they end.
    first: Vec<u32>,
    /// Where they come from, and whether by a GOTO.
    steps: Vec<(u32, bool)>,
}

impl BackSteps {
    /// Sorts the steps between `count` statements, and the end behind them, by counting.
    fn new(steps: &[Step], count: u32) -> Self {
        let mut first = vec![0_u32; count as usize + 3];
        for step in steps {
            if let Some(after) = first.get_mut(step.to as usize + 2) {
                *after += 1;
            }
        }
        let mut sum = 0;
        for place in &mut first {
            sum += *place;
            *place = sum;
        }
        let mut sorted = vec![(0, false); steps.len()];
        for step in steps {
            if let Some(next) = first.get_mut(step.to as usize + 1) {
                if let Some(place) = sorted.get_mut(*next as usize) {
                    *place = (step.from, step.jump);
                }
                *next += 1;
            }
        }
        Self { first, steps: sorted }
    }

    fn leading_to(&self, to: u32) -> &[(u32, bool)] {
        let bound = |at: usize| self.first.get(at).map_or(self.steps.len(), |place| *place as usize);
        self.steps.get(bound(to as usize)..bound(to as usize + 1)).unwrap_or_default()
    }

    /// The statements from which one of `goals` can be reached.
    fn reaching(&self, goals: &[u32], with_jumps: bool) -> Vec<bool> {
        let mut reached = vec![false; self.first.len()];
        let mut open: Vec<u32> = goals.to_vec();
        while let Some(goal) = open.pop() {
            match reached.get_mut(goal as usize) {
                Some(seen) if !*seen => *seen = true,
                _ => continue,
            }
            let steps = self.leading_to(goal).iter();
            open.extend(steps.filter(|(_, jump)| with_jumps || !jump).map(|(from, _)| *from));
        }
        reached
    }
}

/// A condition that is a number other than zero.
fn always_true(argument: &Argument) -> bool {
    let constant = |expr: &Expr| walk::literal(expr).is_some_and(|value| value != 0.0);
    matches!(argument, Argument::Value(expr) if constant(expr))
}
