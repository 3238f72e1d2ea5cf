//! The controller as the VM sees it.

use acrc_vm::{Call, FaultKind, Host, Outcome, Value};

use crate::command::Context;
use crate::error::ControllerError;
use crate::flags::FIRST_WORD;
use crate::footprint::Places;
use crate::machine::Machine;

impl Host for Context<'_> {
    fn parameter(&mut self, number: i64) -> Result<Value, FaultKind> {
        if is_user(number) {
            self.footprint.reads |= Places::user(number);
        } else {
            self.catch_up();
            self.machine.note_read(number);
            // Flags have their words among the parameters.
            let word = number - i64::from(FIRST_WORD);
            self.footprint.reads |= Places::flag(word.wrapping_mul(i64::from(acrc_catalog::FLAGS_PER_WORD)));
            self.footprint.timed |= Machine::follows_time(number);
        }
        self.machine.read_parameter(number).map_err(FaultKind::from)
    }

    fn set_parameter(&mut self, number: i64, value: &Value) -> Result<(), FaultKind> {
        if is_user(number) {
            self.footprint.write(Places::user(number));
            return self.machine.write_parameter(number, value).map_err(FaultKind::from);
        }
        self.footprint.write(Places::ALL);
        self.catch_up();
        let written = self.machine.write_parameter(number, value).map_err(FaultKind::from);
        self.look(false);
        written
    }

    #[inline]
    fn user(&mut self, number: u16) -> Result<f64, FaultKind> {
        self.footprint.reads |= Places::user(i64::from(number));
        self.machine.memory.user(usize::from(number)).ok_or_else(|| self.no_user(number))
    }

    #[inline]
    fn set_user(&mut self, number: u16, value: f64) -> Result<(), FaultKind> {
        match self.machine.memory.user_mut(usize::from(number)) {
            Some(place) => {
                if place.to_bits() != value.to_bits() {
                    self.footprint.write(Places::user(i64::from(number)));
                }
                *place = value;
            }
            None => return Err(self.no_user(number)),
        }
        Ok(())
    }

    fn bit(&mut self, number: i64) -> Result<bool, FaultKind> {
        self.read_flag(number).map_err(FaultKind::from)
    }

    fn set_bit(&mut self, number: i64, state: bool) -> Result<(), FaultKind> {
        self.catch_up();
        let written = self.write_flag(number, state).map_err(FaultKind::from);
        self.look(false);
        written
    }

    fn command(&mut self, call: &Call) -> Result<Outcome, FaultKind> {
        self.catch_up();
        self.machine.streams.awaited = None;
        let outcome = self.execute(call).map_err(FaultKind::from);
        self.look(true);
        outcome
    }

    fn move_buffer(&mut self, moves: u32) {
        if self.moves != moves {
            self.moves = moves;
            // A move of the program may wait for room.
            self.footprint.write(Places::ALL);
        }
    }

    /// A generator of its own for each run, so that a run can be repeated: splitmix64.
    // Out of line, so that the loop that asks for a number stays small.
    #[inline(never)]
    fn random(&mut self, below: u32) -> u32 {
        // The next number is another one, but nobody waits for it.
        self.footprint.changed = true;
        self.machine.random = self.machine.random.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.machine.random;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^= mixed >> 31;
        (((mixed >> 32) * u64::from(below)) >> 32) as u32
    }

    fn take_character(&mut self, device: i32) -> Result<Option<u8>, FaultKind> {
        self.catch_up();
        let port = self.input_port(device)?;
        let character = self.machine.streams.take(port);
        self.machine.streams.awaited = character.is_none().then_some(port);
        self.footprint.reads |= Places::MACHINE;
        if character.is_some() {
            self.footprint.write(Places::ALL);
        }
        Ok(character)
    }

    fn character_waits(&mut self, device: i32) -> Result<bool, FaultKind> {
        self.catch_up();
        self.footprint.reads |= Places::MACHINE;
        let port = self.input_port(device)?;
        Ok(self.machine.streams.waits(port))
    }

    #[inline]
    fn reached(&mut self, used: u32) {
        self.pace.reach(used);
    }

    #[inline]
    fn interrupts(&self) -> bool {
        self.pace.is_over()
    }
}

/// Whether a parameter is a variable of the programs, which no time changes.
fn is_user(number: i64) -> bool {
    (0..i64::from(FIRST_WORD)).contains(&number)
}

impl Context<'_> {
    /// The fault of a user variable that has no memory.
    #[cold]
    fn no_user(&self, number: u16) -> FaultKind {
        self.machine.outside_user(i64::from(number)).into()
    }

    /// Moves time on to the slice of the present line.
    pub(crate) fn catch_up(&mut self) {
        self.machine.skip_to(self.pace.tick());
    }

    /// State of a flag that the program can reach.
    #[inline]
    pub(crate) fn read_flag(&mut self, number: i64) -> Result<bool, ControllerError> {
        self.reach(number)?;
        self.machine.note_read_bit(number);
        self.footprint.reads |= Places::flag(number);
        self.machine.read_bit(number)
    }

    /// Changes a flag that the program can reach.
    pub(crate) fn write_flag(&mut self, number: i64, state: bool) -> Result<(), ControllerError> {
        self.reach(number)?;
        let same = self.machine.read_bit(number)? == state;
        self.machine.write_bit(number, state)?;
        // A flag that gets the state it has is nothing new to anybody, unless that does something.
        let idle = same && self.machine.requests.is_empty() && Machine::is_idle_write(number, state);
        if idle {
            self.footprint.reads |= Places::flag(number);
        } else {
            let plain = Machine::is_plain_flag(number);
            self.footprint.write(if plain { Places::flag(number) } else { Places::ALL });
        }
        Ok(())
    }

    /// PLC programs of some models see the lower flags only (guide, "Alternate Mapping of Digital I/O").
    #[inline]
    fn reach(&self, number: i64) -> Result<(), ControllerError> {
        match self.machine.model.plc_last_flag {
            Some(last) if self.ladder.is_some() && number > i64::from(last) => {
                Err(ControllerError::PlcFlag { number, last })
            }
            _ => Ok(()),
        }
    }

    /// Decides whether somebody has to look at what the program has just done before its next line.
    fn look(&mut self, command: bool) {
        let ahead = self.pace.is_ahead();
        let changed = self.pace.is_awaited() || ahead && (command || self.machine.is_busy());
        if changed || !self.machine.requests.is_empty() {
            self.pace.leave();
        }
    }
}
