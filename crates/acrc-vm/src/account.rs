//! What running costs: lines of a slice, statements, and where a run that is out of lines has to stop.
//!
//! Counting at each statement would take a third of the time of a loop. So the costs are added up once, at load: while
//! instructions follow each other, how much was used is a difference of two sums. Only a jump has to account for
//! anything, and to see whether the lines suffice for all that may follow before the next jump. If not, the statements
//! are counted one by one.

use crate::op::Op;

/// A line. Lines that are left stand in the upper half of a count, statements that were begun in the lower: one
/// addition counts both.
pub(crate) const LINE: i64 = 1 << 32;

/// Statements that count as one line: far more than a line holds, so that only a loop within one line meets it.
pub(crate) const STATEMENTS_PER_LINE: u32 = 256;

/// What begins with an instruction.
///
/// That a statement begins is a mark of its first instruction instead of an instruction of its own, because every
/// instruction costs a dispatch and most statements have only one or two.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Begins {
    /// Nothing: it continues a statement.
    #[default]
    Nothing,
    /// The first statement of a line.
    Line,
    /// Any other statement.
    Statement,
}

/// The account in front of an instruction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Account {
    /// What all instructions of the program in front of this one take from the count.
    before: i64,
    /// Lines that this instruction and those behind it begin, up to one behind which nothing follows.
    need: u32,
    /// Further statements that the line may begin, if it is executed from its start.
    pub(crate) left: u8,
    pub(crate) begins: Begins,
}

/// What a jump does to the account.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Route {
    /// What the instructions between the jump and its target take from the count: they were not executed, or will be
    /// executed again.
    pub(crate) distance: i64,
    /// The smallest balance with which everything up to the next jump may be executed without counting.
    pub(crate) least: i64,
}

/// Instructions with what begins with them, and one account more for the end.
pub(crate) fn accounts(steps: impl ExactSizeIterator<Item = (Begins, Op)>) -> Box<[Account]> {
    let mut accounts = Vec::with_capacity(steps.len() + 1);
    let mut leaves = Vec::with_capacity(steps.len());
    let mut account = Account { before: 0, need: 0, left: 0, begins: Begins::Nothing };
    for (begins, op) in steps {
        accounts.push(Account { begins, ..account });
        leaves.push(op.leaves());
        match begins {
            Begins::Nothing => {}
            Begins::Statement if account.left > 0 => {
                account.before -= 1;
                account.left -= 1;
            }
            Begins::Line | Begins::Statement => {
                account.before += LINE - 1;
                account.left = (STATEMENTS_PER_LINE - 1) as u8;
            }
        }
    }
    accounts.push(account);
    let mut need = 0;
    let mut behind = account.before;
    for (account, leaves) in accounts.iter_mut().zip(leaves).rev() {
        let begun = u32::from(behind > account.before);
        need = if leaves { begun } else { need + begun };
        account.need = need;
        behind = account.before;
    }
    accounts.into()
}

impl Account {
    /// The balance that a count amounts to here. While instructions follow each other the balance stays the same.
    #[inline]
    pub(crate) const fn balance(&self, count: u64) -> i64 {
        (count as i64).wrapping_add(self.before)
    }

    /// The count that a balance amounts to here.
    #[inline]
    pub(crate) const fn count(&self, balance: i64) -> u64 {
        balance.wrapping_sub(self.before) as u64
    }

    /// The smallest balance for everything that may follow up to the next jump. Only at the start of a line it is known
    /// how many statements of the line are still free.
    #[inline]
    pub(crate) fn least(&self) -> i64 {
        if self.begins == Begins::Line { self.before + i64::from(self.need) * LINE } else { i64::MAX }
    }
}

impl Route {
    /// From behind one instruction to another.
    #[inline]
    pub(crate) fn new(behind: &Account, at: &Account) -> Self {
        Self { distance: at.before - behind.before, least: at.least() }
    }
}
