//! The controller: boots an image and runs its programs in virtual time.

mod ahead;
mod check;
mod edit;
mod observer;
mod queries;
mod reports;
mod requests;
mod run;
mod scan;
mod setup;
mod skip;
mod slice;
mod starts;
mod streams;
mod terminal;
mod view;

use std::sync::Arc;

use acrc_catalog::Model;
use acrc_image::{Image, UnitName};
use acrc_motion::axis::BacklashRule;
use acrc_vm::{AngleUnit, Code, Frame, LoadOptions, Locals};

pub(crate) use ahead::Pace;
pub use check::Unsupported;
pub(crate) use check::boots;
pub use observer::{Observer, Sent};
pub(crate) use requests::Refusal;
pub use run::Stopped;
pub use view::{Standing, View};

use crate::aliases::Aliases;
use crate::footprint::Changes;
use crate::host_interface::Alarms;
use crate::machine::Machine;
use crate::plc::Plc;
use crate::program::{Alarm, Program};
use crate::report::FaultReport;
use crate::scheduler::Scheduler;
use crate::time::SLICE_SECONDS;
use crate::world::World;

/// What a run is made with.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The scripted world.
    pub world: World,
    /// Seed of `RND`.
    pub seed: u64,
    /// What `SIN` and its like take, which no document says.
    pub angles: AngleUnit,
    /// PLC programs that are started beside those that begin with `PBOOT`.
    pub plcs: Vec<u8>,
    /// Seconds from one scan of the PLC programs to the next; `None` for a slice.
    pub plc_scan: Option<f64>,
    /// When backlash compensation is added.
    pub backlash: BacklashRule,
    /// The number of the flag Enable Rapid Move Modes of master 0, which no document gives; that of the next master is 32 further.
    /// `None` leaves rapid move modes disabled.
    pub rapid_move_modes: Option<u32>,
    /// The parameter whose changes are alarms of programs for clients on the network, which no document gives.
    pub user_alarm: Option<u32>,
}

/// A controller with an image.
#[derive(Debug)]
pub struct Controller {
    pub(crate) machine: Machine,
    pub(crate) programs: Vec<Program>,
    pub(crate) plcs: Vec<Plc>,
    pub(crate) scheduler: Scheduler,
    pub(crate) image: Arc<Image>,
    pub(crate) aliases: Aliases,
    /// How programs are made ready to run.
    pub(crate) load: LoadOptions,
    pub(crate) boot: Boot,
    /// Programs to be started when the setup code is done.
    to_start: Vec<u8>,
    /// The PLC programs that run from the beginning are started.
    plcs_started: bool,
    /// The tick at which power came on is over.
    powered: bool,
    /// Events of the world that the observer has been told of.
    reported_events: usize,
    /// Counts what could end a program's waiting.
    pub(crate) changes: Changes,
    pub(crate) faulted: bool,
    /// PLC programs that start when setup is over.
    first_plcs: Vec<u8>,
    /// Seconds from one scan of the PLC programs to the next.
    plc_scan: f64,
    /// The flag Enable Rapid Move Modes of master 0.
    pub(crate) rapid_move_modes: Option<u32>,
    pub(crate) alarms: Alarms,
}

/// Execution of the setup code.
#[derive(Debug)]
pub(crate) struct Boot {
    pub(crate) code: Code,
    frame: Frame,
    /// Place of the statement that is or was executed last.
    statement: u32,
    /// Variables of statements at the system prompt, which has none.
    locals: Locals,
    release: Option<u64>,
    alarm: Alarm,
    pub(crate) done: bool,
    waiting: bool,
    /// The count of changes when it last found that it must wait.
    waited_at: u64,
}

impl Controller {
    /// Powers a controller up with an image. Nothing is executed yet.
    pub fn new(image: Arc<Image>, options: Options) -> Result<Self, acrc_vm::LoadError> {
        let model = acrc_catalog::model(&image.model).unwrap_or_else(acrc_catalog::default_model);
        let load = LoadOptions { angle: options.angles };
        let code = Code::load_with(&image.boot, &image.aliases, load)?;
        let mut machine = Machine::new(model, options.world, options.seed);
        machine.backlash = options.backlash;
        machine.apply_events();
        Ok(Self {
            programs: (0..model.programs).map(|_| Program::new()).collect(),
            plcs: (0..model.plcs).map(Plc::new).collect(),
            scheduler: Scheduler::new(),
            aliases: Aliases::new(&image.aliases),
            load,
            to_start: Vec::new(),
            plcs_started: false,
            powered: false,
            boot: Boot {
                code,
                frame: Frame::new(),
                statement: 0,
                locals: Locals::new(0),
                release: None,
                alarm: Alarm::default(),
                done: false,
                waiting: false,
                waited_at: 0,
            },
            machine,
            image,
            changes: Changes::new(),
            faulted: false,
            first_plcs: options.plcs,
            plc_scan: options.plc_scan.unwrap_or(SLICE_SECONDS),
            reported_events: 0,
            rapid_move_modes: options.rapid_move_modes,
            alarms: Alarms::new(options.user_alarm),
        })
    }

    /// The model that is simulated.
    pub fn model(&self) -> &'static Model {
        self.machine.model
    }

    fn fault_report(&self, unit: UnitName, location: acrc_vm::Location, message: String) -> FaultReport {
        FaultReport {
            seconds: self.machine.clock.seconds(),
            unit,
            file: location.source.and_then(|source| self.image.files.get(source.file as usize).cloned()),
            line: Some(location.source_line()),
            statement: location.statement,
            message,
            heard: false,
        }
    }
}
