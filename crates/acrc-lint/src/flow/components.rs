//! Statements that can reach each other: the strongly connected components of the steps, by Tarjan's algorithm.

use super::steps::{Adjacency, Via};

/// No number yet.
const NONE: u32 = u32::MAX;

/// By statement the number of its component, over the steps that `takes` allows. Linear in the steps.
pub(super) fn components(steps: &Adjacency, takes: impl Fn(u32, u32, Via) -> bool) -> Vec<u32> {
    let mut search = Search {
        steps,
        takes,
        order: vec![NONE; steps.len()],
        low: vec![NONE; steps.len()],
        component: vec![NONE; steps.len()],
        pending: Vec::new(),
        visited: 0,
        components: 0,
    };
    for root in 0..steps.len() as u32 {
        if get(&search.order, root) == NONE {
            search.from(root);
        }
    }
    search.component
}

struct Search<'s, T> {
    steps: &'s Adjacency,
    takes: T,
    /// By statement: when it was first seen.
    order: Vec<u32>,
    /// By statement: the earliest one that it is known to reach.
    low: Vec<u32>,
    component: Vec<u32>,
    /// Seen, and without a component.
    pending: Vec<u32>,
    visited: u32,
    components: u32,
}

impl<T: Fn(u32, u32, Via) -> bool> Search<'_, T> {
    /// Goes into everything that `root` reaches. Keeps its own stack: a program may be longer than a thread's is deep.
    fn from(&mut self, root: u32) {
        let mut path = vec![(root, 0_usize)];
        self.see(root);
        while let Some((at, next)) = path.pop() {
            let Some((to, via)) = self.steps.at(at).get(next).copied() else {
                self.leave(at);
                if let Some((before, _)) = path.last() {
                    self.lower(*before, get(&self.low, at));
                }
                continue;
            };
            path.push((at, next + 1));
            if !(self.takes)(at, to, via) {
                continue;
            }
            if get(&self.order, to) == NONE {
                self.see(to);
                path.push((to, 0));
            } else if get(&self.component, to) == NONE {
                self.lower(at, get(&self.order, to));
            }
        }
    }

    fn see(&mut self, at: u32) {
        set(&mut self.order, at, self.visited);
        set(&mut self.low, at, self.visited);
        self.visited += 1;
        self.pending.push(at);
    }

    fn lower(&mut self, at: u32, to: u32) {
        let low = get(&self.low, at).min(to);
        set(&mut self.low, at, low);
    }

    /// Closes the component of which `at` is the first statement that was seen.
    fn leave(&mut self, at: u32) {
        if get(&self.low, at) != get(&self.order, at) {
            return;
        }
        while let Some(member) = self.pending.pop() {
            set(&mut self.component, member, self.components);
            if member == at {
                break;
            }
        }
        self.components += 1;
    }
}

fn get(list: &[u32], at: u32) -> u32 {
    list.get(at as usize).copied().unwrap_or(NONE)
}

fn set(list: &mut [u32], at: u32, value: u32) {
    if let Some(place) = list.get_mut(at as usize) {
        *place = value;
    }
}
