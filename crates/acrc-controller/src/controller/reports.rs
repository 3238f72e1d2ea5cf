//! What a controller tells about a run that is over.

use acrc_image::UnitName;

use super::{Controller, View};
use crate::error::ControllerError;
use crate::mechanics::Mechanism;
use crate::program::State;
use crate::report::{AxisReport, MasterReport, ProgramReport};

impl Controller {
    /// Virtual time in seconds.
    pub fn seconds(&self) -> f64 {
        self.machine.clock.seconds()
    }

    /// How often the controller has restarted (`REBOOT`, or power that went off and on).
    pub fn restarts(&self) -> u32 {
        self.machine.restarts
    }

    /// Whether any run-time error has happened.
    pub fn faulted(&self) -> bool {
        self.faulted
    }

    /// A look at the controller now.
    pub fn view(&self) -> View<'_> {
        View { machine: &self.machine, programs: &self.programs, plcs: &self.plcs }
    }

    /// What the run left out or relied on without proof.
    pub fn notes(&self) -> impl Iterator<Item = &str> {
        self.machine.notes.iter().map(String::as_str)
    }

    /// The programs and PLC programs that have text.
    pub fn programs(&self) -> Vec<ProgramReport> {
        let programs =
            self.programs.iter().enumerate().map(|(number, program)| (UnitName::Program(number as u8), program));
        let plcs = self.plcs.iter().map(|plc| (UnitName::Plc(plc.ladder.number()), &plc.program));
        let stored = programs.chain(plcs).filter_map(|(unit, program)| Some((unit, program, program.code.as_ref()?)));
        stored
            .map(|(unit, program, code)| ProgramReport {
                unit,
                state: program.state,
                awaits: program.awaits.filter(|_| program.state == State::Waiting),
                line: Some(code.location(program.frame.pc()).source_line()),
                statements: program.statements,
            })
            .collect()
    }

    /// The axes that some program has as slaves.
    pub fn axes(&self) -> Vec<AxisReport> {
        let view = self.view();
        let attached = view.axes();
        attached
            .into_iter()
            .map(|axis| {
                let state = &self.machine.axes[usize::from(axis)];
                // A motor without its drive stands, and shows that by its following error.
                let follows = self.machine.mechanics.of(axis).is_none_or(Mechanism::is_ideal);
                AxisReport {
                    axis,
                    name: view.axis_name(axis),
                    position: view.position(axis),
                    statistics: state.statistics,
                    moved_disabled: state.statistics.travel > 0.0 && follows && !state.was_enabled,
                }
            })
            .collect()
    }

    /// The masters that moved.
    pub fn masters(&self) -> Vec<MasterReport> {
        let moved = self.machine.masters.iter().enumerate().filter(|(_, master)| master.statistics.motion_ticks > 0);
        moved
            .map(|(number, master)| MasterReport {
                master: number as u8,
                statistics: master.statistics,
                motion_seconds: master.statistics.motion_ticks as f64 * self.machine.clock.period(),
            })
            .collect()
    }

    /// The value of a parameter, as a program would read it.
    pub fn parameter(&self, number: i64) -> Result<acrc_vm::Value, ControllerError> {
        self.machine.read_parameter(number)
    }

    /// The state of a flag, as a program would read it.
    pub fn bit(&self, number: i64) -> Result<bool, ControllerError> {
        self.machine.read_bit(number)
    }
}
