//! The controller: boots an image and runs its programs in virtual time.

mod ahead;
mod check;
mod edit;
mod observer;
mod queries;
mod reports;
mod requests;
mod run;
mod setup;
mod streams;
mod terminal;
mod view;

use std::sync::Arc;

use acrc_catalog::Model;
use acrc_image::Image;
use acrc_vm::{AngleUnit, Code, Frame, LoadOptions, Locals};

pub(crate) use ahead::Pace;
pub use check::Unsupported;
pub use observer::{Observer, Sent};
pub(crate) use requests::Refusal;
pub use run::Stopped;
pub use view::View;

use crate::aliases::Aliases;
use crate::machine::Machine;
use crate::program::{Program, Watch};
use crate::report::FaultReport;
use crate::scheduler::Scheduler;
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
}

/// A controller with an image.
#[derive(Debug)]
pub struct Controller {
    pub(crate) machine: Machine,
    pub(crate) programs: Vec<Program>,
    pub(crate) scheduler: Scheduler,
    /// Stored texts of PLC programs.
    pub(crate) plcs: Vec<Program>,
    pub(crate) image: Arc<Image>,
    pub(crate) aliases: Aliases,
    /// How programs are made ready to run.
    pub(crate) load: LoadOptions,
    pub(crate) boot: Boot,
    /// Programs to be started when the setup code is done.
    to_start: Vec<u8>,
    /// The tick at which power came on is over.
    powered: bool,
    /// Events of the world that the observer has been told of.
    reported_events: usize,
    /// Counts what could end a program's waiting.
    changes: u64,
    pub(crate) faulted: bool,
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
    watch: Watch,
    done: bool,
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
        machine.apply_events();
        Ok(Self {
            programs: (0..model.programs).map(|_| Program::new()).collect(),
            plcs: (0..model.plcs).map(|_| Program::new()).collect(),
            scheduler: Scheduler::new(),
            aliases: Aliases::new(&image.aliases),
            load,
            to_start: Vec::new(),
            powered: false,
            boot: Boot {
                code,
                frame: Frame::new(),
                statement: 0,
                locals: Locals::new(0),
                release: None,
                watch: Watch::default(),
                done: false,
                waiting: false,
                waited_at: 0,
            },
            machine,
            image,
            changes: 1,
            faulted: false,
            reported_events: 0,
        })
    }

    /// The model that is simulated.
    pub fn model(&self) -> &'static Model {
        self.machine.model
    }

    fn fault_report(&self, program: Option<u8>, location: acrc_vm::Location, message: String) -> FaultReport {
        FaultReport {
            seconds: self.machine.clock.seconds(),
            program,
            file: location.source.and_then(|source| self.image.files.get(source.file as usize).cloned()),
            line: Some(location.source_line()),
            statement: location.statement,
            message,
        }
    }
}
