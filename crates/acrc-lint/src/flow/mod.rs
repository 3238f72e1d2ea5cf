//! The ways through a program: what its statements can reach, with and without its subroutines.
//!
//! A [`Flow`] is built once for a program and shared by the rules ([`crate::Context::flow`]). Statements are named by
//! their index in the tree, as everywhere else. Everything here is linear in the length of the program.

mod components;
mod graph;
mod main_code;
mod steps;

use std::cell::OnceCell;

use acrc_analysis::SectionIndex;
use acrc_catalog::{CommandId, command};
use acrc_syntax::Tree;
use acrc_syntax::ast::{Statement, StatementKind};

pub(crate) use main_code::{Main, Way};

use graph::Graph;
use steps::{Adjacency, Via};

/// How many blocks around a statement are looked at. More are not written, and each would be passed for each statement.
pub(crate) const NESTING: usize = 64;

/// The ways through one program whose blocks are balanced.
pub(crate) struct Flow {
    /// Index of the first statement of the program.
    start: u32,
    /// Number of its statements; as a place, the end of its text.
    count: u32,
    /// Every statement could be read, and every jump leads somewhere.
    pub(crate) is_complete: bool,
    forward: Adjacency,
    back: Adjacency,
    /// The places of its RETURN.
    returns: Vec<u32>,
    /// The places of its END.
    ends: Vec<u32>,
    /// The places that a GOSUB goes to, sorted, each once.
    called: Vec<u32>,
    /// By statement: a RETURN can be reached.
    comes_back: Vec<bool>,
    exits: OnceCell<Exits>,
    /// By statement: a statement can be reached that may end the program, or that could not be read.
    may_stop: OnceCell<Vec<bool>>,
    main: OnceCell<Main>,
}

/// How the ways from each statement can end.
struct Exits {
    /// The end of the text is reached without a GOTO.
    falls_off: Vec<bool>,
    /// The end of the text is reached somehow.
    reaches_end: Vec<bool>,
    /// A RETURN or END is reached.
    reaches_stop: Vec<bool>,
}

impl Flow {
    /// Follows all ways through the program in `section`, whose blocks must be balanced.
    pub(crate) fn new(tree: &Tree, section: &SectionIndex) -> Self {
        let graph = Graph::new(tree, section);
        let count = graph.count;
        let (mut returns, mut ends, mut called) = (Vec::new(), Vec::new(), Vec::new());
        for at in 0..count {
            match graph.statement(at).map(command_of) {
                Some(Some(command::RETURN)) => returns.push(at),
                Some(Some(command::END)) => ends.push(at),
                _ => {}
            }
        }
        called.extend(graph.steps.iter().filter(|step| step.via == Via::Call).map(|step| step.to));
        called.sort_unstable();
        called.dedup();
        let forward = Adjacency::forward(&graph.steps, count);
        let back = Adjacency::back(&graph.steps, count);
        let comes_back = back.reach(returns.clone(), |_, _, via| via != Via::Call);
        Self {
            start: section.section.statements.start,
            count,
            is_complete: graph.is_complete,
            forward,
            back,
            returns,
            ends,
            called,
            comes_back,
            exits: OnceCell::new(),
            may_stop: OnceCell::new(),
            main: OnceCell::new(),
        }
    }

    /// Whether a subroutine that begins at statement `entry` can run off the end of the text: straight on, or by a
    /// jump when it has no other end.
    pub(crate) fn runs_off_the_end(&self, entry: u32) -> bool {
        let (at, exits) = (self.place(entry), self.exits());
        is(&exits.falls_off, at) || (is(&exits.reaches_end, at) && !is(&exits.reaches_stop, at))
    }

    /// Whether a subroutine that begins at statement `entry` goes round for ever: it reaches no RETURN, no END, no
    /// statement that may end the program, and not the end of the text.
    pub(crate) fn never_ends(&self, entry: u32) -> bool {
        let (at, exits) = (self.place(entry), self.exits());
        !is(&exits.reaches_end, at) && !is(&exits.reaches_stop, at) && !is(self.may_stop(), at)
    }

    /// The END of a subroutine that begins at statement `entry`, when it reaches neither a RETURN nor the end of the text and
    /// the main code does not come to them.
    pub(crate) fn only_ends(&self, entry: u32) -> Vec<u32> {
        let (at, exits) = (self.place(entry), self.exits());
        if is(&self.comes_back, at) || is(&exits.reaches_end, at) || is(self.may_stop(), at) {
            return Vec::new();
        }
        let reached = self.forward.reach(vec![at], |_, _, via| via != Via::Call);
        let ends = self.ends.iter().filter(|end| is(&reached, **end)).map(|end| self.start + end);
        ends.filter(|end| !self.main().reaches(*end)).collect()
    }

    /// Whether something stands behind the GOSUB at statement `call` that is reached only when the subroutine returns.
    pub(crate) fn is_lost_behind(&self, tree: &Tree, call: u32) -> bool {
        let passed =
            |statement: &Statement| matches!(statement.kind, StatementKind::Label(_) | StatementKind::Remark(_));
        let statement = |at: u32| tree.statements().get((self.start + at) as usize);
        let mut at = self.place(call);
        loop {
            if at + 1 >= self.count || self.back.at(at + 1).len() != 1 {
                return false;
            }
            at += 1;
            match statement(at) {
                Some(next) if passed(next) => {}
                next => return next.is_some_and(does_something),
            }
        }
    }

    /// What the program does outside of its subroutines.
    pub(crate) fn main(&self) -> &Main {
        self.main.get_or_init(|| Main::new(self))
    }

    /// By statement of the program: it can be reached from the start or from one of `entries`, a call of a subroutine
    /// being a way like others.
    pub(crate) fn reached(&self, entries: impl Iterator<Item = u32>) -> Vec<bool> {
        let entries = entries.map(|entry| self.place(entry)).chain([0]).collect();
        self.forward.reach(entries, |_, _, _| true)
    }

    /// Adds to `reached` what can be reached from statement `entry`.
    pub(crate) fn reach_also(&self, entry: u32, reached: &mut [bool]) {
        self.forward.spread(vec![self.place(entry)], reached, |_, _, _| true);
    }

    /// Straight ways from one subroutine into another that can return: the beginnings of both, sorted by the second. Only
    /// code that nothing but a GOSUB leads to belongs to a subroutine here.
    pub(crate) fn subroutines_run_into(&self) -> Vec<(u32, u32)> {
        let mut owner = vec![None; self.forward.len()];
        // A place that several subroutines reach belongs to the last one, so that none runs into its own beginning.
        for entry in self.called.iter().rev() {
            self.forward.claim(*entry, &mut owner, |_, _, via| via != Via::Call);
        }
        let main = self.main();
        let before = |to: &u32| {
            let steps = self.back.at(*to).iter();
            let straight = steps.filter(|(_, via)| matches!(via, Via::Straight | Via::Returned)).map(|(from, _)| *from);
            let from = straight.filter(|from| from < to && !main.reaches(self.start + from)).max()?;
            let own = owner.get(from as usize).copied().flatten().filter(|own| own != to)?;
            Some((self.start + own, self.start + to))
        };
        self.called.iter().filter(|to| is(&self.comes_back, **to)).filter_map(before).collect()
    }

    /// GOSUBs through which a subroutine calls itself, one for each group of subroutines that call each other: those
    /// that go back in the text, each with the place it goes to. Ways through a GOTO do not count.
    pub(crate) fn recursive_calls(&self) -> Vec<(u32, u32)> {
        let calls = (0..self.count).flat_map(|from| {
            let steps = self.forward.at(from).iter();
            steps.filter(|(_, via)| *via == Via::Call).map(move |(to, _)| (from, *to))
        });
        // A way that comes back without a GOTO goes back by a GOSUB, or stays inside of a loop.
        let backward: Vec<(u32, u32)> = calls.filter(|(from, to)| to <= from).collect();
        if backward.is_empty() {
            return backward;
        }
        let component = components::components(&self.forward, |from, _, via| match via {
            Via::Straight | Via::Call => true,
            Via::Returned => self.returns(from),
            Via::Jump | Via::Doubtful => false,
        });
        let of = |at: u32| component.get(at as usize).copied();
        let mut found: Vec<(Option<u32>, u32, u32)> = backward
            .into_iter()
            .filter(|(from, to)| of(*from) == of(*to))
            .map(|(from, to)| (of(from), from, to))
            .collect();
        found.sort_unstable();
        found.dedup_by_key(|(component, ..)| *component);
        found.sort_unstable_by_key(|(_, from, _)| *from);
        found.into_iter().map(|(_, from, to)| (self.start + from, self.start + to)).collect()
    }

    /// Those of `statements` that can be come to again without passing one of `barriers`, the first one of each loop. A
    /// subroutine that can reach a barrier is one, too.
    pub(crate) fn repeated(&self, statements: &[u32], barriers: &[u32]) -> Vec<u32> {
        let barriers: Vec<u32> = barriers.iter().map(|barrier| self.place(*barrier)).collect();
        let mut is_barrier = vec![false; self.forward.len()];
        for barrier in &barriers {
            if let Some(place) = is_barrier.get_mut(*barrier as usize) {
                *place = true;
            }
        }
        let to_barrier = self.back.reach(barriers, |_, _, _| true);
        let passes = |(to, via): &(u32, Via)| *via == Via::Call && is(&to_barrier, *to);
        let component = components::components(&self.forward, |from, to, via| {
            let goes_on = match via {
                Via::Straight | Via::Jump => true,
                Via::Returned => self.returns(from) && !self.forward.at(from).iter().any(passes),
                Via::Call | Via::Doubtful => false,
            };
            goes_on && !is(&is_barrier, from) && !is(&is_barrier, to)
        });
        let mut sizes = vec![0_u32; component.len()];
        for number in &component {
            if let Some(size) = sizes.get_mut(*number as usize) {
                *size += 1;
            }
        }
        let mut seen = vec![false; component.len()];
        let mut first = |statement: &u32| {
            let number = component.get(self.place(*statement) as usize).map_or(0, |number| *number as usize);
            // A statement alone does not lead to itself.
            sizes.get(number).is_some_and(|size| *size > 1)
                && seen.get_mut(number).is_some_and(|seen| !std::mem::replace(seen, true))
        };
        statements.iter().copied().filter(|statement| first(statement)).collect()
    }

    /// Whether the subroutine that the GOSUB at statement `call` calls can return.
    pub(crate) fn returns_from(&self, call: u32) -> bool {
        self.returns(self.place(call))
    }

    /// Whether the subroutine that the GOSUB at place `from` calls can return.
    fn returns(&self, from: u32) -> bool {
        self.forward.at(from).iter().any(|(to, via)| *via == Via::Call && is(&self.comes_back, *to))
    }

    fn exits(&self) -> &Exits {
        self.exits.get_or_init(|| {
            let within = |goals: Vec<u32>| self.back.reach(goals, |_, _, via| via != Via::Call);
            let stops = self.returns.iter().chain(&self.ends).copied().collect();
            Exits {
                falls_off: self.back.reach(vec![self.count], |_, from, via| match via {
                    Via::Straight => true,
                    Via::Returned => self.returns(from),
                    Via::Jump | Via::Call | Via::Doubtful => false,
                }),
                reaches_end: within(vec![self.count]),
                reaches_stop: within(stops),
            }
        })
    }

    fn may_stop(&self) -> &[bool] {
        self.may_stop.get_or_init(|| {
            let is_doubtful = |at: &u32| self.forward.at(*at).iter().any(|(_, via)| *via == Via::Doubtful);
            self.back.reach((0..self.count).filter(is_doubtful).collect(), |_, _, via| via != Via::Call)
        })
    }

    /// The place of a statement in the program.
    fn place(&self, statement: u32) -> u32 {
        statement.saturating_sub(self.start)
    }
}

/// Whether a statement is more than a mark, the end or a branch of a block, or a way on: something that is missed when
/// it is not carried out.
pub(crate) fn does_something(statement: &Statement) -> bool {
    const NOTHING: [CommandId; 10] = [
        command::END,
        command::RETURN,
        command::GOTO,
        command::NEXT,
        command::WEND,
        command::ENDIF,
        command::ELSE,
        command::ELSEIF,
        command::ELSE_IF,
        command::BREAK,
    ];
    match &statement.kind {
        StatementKind::Remark(_) | StatementKind::Label(_) | StatementKind::Define(_) | StatementKind::Error => false,
        StatementKind::Command(command) => !NOTHING.contains(&command.id),
        _ => true,
    }
}

/// The command that a statement is, if it has no node of its own.
fn command_of(statement: &Statement) -> Option<CommandId> {
    match &statement.kind {
        StatementKind::Command(command) => Some(command.id),
        _ => None,
    }
}

fn is(set: &[bool], at: u32) -> bool {
    set.get(at as usize).copied().unwrap_or(false)
}
