//! Inverse kinematics (guide, "Inverse Kinematics"): the targets of moves go through a program.
//!
//! A move gives each axis of the master a position in Cartesian space, which its input parameter shows. The program of
//! `INVK PROG` runs once, from its beginning to its end, in slices of its own; what it leaves in the output parameters
//! are the targets of the axes, to which they move in a straight line.

use acrc_catalog::{command, law};
use acrc_motion::{Move, Target};
use acrc_vm::{Arg, Call, Outcome};

use super::arguments::scalar;
use super::{Action, Context, Entry};
use crate::error::ControllerError;
use crate::machine::Machine;
use crate::master::SLOTS;
use crate::request::Request;
use crate::task::Task;

pub(super) const COMMANDS: &[Entry] = &[
    (command::INVK, Action::Run(report)),
    (command::INVK_PROG, Action::Run(program)),
    (command::INVK_ON, Action::Run(on)),
    (command::INVK_OFF, Action::Run(off)),
];

/// The inverse kinematics of a master.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Kinematics {
    on: bool,
    /// The program with the equations.
    program: Option<u8>,
    /// The program computes the targets of a move.
    computes: bool,
    /// It stopped with a run-time error.
    failed: bool,
    /// Where the last move ends in Cartesian space, u.
    point: [f64; SLOTS],
}

impl Kinematics {
    /// Whether the targets of moves go through a program.
    pub(crate) fn is_on(&self) -> bool {
        self.on
    }

    /// Drops the move whose targets are computed.
    pub(crate) fn forget(&mut self) {
        self.computes = false;
    }
}

fn report(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let master = context.master(call)?;
    let Kinematics { on, program, .. } = context.machine.masters[master].kinematics;
    if let Some(program) = program {
        context.report_text(&format!("INVK PROG{program}"));
    }
    context.report_text(if on { "INVK ON" } else { "INVK OFF" });
    Ok(Outcome::Done)
}

/// `INVK PROG7`
fn program(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    let master = context.master(call)?;
    let number = scalar(call)?.ok_or(ControllerError::Expected { command, expected: "the number of a program" })?;
    let number = Machine::object("PROG", number as i64, context.machine.model.programs)?;
    context.machine.masters[master].kinematics.program = Some(number);
    Ok(Outcome::Done)
}

fn on(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let master = context.master(call)?;
    let kinematics = &mut context.machine.masters[master].kinematics;
    if kinematics.program.is_none() {
        let problem = "INVK PROG comes first: it says which program has the equations".to_owned();
        return Err(ControllerError::BadValue { command: call.command.info().name, problem });
    }
    kinematics.on = true;
    Ok(Outcome::Done)
}

fn off(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let master = context.master(call)?;
    context.machine.masters[master].kinematics.on = false;
    Ok(Outcome::Done)
}

impl Context<'_> {
    /// Refuses a move that inverse kinematics, where it is on, cannot transform.
    pub(super) fn transformable(&self, call: &Call, master: usize) -> Result<(), ControllerError> {
        let state = &self.machine.masters[master];
        let straight = matches!(call.command, command::AXIS_MOVE | command::MOV)
            && call.arguments.iter().all(|part| !matches!(part, Arg::Interpolation(kind) if *kind != command::MOV))
            && state.ahead.curve.is_none()
            && state.ahead.arc.is_none();
        if !state.kinematics.on || straight {
            return Ok(());
        }
        let problem = "INVK is on, which transforms the targets of straight moves only".to_owned();
        Err(ControllerError::BadValue { command: call.command.info().name, problem })
    }

    /// Lets the program of `INVK PROG` find the targets of a move. False while it has not ended.
    pub(super) fn transform(&mut self, call: &Call, master: usize, next: &mut Move) -> Result<bool, ControllerError> {
        let Kinematics { on: true, program: Some(program), computes, failed, .. } =
            self.machine.masters[master].kinematics
        else {
            return Ok(true);
        };
        let wrong = |what: &str| {
            let problem = format!("PROG{program} of INVK {what}");
            Err(ControllerError::BadValue { command: call.command.info().name, problem })
        };
        if call.first || !computes {
            if self.program == Some(program) {
                return wrong("cannot move axes while it transforms their targets");
            }
            if !self.machine.memory.is_stored(Task::Program(program).space()) {
                return wrong("has no program");
            }
            self.machine.begin_transformation(master, next);
            self.machine.requests.push(Request::Run(Task::Program(program)));
            return Ok(false);
        }
        if self.machine.flags.get(law::PROGRAM_RUNNING.at(u32::from(program))) {
            return Ok(false);
        }
        self.machine.masters[master].kinematics.computes = false;
        if failed {
            return wrong("has stopped with a run-time error");
        }
        self.machine.end_transformation(master, next);
        Ok(true)
    }
}

impl Machine {
    /// Shows the Cartesian target of a move to the program with the equations.
    fn begin_transformation(&mut self, master: usize, next: &Move) {
        let mut inputs = Vec::with_capacity(SLOTS);
        let state = &mut self.masters[master];
        let kinematics = &mut state.kinematics;
        (kinematics.computes, kinematics.failed) = (true, false);
        for (slot, axis) in state.slots.iter().enumerate() {
            let place = &mut kinematics.point[slot];
            match next.targets[slot] {
                Some(Target::Absolute(position)) => *place = position,
                Some(Target::Relative(distance)) => *place += distance,
                Some(Target::Sine(_)) | None => {}
            }
            inputs.extend(axis.map(|axis| (u32::from(axis), *place)));
        }
        for (axis, position) in inputs {
            self.script_parameter(law::INVK_INPUT.at(axis), position);
            // An axis without an equation goes where the move says.
            self.script_parameter(law::INVK_OUTPUT.at(axis), position);
        }
    }

    /// Takes the targets of all axes from where the program has left them.
    fn end_transformation(&self, master: usize, next: &mut Move) {
        for (slot, axis) in self.masters[master].attached() {
            let position = self.registers.number(law::INVK_OUTPUT.at(u32::from(axis)));
            next.targets[slot] = Some(Target::Absolute(position));
        }
    }

    /// A program has stopped with a run-time error: no targets come of it.
    pub(crate) fn fail_transformations(&mut self, task: Task) {
        for master in &mut self.masters {
            if let Some(program) = master.kinematics.program
                && task == Task::Program(program)
            {
                master.kinematics.failed = true;
            }
        }
    }
}
