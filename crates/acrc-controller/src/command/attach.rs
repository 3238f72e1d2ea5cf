//! Attachments: axis to hardware, program to master, axis to slave slot (guide, "Attachments").

use acrc_catalog::{ObjectKind, command};
use acrc_image::AxisName;
use acrc_vm::{Arg, Call, Outcome, Value};

use super::reports::hardware_word;
use super::{Action, Context, Entry};
use crate::axis::SlaveSlot;
use crate::error::ControllerError;
use crate::machine::{Attachment, Machine};
use crate::master::SLOTS;

pub(super) const COMMANDS: &[Entry] = &[
    (command::ATTACH_AXIS, Action::Run(attach_axis)),
    (command::ATTACH_MASTER, Action::Run(attach_master)),
    (command::ATTACH_SLAVE, Action::Run(attach_slave)),
    (command::DETACH, Action::Run(detach)),
    (command::DETACH_ALL, Action::Run(detach_all)),
];

/// The inputs and outputs that the guide lists for `ATTACH AXIS`: `ENC0` to `ENC7`, `DAC0` to `DAC7` and so on, as many as an axis each needs.
const LISTED: u8 = 8;
/// Encoders beyond one an axis: the guide's axis with two feedbacks has `ENC9` on a controller of eight axes.
const SPARE_ENCODERS: u8 = 2;

/// Encoder and output matter to a motor that the world describes; all of them must exist, and `ATTACH` reports what was said.
fn attach_axis(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let index = object(call, 0, ObjectKind::Axis)?;
    let axis = context.axis(index)?;
    for argument in call.arguments.iter().skip(1) {
        if let Arg::Object { kind, index: Some(index), .. } = argument {
            let spare = if *kind == ObjectKind::Encoder { SPARE_ENCODERS } else { 0 };
            Machine::object(kind.name(), i64::from(*index), context.machine.model.axes.max(LISTED) + spare)?;
        }
    }
    let signals: Vec<String> = call.arguments.iter().skip(1).filter_map(hardware_word).collect();
    context.machine.axes[usize::from(axis)].signals = Some(signals.join(" "));
    context.machine.motion.touch();
    Ok(Outcome::Done)
}

fn attach_master(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let program = context.program(call)?;
    let index = object(call, 0, ObjectKind::Master)?;
    let master = Machine::object("MASTER", index, context.machine.model.masters)?;
    context.machine.attach_master(program, master)?;
    Ok(Outcome::Done)
}

fn attach_slave(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let program = context.program(call)?;
    let master = context.machine.master_of(program)?;
    let slot =
        Machine::object("SLAVE", object(call, 0, ObjectKind::Slave)?, context.machine.model.slaves.min(SLOTS as u8))?;
    let axis = context.axis(object(call, 1, ObjectKind::Axis)?)?;
    context.machine.attach_slave(program, SlaveSlot { master, slot }, axis, slave_name(call)?)?;
    Ok(Outcome::Done)
}

impl Machine {
    /// Gives a program its master. Both must exist.
    pub(crate) fn attach_master(&mut self, program: u8, master: u8) -> Result<(), ControllerError> {
        let attached = |what: String, owner: String| ControllerError::AlreadyAttached { what, owner };
        match self.masters[usize::from(master)].program {
            Some(owner) if owner != program => {
                return Err(attached(format!("MASTER{master}"), format!("program {owner}")));
            }
            _ => {}
        }
        let attachment = &mut self.attachments[usize::from(program)];
        match attachment.master {
            Some(other) if other != master => {
                return Err(attached(format!("program {program}"), format!("MASTER{other}")));
            }
            _ => attachment.master = Some(master),
        }
        self.masters[usize::from(master)].program = Some(program);
        Ok(())
    }

    /// Puts an axis into a slot of the master of a program. All of them must exist.
    pub(crate) fn attach_slave(
        &mut self,
        program: u8,
        place: SlaveSlot,
        axis: u8,
        name: AxisName,
    ) -> Result<(), ControllerError> {
        let attached = |what: String, owner: String| ControllerError::AlreadyAttached { what, owner };
        let (master, slot) = (usize::from(place.master), usize::from(place.slot));
        if let Some(owner) = self.axes[usize::from(axis)].slave {
            let owner = format!("SLAVE{} of MASTER{}", owner.slot, owner.master);
            return Err(attached(format!("AXIS{axis}"), owner));
        }
        if let Some(other) = self.masters[master].slots[slot] {
            return Err(attached(format!("SLAVE{slot}"), format!("AXIS{other}")));
        }
        if self.attachments[usize::from(program)].names.contains(&Some(name)) {
            return Err(attached(format!("the name {name}"), "another axis of this program".to_owned()));
        }
        let position = self.position(axis);
        let profiler = &mut self.masters[master].profiler;
        profiler.set_position(slot, position).map_err(|_| ControllerError::InMotion)?;
        self.masters[master].renew_slot(slot).map_err(|error| ControllerError::Move(error.to_string()))?;
        self.masters[master].slots[slot] = Some(axis);
        self.axes[usize::from(axis)].slave = Some(place);
        self.attachments[usize::from(program)].names[slot] = Some(name);
        Ok(())
    }

    /// Frees every master and axis.
    pub(crate) fn detach_all(&mut self) -> Result<(), ControllerError> {
        (0..self.model.programs).try_for_each(|program| detach_program(self, program))
    }
}

/// The name of `ATTACH SLAVE`, by the rules of the guide: one to four letters, not `P`, not `F`. A word of the language would never be read as
/// the axis.
fn slave_name(call: &Call) -> Result<AxisName, ControllerError> {
    let command = call.command.info().name;
    let Some(Arg::Value(Value::Text(text), _)) = call.arguments.get(2) else {
        return Err(ControllerError::Expected { command, expected: "a name in quotes behind the axis" });
    };
    let text = text.to_string();
    let refused =
        |why: &str| ControllerError::BadValue { command, problem: format!("`{text}` is no axis name: {why}") };
    if ["P", "F"].iter().any(|reserved| text.eq_ignore_ascii_case(reserved)) {
        return Err(refused("P and F are reserved"));
    }
    if acrc_catalog::word(&text).is_some_and(|word| word.names_something()) {
        return Err(refused("it is a word of the language"));
    }
    text.parse::<AxisName>().map_err(|_| refused("it takes one to four letters"))
}

/// `DETACH` frees the master and slaves of the program, or one of them.
fn detach(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let program = context.program(call)?;
    match call.arguments {
        [] => detach_program(context.machine, program),
        [Arg::Object { kind: ObjectKind::Master, index: Some(master), .. }] => {
            match context.machine.attachments[usize::from(program)].master {
                Some(own) if u16::from(own) == *master => detach_program(context.machine, program),
                _ => Err(ControllerError::NotAttached { program, master: *master }),
            }
        }
        [Arg::Object { kind: ObjectKind::Slave, index: Some(slot), .. }] => {
            let master = context.machine.master_of(program)?;
            let slot = Machine::object("SLAVE", i64::from(*slot), SLOTS as u8)?;
            detach_slot(context.machine, master, slot)
        }
        [Arg::Object { kind: ObjectKind::Axis, index: Some(axis), .. }] => {
            let axis = context.axis(i64::from(*axis))?;
            match context.machine.axes[usize::from(axis)].slave {
                Some(slave) => detach_slot(context.machine, slave.master, slave.slot),
                None => Ok(()),
            }
        }
        _ => Err(ControllerError::Expected { command: "DETACH", expected: "MASTERn, SLAVEn, AXISn, ALL or nothing" }),
    }?;
    Ok(Outcome::Done)
}

fn detach_all(context: &mut Context, _: &Call) -> Result<Outcome, ControllerError> {
    context.machine.detach_all()?;
    Ok(Outcome::Done)
}

fn detach_program(machine: &mut Machine, program: u8) -> Result<(), ControllerError> {
    let Some(master) = machine.attachments[usize::from(program)].master else { return Ok(()) };
    for slot in 0..SLOTS as u8 {
        detach_slot(machine, master, slot)?;
    }
    machine.masters[usize::from(master)].program = None;
    machine.leave_groups(1 << master);
    machine.attachments[usize::from(program)] = Attachment::default();
    Ok(())
}

fn detach_slot(machine: &mut Machine, master: u8, slot: u8) -> Result<(), ControllerError> {
    let Some(axis) = machine.masters[usize::from(master)].slots[usize::from(slot)] else { return Ok(()) };
    if machine.axis_in_motion(axis) {
        return Err(ControllerError::InMotion);
    }
    machine.axes[usize::from(axis)].rest_position = machine.position(axis);
    machine.axes[usize::from(axis)].slave = None;
    let owner = machine.masters[usize::from(master)].program;
    machine.masters[usize::from(master)].slots[usize::from(slot)] = None;
    if let Some(program) = owner {
        machine.attachments[usize::from(program)].names[usize::from(slot)] = None;
    }
    Ok(())
}

fn object(call: &Call, place: usize, expected: ObjectKind) -> Result<i64, ControllerError> {
    match call.arguments.get(place) {
        Some(Arg::Object { kind, index: Some(index), .. }) if *kind == expected => Ok(i64::from(*index)),
        _ => Err(ControllerError::Expected { command: call.command.info().name, expected: expected.name() }),
    }
}
