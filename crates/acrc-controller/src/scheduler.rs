//! Which program gets the next slice (guide, "INH"; `docs/fidelity.md`, program scheduling).
//!
//! Programs 0 to 7 own a slice each, communication owns one more, and programs 8 to 15 share one that they get in turn. A program that does not
//! run takes no slice. A program of the shared slice that waits keeps the slice, so the others of its group wait with it.

/// Programs with a slice of their own.
pub(crate) const HIGH_PROGRAMS: usize = 8;
/// Programs that the largest controllers have.
pub(crate) const PROGRAMS: usize = 16;
/// Slot of the communication task.
const COMMUNICATION: usize = HIGH_PROGRAMS;
/// Slot that the low programs share.
const SHARED: usize = HIGH_PROGRAMS + 1;
/// Slots of the ring.
const SLOTS: usize = HIGH_PROGRAMS + 2;

/// The ring of slices.
#[derive(Clone, Debug)]
pub(crate) struct Scheduler {
    /// The slot that had the latest slice.
    slot: usize,
    /// The program that has the shared slice.
    low: usize,
}

impl Scheduler {
    /// Before the first slice, which goes to program 0 if it runs.
    pub(crate) fn new() -> Self {
        Self { slot: SLOTS - 1, low: HIGH_PROGRAMS }
    }

    /// Gives out the next slice. `running` says which programs run, by number. `None` is a slice for communication.
    pub(crate) fn next(&mut self, running: &[bool]) -> Option<usize> {
        loop {
            self.slot = (self.slot + 1) % SLOTS;
            match self.slot {
                COMMUNICATION => return None,
                SHARED => {
                    if let Some(program) = self.shared(running) {
                        return Some(program);
                    }
                }
                program if running.get(program) == Some(&true) => return Some(program),
                _ => {}
            }
        }
    }

    /// The running low program whose turn it is.
    fn shared(&mut self, running: &[bool]) -> Option<usize> {
        let count = running.len().checked_sub(HIGH_PROGRAMS).filter(|count| *count > 0)?;
        (0..count)
            .map(|step| HIGH_PROGRAMS + (self.low - HIGH_PROGRAMS + step) % count)
            .find(|program| running[*program])
            .inspect(|program| {
                self.low = *program;
            })
    }

    /// Passes the shared slice on after a low program has used it without waiting.
    pub(crate) fn pass_on(&mut self, program: usize, programs: usize) {
        if program >= HIGH_PROGRAMS {
            self.low = if program + 1 < programs { program + 1 } else { HIGH_PROGRAMS };
        }
    }

    /// Gives out `slices` slices at once, and says how many each program has got. Those that wait keep the shared slice, as
    /// they do when they are asked one by one.
    pub(crate) fn skip(&mut self, slices: u64, running: &[bool], waiting: &[bool]) -> Vec<u64> {
        let mut given = vec![0; running.len()];
        let low = running.iter().skip(HIGH_PROGRAMS).filter(|running| **running).count();
        let ring = running.iter().take(HIGH_PROGRAMS).filter(|running| **running).count() + 1 + low.min(1);
        // Slices after which everybody has had as many as in the rounds before. The first rounds may differ: they begin beside the ring where a
        // program has just ended, and the shared slice may only now come to a program that keeps it.
        let period = (ring * low.max(1)) as u64;
        if slices < 3 * period {
            self.give(slices, running, waiting, &mut given);
            return given;
        }
        self.give(period, running, waiting, &mut given);
        let mut each = vec![0; running.len()];
        self.give(period, running, waiting, &mut each);
        let periods = (slices - period) / period;
        for (given, each) in given.iter_mut().zip(each) {
            *given += each * periods;
        }
        self.give((slices - period) % period, running, waiting, &mut given);
        given
    }

    fn give(&mut self, slices: u64, running: &[bool], waiting: &[bool], given: &mut [u64]) {
        for _ in 0..slices {
            let Some(program) = self.next(running) else { continue };
            given[program] += 1;
            if !waiting[program] {
                self.pass_on(program, running.len());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn running(programs: &[usize]) -> [bool; 16] {
        std::array::from_fn(|program| programs.contains(&program))
    }

    fn slices(scheduler: &mut Scheduler, running: &[bool], count: usize) -> Vec<Option<usize>> {
        (0..count)
            .map(|_| {
                let program = scheduler.next(running);
                if let Some(program) = program {
                    scheduler.pass_on(program, running.len());
                }
                program
            })
            .collect()
    }

    #[test]
    fn high_programs_own_slices_and_low_ones_share() {
        let mut scheduler = Scheduler::new();
        let running = running(&[0, 3, 8, 12]);
        let expected =
            [Some(0), Some(3), None, Some(8), Some(0), Some(3), None, Some(12), Some(0), Some(3), None, Some(8)];
        assert_eq!(slices(&mut scheduler, &running, 12), expected);
    }

    #[test]
    fn a_waiting_low_program_keeps_the_shared_slice() {
        let mut scheduler = Scheduler::new();
        let running = running(&[8, 9]);
        assert_eq!(
            [scheduler.next(&running), scheduler.next(&running), scheduler.next(&running), scheduler.next(&running)],
            [None, Some(8), None, Some(8)]
        );
    }

    #[test]
    fn skipping_slices_equals_giving_them_out() {
        for (programs, waiting) in [
            (&[][..], &[][..]),
            (&[0], &[0]),
            (&[0, 1, 5], &[1]),
            (&[9], &[9]),
            (&[2, 8, 15], &[8, 15]),
            (&[2, 8, 9, 15], &[2]),
            (&[8, 9, 15], &[15]),
        ] {
            let (running, waiting) = (self::running(programs), self::running(waiting));
            for count in 0..80 {
                let mut stepped = Scheduler::new();
                let mut skipped = Scheduler::new();
                let mut given = vec![0; 16];
                stepped.give(count, &running, &waiting, &mut given);
                assert_eq!(skipped.skip(count, &running, &waiting), given, "{programs:?} {count}");
                assert_eq!((stepped.slot, stepped.low), (skipped.slot, skipped.low), "{programs:?} {count}");
            }
        }
    }
}
