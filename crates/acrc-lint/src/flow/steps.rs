//! Steps between statements, sorted by where they begin and by where they lead.

/// A step from one statement to another, both counted from the start of the section.
#[derive(Clone, Copy)]
pub(super) struct Step {
    pub(super) from: u32,
    pub(super) to: u32,
    pub(super) via: Via,
}

/// How a step is taken.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Via {
    /// In the order of the text, or as its block says.
    Straight,
    /// Behind a `GOSUB`, once its subroutine has returned.
    Returned,
    /// By a `GOTO`.
    Jump,
    /// Into a subroutine.
    Call,
    /// Behind a statement that may end the program, or that could not be read.
    Doubtful,
}

/// The steps that begin, or end, at each statement.
pub(super) struct Adjacency {
    /// By statement: where its steps begin in `steps`; the next entry is where they end.
    first: Vec<u32>,
    /// The other ends.
    steps: Vec<(u32, Via)>,
}

impl Adjacency {
    /// The steps by where they begin.
    pub(super) fn forward(steps: &[Step], count: u32) -> Self {
        Self::new(steps.iter().map(|step| (step.from, step.to, step.via)), steps.len(), count)
    }

    /// The steps by where they lead.
    pub(super) fn back(steps: &[Step], count: u32) -> Self {
        Self::new(steps.iter().map(|step| (step.to, step.from, step.via)), steps.len(), count)
    }

    /// Sorts the steps between `count` statements, and the end behind them, by counting.
    fn new(steps: impl Iterator<Item = (u32, u32, Via)> + Clone, len: usize, count: u32) -> Self {
        let mut first = vec![0_u32; count as usize + 3];
        for (key, ..) in steps.clone() {
            if let Some(after) = first.get_mut(key as usize + 2) {
                *after += 1;
            }
        }
        let mut sum = 0;
        for place in &mut first {
            sum += *place;
            *place = sum;
        }
        let mut sorted = vec![(0, Via::Straight); len];
        for (key, other, via) in steps {
            if let Some(next) = first.get_mut(key as usize + 1) {
                if let Some(place) = sorted.get_mut(*next as usize) {
                    *place = (other, via);
                }
                *next += 1;
            }
        }
        Self { first, steps: sorted }
    }

    /// How many places there are: the statements and the end behind them.
    pub(super) fn len(&self) -> usize {
        self.first.len().saturating_sub(2)
    }

    /// The steps at a statement.
    pub(super) fn at(&self, statement: u32) -> &[(u32, Via)] {
        let bound = |at: usize| self.first.get(at).map_or(self.steps.len(), |place| *place as usize);
        self.steps.get(bound(statement as usize)..bound(statement as usize + 1)).unwrap_or_default()
    }

    /// Adds to `reached` what can be reached from `open` over the steps that `takes` allows, given their two ends.
    pub(super) fn spread(&self, mut open: Vec<u32>, reached: &mut [bool], takes: impl Fn(u32, u32, Via) -> bool) {
        while let Some(at) = open.pop() {
            match reached.get_mut(at as usize) {
                Some(seen) if !*seen => *seen = true,
                _ => continue,
            }
            open.extend(self.at(at).iter().filter(|(other, via)| takes(at, *other, *via)).map(|(other, _)| *other));
        }
    }

    /// Makes `owner` the owner of itself and of all that can be reached from it over the steps that `takes` allows, up to
    /// what has an owner.
    pub(super) fn claim(&self, owner: u32, owners: &mut [Option<u32>], takes: impl Fn(u32, u32, Via) -> bool) {
        let mut open = vec![owner];
        while let Some(at) = open.pop() {
            match owners.get_mut(at as usize) {
                Some(place) if place.is_none() => *place = Some(owner),
                _ => continue,
            }
            open.extend(self.at(at).iter().filter(|(other, via)| takes(at, *other, *via)).map(|(other, _)| *other));
        }
    }

    /// What can be reached from `open` over the steps that `takes` allows.
    pub(super) fn reach(&self, open: Vec<u32>, takes: impl Fn(u32, u32, Via) -> bool) -> Vec<bool> {
        let mut reached = vec![false; self.len()];
        self.spread(open, &mut reached, takes);
        reached
    }
}
