//! How deep the subroutines of a program call each other: 4 bytes a level while it runs (guide, "How Much Memory?").
//!
//! The longest way through the program, where a `GOSUB` is a step of one and everything else a step of nothing. A way that
//! comes back to a `GOSUB` through itself has no end: the subroutine calls itself.

use acrc_catalog::{command, memory};
use acrc_image::{Instruction, Mark, Node, Separator};
use acrc_syntax::Tree;
use acrc_syntax::ast::{Separator as TreeSeparator, StatementKind};
use acrc_syntax::units::SectionKind;

use crate::index::SectionIndex;

/// How deep the calls of a program go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Calls {
    /// At most so many levels.
    Depth(u32),
    /// A subroutine calls itself, directly or by others: as deep as the program runs.
    Recursive,
}

impl Default for Calls {
    fn default() -> Self {
        Self::Depth(0)
    }
}

impl Calls {
    /// Bytes of all levels; of one level where there is no end.
    pub fn bytes(self) -> u64 {
        match self {
            Self::Depth(levels) => memory::CALLS.bytes(levels.into(), 0),
            Self::Recursive => memory::CALLS.bytes(1, 0),
        }
    }
}

/// Where a statement leads.
#[derive(Clone, Copy, Debug, Default)]
struct Step {
    /// Execution can go on with the next statement.
    on: bool,
    /// It jumps to a statement.
    jump: Option<u32>,
    /// It calls a subroutine at a statement.
    call: Option<u32>,
}

/// What a statement does to the way through the program.
#[derive(Clone, Copy)]
enum Turn {
    None,
    Stop,
    Jump(Option<u32>),
    Call(Option<u32>),
}

impl Step {
    /// A turn that may not be taken can also be passed.
    fn new(turn: Turn, conditional: bool) -> Self {
        match turn {
            Turn::None => Self { on: true, ..Self::default() },
            Turn::Stop => Self { on: conditional, ..Self::default() },
            Turn::Jump(to) => Self { on: conditional, jump: to, call: None },
            Turn::Call(to) => Self { on: true, jump: None, call: to },
        }
    }
}

/// The calls of a stored section of a file.
pub(super) fn of_section(tree: &Tree, index: &SectionIndex) -> Calls {
    let range = index.section.statements.clone();
    if index.section.kind != SectionKind::Stored || !index.jumps.iter().any(|jump| jump.call) {
        return Calls::default();
    }
    let mut jumps = index.jumps.iter().peekable();
    let mut behind_then = false;
    let step = |at: u32| {
        let statement = tree.statements().get(at as usize)?;
        behind_then =
            statement.separator != TreeSeparator::Line && (behind_then || statement.separator == TreeSeparator::Then);
        let turn = match (&statement.kind, jumps.next_if(|jump| jump.statement == at)) {
            (_, Some(jump)) => {
                let to = jump.to.and_then(|to| to.checked_sub(range.start));
                if jump.call { Turn::Call(to) } else { Turn::Jump(to) }
            }
            (StatementKind::Command(command), None) if stops(command.id) => Turn::Stop,
            _ => Turn::None,
        };
        Some(Step::new(turn, behind_then || index.blocks.enclosing(at).is_some()))
    };
    deepest(&range.clone().map_while(step).collect::<Vec<_>>())
}

/// The calls of a decoded program.
pub(super) fn of_program(program: &[Instruction]) -> Calls {
    let labels: Vec<u32> = places(program, command::LABEL).map(|(at, _)| at).collect();
    let lines: Vec<(i32, u32)> = places(program, command::LINE_NUMBER)
        .filter_map(|(at, instruction)| match instruction.items.first().map(|item| &item.node) {
            Some(Node::Long(number)) => Some((*number, at)),
            _ => None,
        })
        .collect();
    let target = |instruction: &Instruction| match instruction.items.first().map(|item| &item.node)? {
        Node::LabelRef(ordinal) => labels.get(usize::from(*ordinal)).copied(),
        Node::Long(number) => lines.iter().find(|(line, _)| line == number).map(|(_, at)| *at),
        _ => None,
    };
    let (mut depth, mut behind_then) = (0_u32, false);
    let step = |instruction: &Instruction| {
        behind_then =
            instruction.separator != Separator::Line && (behind_then || instruction.separator == Separator::Then);
        let turn = match instruction.command {
            command::GOTO => Turn::Jump(target(instruction)),
            command::GOSUB => Turn::Call(target(instruction)),
            other if stops(other) => Turn::Stop,
            _ => Turn::None,
        };
        let step = Step::new(turn, behind_then || depth > 0);
        let one_line = instruction.items.first().is_some_and(|item| item.mark == Mark::Comma);
        match instruction.command {
            command::IF if !one_line => depth += 1,
            command::FOR | command::WHILE => depth += 1,
            command::ENDIF | command::NEXT | command::WEND => depth = depth.saturating_sub(1),
            _ => {}
        }
        step
    };
    deepest(&program.iter().map(step).collect::<Vec<_>>())
}

fn places(program: &[Instruction], command: acrc_catalog::CommandId) -> impl Iterator<Item = (u32, &Instruction)> {
    (0..).zip(program).filter(move |(_, instruction)| instruction.command == command)
}

fn stops(command: acrc_catalog::CommandId) -> bool {
    command == command::RETURN || command == command::END
}

/// The deepest calls on any way from the first statement (Tarjan's strongly connected components, without recursion).
fn deepest(steps: &[Step]) -> Calls {
    let mut search = Search {
        steps,
        found: vec![Found::default(); steps.len()],
        path: Vec::new(),
        open: Vec::new(),
        count: 0,
        recursive: false,
    };
    search.run();
    match search.found.first() {
        _ if search.recursive => Calls::Recursive,
        Some(first) => Calls::Depth(first.depth),
        None => Calls::default(),
    }
}

/// What is known of a statement.
#[derive(Clone, Copy, Debug, Default)]
struct Found {
    /// When it was met, from 1; 0 before.
    order: u32,
    /// The earliest statement of its component that can be reached.
    low: u32,
    /// Its component is not complete.
    open: bool,
    /// Its component: the order of the statement that it was entered by.
    component: u32,
    /// Calls on the deepest way from here.
    depth: u32,
    /// Which of its ways is looked at next.
    way: u8,
}

struct Search<'s> {
    steps: &'s [Step],
    found: Vec<Found>,
    /// Statements on the present way.
    path: Vec<u32>,
    /// Statements whose component is not complete.
    open: Vec<u32>,
    count: u32,
    recursive: bool,
}

impl Search<'_> {
    fn run(&mut self) {
        self.enter(0);
        while let Some(at) = self.path.last().copied() {
            let Some(found) = self.found.get_mut(at as usize) else { break };
            let way = found.way;
            found.way += 1;
            match way {
                0..=2 => {
                    if let Some((to, _)) = self.way(at, way) {
                        self.follow(at, to);
                    }
                }
                _ => self.leave(at),
            }
        }
    }

    /// One of the three ways from a statement, and how many levels deeper it leads.
    fn way(&self, at: u32, way: u8) -> Option<(u32, u32)> {
        let step = self.steps.get(at as usize)?;
        let (to, deeper) = match way {
            0 => (step.on.then_some(at + 1)?, 0),
            1 => (step.jump?, 0),
            _ => (step.call?, 1),
        };
        ((to as usize) < self.steps.len()).then_some((to, deeper))
    }

    fn enter(&mut self, at: u32) {
        self.count += 1;
        let order = self.count;
        if let Some(found) = self.found.get_mut(at as usize) {
            *found = Found { order, low: order, open: true, ..Found::default() };
            self.path.push(at);
            self.open.push(at);
        }
    }

    fn follow(&mut self, at: u32, to: u32) {
        let target = self.get(to);
        if target.order == 0 {
            self.enter(to);
        } else if target.open {
            self.lower(at, target.order);
        }
    }

    /// All ways from a statement are known.
    fn leave(&mut self, at: u32) {
        self.path.pop();
        let found = self.get(at);
        if let Some(before) = self.path.last().copied() {
            self.lower(before, found.low);
        }
        if found.low != found.order {
            return;
        }
        let first = self.open.iter().rposition(|open| *open == at).unwrap_or(0);
        let members = self.open.split_off(first);
        for member in &members {
            if let Some(found) = self.found.get_mut(*member as usize) {
                (found.open, found.component) = (false, at + 1);
            }
        }
        let depth = members.iter().map(|member| self.depth_from(*member, at + 1)).max().unwrap_or(0);
        for member in &members {
            if let Some(found) = self.found.get_mut(*member as usize) {
                found.depth = depth;
            }
        }
    }

    /// The deepest calls on the ways that leave the component of a statement.
    fn depth_from(&mut self, at: u32, component: u32) -> u32 {
        let mut deepest = 0;
        for (to, deeper) in (0..3).filter_map(|way| self.way(at, way)).collect::<Vec<_>>() {
            let target = self.get(to);
            if target.component == component {
                self.recursive |= deeper > 0;
            } else {
                deepest = deepest.max(target.depth + deeper);
            }
        }
        deepest
    }

    fn lower(&mut self, at: u32, order: u32) {
        if let Some(found) = self.found.get_mut(at as usize) {
            found.low = found.low.min(order);
        }
    }

    fn get(&self, at: u32) -> Found {
        self.found.get(at as usize).copied().unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::FileRole;

    fn calls(text: &str) -> Calls {
        let tree = acrc_syntax::parse(text);
        let (index, ..) = crate::index::build(text, &tree, FileRole::Program(0));
        of_section(&tree, &index.sections[0])
    }

    #[test]
    fn calls_in_a_row_are_one_level() {
        assert_eq!(calls("GOSUB A\nGOSUB A\nEND\n_A\nRETURN\n"), Calls::Depth(1));
        assert_eq!(calls("P0 = 1\n"), Calls::Depth(0));
    }

    #[test]
    fn calls_within_calls_add_up() {
        assert_eq!(
            calls("_Loop\nGOSUB A\nGOTO Loop\n_A\nGOSUB B\nRETURN\n_B\nGOSUB C\nRETURN\n_C\nRETURN\n"),
            Calls::Depth(3)
        );
    }

    #[test]
    fn what_is_never_called_costs_nothing() {
        assert_eq!(calls("GOSUB A\nEND\n_A\nRETURN\n_B\nGOSUB A\nRETURN\n"), Calls::Depth(1));
    }

    #[test]
    fn a_subroutine_that_calls_itself_has_no_end() {
        assert_eq!(calls("GOSUB A\nEND\n_A\nIF (BIT 1) THEN RETURN\nGOSUB A\nRETURN\n"), Calls::Recursive);
        assert_eq!(calls("GOSUB A\nEND\n_A\nGOSUB B\nRETURN\n_B\nGOSUB A\nRETURN\n"), Calls::Recursive);
    }

    #[test]
    fn a_return_in_a_block_may_be_passed() {
        assert_eq!(
            calls("GOSUB A\nEND\n_A\nIF (BIT 1)\nRETURN\nENDIF\nGOSUB B\nRETURN\n_B\nRETURN\n"),
            Calls::Depth(2)
        );
    }

    #[test]
    fn a_chain_of_a_hundred_thousand_calls_is_followed() {
        use std::fmt::Write as _;
        let mut text = String::from("1 GOSUB 10\n2 END\n");
        for line in 1..=100_000 {
            let _ = write!(text, "{line}0 GOSUB {}0\n{line}5 RETURN\n", line + 1);
        }
        assert_eq!(calls(&text), Calls::Depth(100_000));
    }
}
