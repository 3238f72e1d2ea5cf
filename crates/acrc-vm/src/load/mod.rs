//! From the stored form to the register form.
//!
//! Everything that does not change is settled here, once: types, constants, addresses of jumps, the nesting of blocks,
//! aliases, the form of arguments. What is certain to fail only when it is reached (a string where a number belongs, a
//! jump to a line that is not there) becomes an instruction that raises the fault, because the controller finds such
//! errors at run time too.

mod arguments;
mod arithmetic;
mod blocks;
mod call;
mod compare;
mod error;
mod expression;
mod flow;
mod operand;
mod place;
mod statement;

use acrc_catalog::command;
use acrc_image::{Alias, Instruction, Node, Separator, Unit, UnitName};

use self::blocks::Role;
pub use self::error::{LoadError, LoadErrorKind};
use self::place::Scratch;
use crate::account::{Account, Begins, Route, accounts};
use crate::code::{Code, Doubt, Location, Real, StatementMark, Unconfirmed};
use crate::fault::FaultKind;
use crate::functions::AngleUnit;
use crate::op::Op;
use crate::plan::Plan;
use crate::value::Value;

/// Choices where the documents are silent.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LoadOptions {
    /// Unit of angles in functions.
    pub angle: AngleUnit,
}

/// Where a jump goes, before addresses are known. Numbers are places in the list of instructions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Jump {
    /// To a statement.
    To(usize),
    /// To where the statement before it ends up: for a branch of an `IF` that is the end of the `IF`.
    Entry(usize),
    /// To where this statement ends up.
    Behind(usize),
}

/// Addresses of a statement in the register form.
#[derive(Clone, Copy, Debug, Default)]
struct Addresses {
    entry: u32,
    start: u32,
}

/// An instruction and what begins with it.
#[derive(Clone, Copy, Debug)]
struct Step {
    op: Op,
    begins: Begins,
}

/// The state of a load.
struct Loader<'a> {
    aliases: &'a [Alias],
    instructions: &'a [Instruction],
    roles: Vec<Role>,
    /// Places of the label definitions, in order.
    labels: Vec<usize>,
    boot: bool,
    steps: Vec<Step>,
    /// What begins with the next instruction.
    begins: Begins,
    /// Jumps whose address is not known yet.
    jumps: Vec<(usize, Jump)>,
    addresses: Vec<Addresses>,
    scratch: Scratch,
    value_slots: usize,
    constants: Vec<Value>,
    reals: Vec<Real>,
    plans: Vec<Plan>,
    faults: Vec<FaultKind>,
    statements: Vec<StatementMark>,
    unconfirmed: Vec<Unconfirmed>,
    location: Location,
}

impl Code {
    /// Verifies and decodes a unit of an image.
    ///
    /// # Errors
    /// When the words are no program, when blocks do not match, or when a statement cannot be executed whatever
    /// happens.
    pub fn load(unit: &Unit, aliases: &[Alias]) -> Result<Self, LoadError> {
        Self::load_with(unit, aliases, LoadOptions::default())
    }

    /// As [`Code::load`], with choices.
    ///
    /// # Errors
    /// As [`Code::load`].
    pub fn load_with(unit: &Unit, aliases: &[Alias], options: LoadOptions) -> Result<Self, LoadError> {
        let refuse = |kind, location| LoadError { kind, unit: unit.name, location };
        let instructions = unit.decode().map_err(|error| refuse(error.into(), Location::default()))?;
        let locations = locations(unit, &instructions);
        let at = |place: usize| locations.get(place).copied().unwrap_or_default();
        let roles = blocks::roles(&instructions).map_err(|(kind, place)| refuse(kind, at(place)))?;
        let labels = (0..).zip(&instructions).filter(|(_, instruction)| instruction.command == command::LABEL);
        let mut loader = Loader {
            aliases,
            labels: labels.map(|(place, _)| place).collect(),
            instructions: &instructions,
            roles,
            boot: unit.name == UnitName::Boot,
            steps: Vec::new(),
            begins: Begins::Nothing,
            jumps: Vec::new(),
            addresses: Vec::with_capacity(instructions.len()),
            scratch: Scratch::default(),
            value_slots: 0,
            constants: Vec::new(),
            reals: Vec::new(),
            plans: Vec::new(),
            faults: Vec::new(),
            statements: Vec::with_capacity(instructions.len()),
            unconfirmed: Vec::new(),
            location: Location::default(),
        };
        for (place, instruction) in instructions.iter().enumerate() {
            loader.location = at(place);
            loader.begin();
            loader.statement(place, instruction).map_err(|kind| refuse(kind, at(place)))?;
        }
        Ok(loader.finish(unit.name, options.angle))
    }
}

/// Where each instruction stands.
fn locations(unit: &Unit, instructions: &[Instruction]) -> Vec<Location> {
    let mut line = Location::default();
    let mut all = Vec::with_capacity(instructions.len());
    for instruction in instructions {
        if instruction.separator == Separator::Line || line.line == 0 {
            line = Location { line: line.line + 1, ..Location::default() };
        }
        if instruction.command == command::LINE_NUMBER
            && let Some(Node::Long(number)) = instruction.items.first().map(|item| &item.node)
        {
            line.number = Some(*number);
        } else {
            line.statement += 1;
        }
        let source = unit.debug.as_ref().and_then(|map| map.locate(instruction.address));
        all.push(Location { address: instruction.address, source, ..line });
    }
    all
}

impl Loader<'_> {
    /// A new statement: nothing of the one before it is needed any more.
    fn begin(&mut self) {
        self.scratch = Scratch::default();
        let entry = self.steps.len() as u32;
        self.addresses.push(Addresses { entry, start: entry });
        self.statements.push(StatementMark { pc: entry, location: self.location, behind: entry });
    }

    /// The present statement starts here for those who jump to it.
    fn mark_start(&mut self, place: usize) {
        let start = self.steps.len() as u32;
        if let Some(addresses) = self.addresses.get_mut(place) {
            addresses.start = start;
        }
    }

    fn emit(&mut self, op: Op) {
        self.steps.push(Step { op, begins: std::mem::take(&mut self.begins) });
    }

    fn emit_jump(&mut self, op: Op, to: Jump) {
        self.jumps.push((self.steps.len(), to));
        self.emit(op);
    }

    /// A fault that is raised when the statement is reached.
    fn raise(&mut self, fault: FaultKind) {
        let index = self.faults.len() as u32;
        self.faults.push(fault);
        self.emit(Op::Raise { index });
    }

    /// Takes note of undocumented behaviour.
    fn doubt(&mut self, name: &'static str, doubt: Doubt) {
        if !self.unconfirmed.iter().any(|known| known.name == name && known.doubt == doubt) {
            self.unconfirmed.push(Unconfirmed { name, doubt, location: self.location });
        }
    }

    fn finish(mut self, name: UnitName, angle: AngleUnit) -> Code {
        let end = self.steps.len() as u32;
        self.emit(Op::End);
        let address = |place: usize| self.addresses.get(place).copied().unwrap_or(Addresses { entry: end, start: end });
        for (op, jump) in &self.jumps {
            let destination = match *jump {
                Jump::To(place) => address(place).start,
                Jump::Entry(place) => address(place).entry,
                Jump::Behind(place) => address(place + 1).entry,
            };
            if let Some(target) = self.steps.get_mut(*op).and_then(|step| step.op.target_mut()) {
                *target = destination;
            }
        }
        for (place, mark) in self.statements.iter_mut().enumerate() {
            mark.behind = address(blocks::last_dependent(&self.roles, place) + 1).entry;
        }
        let accounts = accounts(self.steps.iter().map(|step| (step.begins, step.op)));
        let routes = self.routes(&accounts);
        let loops = self.roles.iter().filter(|role| matches!(role, Role::For { .. })).count();
        Code {
            name,
            ops: self.steps.iter().map(|step| step.op).collect(),
            accounts,
            routes,
            constants: self.constants.into(),
            reals: self.reals.into(),
            plans: self.plans.into(),
            faults: self.faults.into(),
            value_slots: self.value_slots,
            loops,
            angle,
            statements: self.statements.into(),
            unconfirmed: self.unconfirmed.into(),
        }
    }

    /// What each jump does to the account.
    fn routes(&self, accounts: &[Account]) -> Box<[Route]> {
        let route = |(step, behind): (&Step, &Account)| {
            let at = step.op.target().and_then(|target| accounts.get(target as usize));
            at.map_or_else(Route::default, |at| Route::new(behind, at))
        };
        self.steps.iter().zip(accounts.iter().skip(1)).map(route).collect()
    }
}
