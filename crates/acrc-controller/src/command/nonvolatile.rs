//! Commands on the memories that outlast a reset ([`crate::nonvolatile::RULES`]).

use acrc_catalog::command;
use acrc_vm::{Call, Outcome};

use super::{Action, Context, Entry};
use crate::error::ControllerError;
use crate::nonvolatile::{Battery, Operation, RULES, Rule};
use crate::request::Request;

pub(super) const COMMANDS: &[Entry] = &[
    (command::ESAVE, Action::Run(operate)),
    (command::ELOAD, Action::Run(operate)),
    (command::ERASE, Action::Run(operate)),
    (command::FLASH_SAVE, Action::Run(operate)),
    (command::FLASH_IMAGE, Action::Run(operate)),
    (command::FLASH_LOAD, Action::Run(operate)),
    (command::FLASH_RES, Action::Run(operate)),
    (command::FLASH_ERASE, Action::Run(operate)),
    (command::BRESET, Action::Run(operate)),
    (command::REBOOT, Action::Run(operate)),
    (command::PROM, Action::Run(operate)),
];

/// Asks for what the command does, unless the controller refuses it.
fn operate(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let Some(rule) = RULES.iter().find(|rule| rule.command == call.command) else {
        return Err(ControllerError::NotSimulated(call.command));
    };
    context.admit(rule)?;
    context.machine.requests.push(Request::Memories(rule.operation));
    // Programs do not outlive these two.
    let ends = matches!(rule.operation, Operation::Reboot | Operation::LoadFlash) && !context.immediate;
    Ok(if ends { Outcome::End } else { Outcome::Done })
}

impl Context<'_> {
    fn admit(&self, rule: &Rule) -> Result<(), ControllerError> {
        let machine = &self.machine;
        let refuse = |problem: String| Err(ControllerError::BadValue { command: rule.command.info().name, problem });
        if (rule.missing)(machine.model.name) {
            return refuse(format!("{} does not have it", machine.model.name));
        }
        if rule.operation == Operation::DisconnectBattery && machine.nonvolatile.battery == Battery::Absent {
            return refuse("this controller has no battery".to_owned());
        }
        if rule.at_rest && machine.in_motion() {
            return Err(ControllerError::InMotion);
        }
        if rule.needs_image && !machine.has_image() {
            return refuse("there is no image in flash memory".to_owned());
        }
        Ok(())
    }
}
