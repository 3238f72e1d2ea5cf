//! What a program does between its start and the first GOSUB, or after the subroutine has come back: its main code.

use super::{Flow, Via, is};

/// What can be reached from the start of a program outside of its subroutines.
pub(crate) struct Main {
    start: u32,
    /// By statement: it belongs to the main code.
    reached: Vec<bool>,
    /// By statement: a way on which the main code gets to it.
    ways: Vec<Way>,
    /// Straight ways from the main code into a subroutine that can return: the statement before the subroutine, and
    /// its first one. The main code is not followed there.
    pub(crate) fallen_into: Vec<(u32, u32)>,
    /// The RETURN that belong to the main code.
    pub(crate) returns: Vec<u32>,
}

/// How the main code gets to a statement.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Way {
    /// From the start of the program in the order of the text.
    Start,
    /// Last by this GOTO.
    Goto(u32),
}

impl Main {
    pub(super) fn new(flow: &Flow) -> Self {
        let places = flow.forward.len();
        let mut main = Self {
            start: flow.start,
            reached: vec![false; places],
            ways: vec![Way::Start; places],
            fallen_into: Vec::new(),
            returns: Vec::new(),
        };
        main.follow(flow);
        let returns = flow.returns.iter().filter(|at| is(&main.reached, **at));
        main.returns = returns.map(|at| flow.start + at).collect();
        main.fallen_into.sort_unstable_by_key(|(from, to)| (*to, std::cmp::Reverse(*from)));
        main.fallen_into.dedup_by_key(|(_, to)| *to);
        for (from, to) in &mut main.fallen_into {
            *from += flow.start;
            *to += flow.start;
        }
        main
    }

    fn follow(&mut self, flow: &Flow) {
        let mut open = vec![(0, Way::Start)];
        while let Some((at, way)) = open.pop() {
            match self.reached.get_mut(at as usize) {
                Some(seen) if !*seen => *seen = true,
                _ => continue,
            }
            if let Some(place) = self.ways.get_mut(at as usize) {
                *place = way;
            }
            for (to, via) in flow.forward.at(at).iter().copied() {
                match via {
                    Via::Call | Via::Doubtful => {}
                    Via::Returned if !flow.returns(at) => {}
                    Via::Straight | Via::Returned if is_subroutine(flow, to) => self.fallen_into.push((at, to)),
                    Via::Straight | Via::Returned => open.push((to, way)),
                    Via::Jump => open.push((to, Way::Goto(self.start + at))),
                }
            }
        }
    }

    /// Whether a statement belongs to the main code.
    pub(super) fn reaches(&self, statement: u32) -> bool {
        is(&self.reached, statement.saturating_sub(self.start))
    }

    /// How the main code gets to one of its statements.
    pub(crate) fn way_to(&self, statement: u32) -> Way {
        let place = statement.saturating_sub(self.start) as usize;
        self.ways.get(place).copied().unwrap_or(Way::Start)
    }
}

/// Whether a place is the beginning of a subroutine that can return.
fn is_subroutine(flow: &Flow, at: u32) -> bool {
    flow.called.binary_search(&at).is_ok() && is(&flow.comes_back, at)
}
