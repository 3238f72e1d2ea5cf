//! Power-up and restart, and the commands that need the programs (guide, "Resetting the Controller").
//!
//! At power-up memory is what the battery kept, else that of the factory; then comes the user image that is in use, then the saved
//! system parameters. The programs that begin with `PBOOT` are started last.

use std::collections::BTreeSet;
use std::sync::Arc;

use acrc_catalog::memory::SystemBlock;
use acrc_image::{Alias, Image, ImageError, Unit, UnitName};
use acrc_vm::{Code, LoadError};
use thiserror::Error;

use super::{Battery, FlashImage, Memory, Operation, Saved, TypedText};
use crate::controller::{Controller, Observer, Options, Refusal};
use crate::error::ControllerError;
use crate::memory::SystemMemory;
use crate::nonvolatile::parameters::retained_place;
use crate::program::Program;
use crate::report::FaultReport;
use crate::request::Request;
use crate::scheduler::Scheduler;
use crate::task::Task;
use crate::terminal::StoredText;

/// Why a controller cannot take what was saved.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum RestoreError {
    /// It comes from another model.
    #[error("it was saved by {saved}, and this controller is {model}")]
    Model {
        /// The model that saved it.
        saved: String,
        /// The model that is to take it.
        model: &'static str,
    },
    /// A text that is no program.
    #[error(transparent)]
    Image(#[from] ImageError),
    /// A program that cannot be executed.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// A value that the controller refuses.
    #[error(transparent)]
    Refused(#[from] ControllerError),
    /// More aliases than a table can have.
    #[error("there are more than {} aliases", u16::MAX)]
    Aliases,
}

impl From<Refusal> for RestoreError {
    fn from(refusal: Refusal) -> Self {
        match refusal {
            Refusal::Controller(error) => Self::Refused(error),
            Refusal::Code(_, error) => Self::Load(error),
        }
    }
}

impl Controller {
    /// Powers a controller up with what it has kept since its power went off, and then enters an image, which brings its setup code.
    /// Nothing is executed yet. Without a battery nothing is kept but what was saved by command.
    ///
    /// # Errors
    /// When the saved data is of another model or contradicts itself, or the image does not load.
    pub fn with_memory(
        image: Arc<Image>,
        options: Options,
        battery: bool,
        saved: Option<&Saved>,
    ) -> Result<Self, RestoreError> {
        let mut controller = Self::new(Arc::new(Image::empty(&image.model)), options)?;
        controller.machine.nonvolatile.battery = if battery { Battery::Connected } else { Battery::Absent };
        if let Some(saved) = saved {
            controller.restore(saved)?;
        }
        controller.download(image)?;
        Ok(controller)
    }

    /// What outlasts a reset, as if power went off now.
    pub fn saved(&mut self) -> Saved {
        self.compile_edited();
        let nonvolatile = &self.machine.nonvolatile;
        let strip = |mut memory: Memory| {
            // Places in source files mean nothing to a controller that has other files.
            memory.programs.iter_mut().for_each(|unit| unit.debug = None);
            memory
        };
        let image = nonvolatile.image.clone();
        Saved {
            model: self.machine.model.name.to_owned(),
            memory: self.kept_memory().map(strip),
            retained: self.kept_parameters(),
            parameters: nonvolatile.parameters.clone(),
            image: image.map(|image| FlashImage { memory: strip(image.memory), ..image }),
        }
    }

    /// Takes what another controller of the model has saved, as at power-up. What runs is stopped, and nothing is started.
    ///
    /// # Errors
    /// When the saved data is of another model or contradicts itself. The controller is not of use then.
    pub fn restore(&mut self, saved: &Saved) -> Result<(), RestoreError> {
        if saved.model != self.machine.model.name {
            return Err(RestoreError::Model { saved: saved.model.clone(), model: self.machine.model.name });
        }
        self.machine.restart();
        self.machine.nonvolatile.parameters.clone_from(&saved.parameters);
        self.machine.nonvolatile.image.clone_from(&saved.image);
        if let Some(image) = &saved.image {
            // An image that is not in use now may be tomorrow.
            self.load_image(image)?;
        }
        self.power_up(saved.memory.clone(), &saved.retained)
    }

    /// The stored programs, as an image without setup code.
    pub fn stored_programs(&self) -> Image {
        Image {
            aliases: self.aliases.entries().to_vec(),
            programs: self.texts().filter_map(|program| program.unit.clone()).collect(),
            ..Image::empty(self.machine.model.name)
        }
    }

    /// Programs that have text and begin with `PBOOT`.
    pub fn kept_boot_programs(&self) -> Vec<u8> {
        Self::boot_programs(&self.stored_programs())
    }

    /// Switches the power off and on again. The battery is connected afterwards.
    pub fn power_cycle(&mut self, observer: &mut dyn Observer) {
        self.compile_edited();
        let (memory, retained) = (self.kept_memory(), self.kept_parameters());
        if self.machine.nonvolatile.battery == Battery::Disconnected {
            self.machine.nonvolatile.battery = Battery::Connected;
        }
        self.restart(memory, &retained, observer);
    }

    /// Carries out a command on the memories.
    pub(crate) fn operate(&mut self, operation: Operation, observer: &mut dyn Observer) {
        self.compile_edited();
        let machine = &mut self.machine;
        match operation {
            Operation::SaveParameters => machine.nonvolatile.parameters = Some(machine.system_parameters()),
            Operation::EraseParameters => machine.nonvolatile.parameters = None,
            Operation::EraseFlash => machine.nonvolatile.image = None,
            Operation::DisconnectBattery => machine.nonvolatile.battery = Battery::Disconnected,
            Operation::RetireFlash => {
                if let Some(image) = &mut machine.nonvolatile.image {
                    image.in_use = false;
                }
            }
            Operation::LoadParameters => self.load_parameters(observer),
            Operation::FlashPrograms => self.save_image(false),
            Operation::FlashEverything => self.save_image(true),
            Operation::LoadFlash => {
                if let Some(image) = self.machine.nonvolatile.image.clone() {
                    let loaded = self.load_image(&image);
                    self.told(loaded, observer);
                }
            }
            Operation::Reboot => {
                let (memory, retained) = (self.kept_memory(), self.kept_parameters());
                self.restart(memory, &retained, observer);
            }
            Operation::DumpPrograms => self.dump_programs(observer),
        }
        if operation.saves() {
            observer.saved(&self.saved());
        }
    }

    fn load_parameters(&mut self, observer: &mut dyn Observer) {
        let Some(saved) = self.machine.nonvolatile.parameters.clone() else {
            self.machine.notes.insert("ELOAD found no saved system parameters: nothing was changed".to_owned());
            return;
        };
        let loaded = self.machine.load_system_parameters(&saved).map_err(RestoreError::from);
        self.told(loaded, observer);
    }

    fn save_image(&mut self, everything: bool) {
        let mut memory = self.memory(everything);
        if !everything {
            memory.user.clear();
            memory.blocks.retain(|(block, _)| of_programs(*block));
        }
        self.machine.nonvolatile.image = Some(FlashImage { in_use: true, everything, memory });
    }

    /// Makes the image in flash memory the working memory, or its part of it.
    fn load_image(&mut self, image: &FlashImage) -> Result<(), RestoreError> {
        let memory = self.with_image(self.memory(true), image);
        self.set_memory(&memory)
    }

    /// Working memory as it is now, with all names that mean something or those only that the texts need.
    fn memory(&self, names: bool) -> Memory {
        let memory = &self.machine.memory;
        let typed = self.typed_texts();
        // A text with mistakes may refer to any name.
        let Image { aliases, programs, .. } = self.stored_programs();
        let table = memory.size(SystemBlock::Aliases).is_some() || !programs.is_empty();
        let names = !typed.is_empty() || (names && table);
        let (aliases, programs) = self.without_forgotten(names, &programs).unwrap_or((aliases, programs));
        Memory {
            blocks: memory.blocks().collect(),
            aliases,
            programs,
            typed,
            user: memory.users().to_vec(),
            hardware: self.machine.config.clone(),
            password: self.machine.password.clone(),
        }
    }

    /// The aliases that texts refer to and those that `names` asks for, and the texts for this table: what a name meant before it was forgotten
    /// is no longer of use. `None` for a text that does not decode.
    fn without_forgotten(&self, names: bool, programs: &[Unit]) -> Option<(Vec<Alias>, Vec<Unit>)> {
        let mut kept: BTreeSet<u16> = self.aliases.known_places().filter(|_| names).collect();
        for unit in programs {
            kept.extend(unit.aliases().ok()?);
        }
        let entries = self.aliases.entries();
        let mut places = vec![0; entries.len()];
        for (place, old) in (0..).zip(&kept) {
            *places.get_mut(usize::from(*old))? = place;
        }
        let aliases = kept.iter().filter_map(|old| entries.get(usize::from(*old)).cloned()).collect();
        let programs = programs.iter().map(|unit| unit.renumber_aliases(&places)).collect::<Result<_, _>>().ok()?;
        Some((aliases, programs))
    }

    /// The texts that cannot be compiled.
    fn typed_texts(&self) -> Vec<TypedText> {
        let edited = self.tasks().filter_map(|task| {
            let lines = self.program(task).edited.as_ref()?.typed();
            Some(TypedText { name: task.unit(), lines })
        });
        edited.collect()
    }

    /// Texts are kept as they are stored, so one that was changed at a terminal is compiled first. One with mistakes is kept as it was typed;
    /// they show when it is started.
    fn compile_edited(&mut self) {
        let edited: Vec<Task> = self.tasks().filter(|task| self.program(*task).edited.is_some()).collect();
        for task in edited {
            let _ = self.compile(task);
        }
    }

    /// What the battery keeps of it.
    fn kept_memory(&self) -> Option<Memory> {
        (self.machine.nonvolatile.battery == Battery::Connected).then(|| self.memory(true))
    }

    fn kept_parameters(&self) -> Vec<(u32, acrc_vm::Value)> {
        match self.machine.nonvolatile.battery {
            Battery::Connected => self.machine.retained(true),
            Battery::Absent => self.machine.retained(false),
            Battery::Disconnected => Vec::new(),
        }
    }

    /// Starts all over with what was kept. Time, the world and the statistics of the run go on.
    fn restart(&mut self, memory: Option<Memory>, retained: &[(u32, acrc_vm::Value)], observer: &mut dyn Observer) {
        self.machine.restart();
        let restored = self.power_up(memory, retained);
        self.told(restored, observer);
        self.apply(Request::Boot, observer);
    }

    /// Fills a machine that has just got power.
    fn power_up(&mut self, memory: Option<Memory>, retained: &[(u32, acrc_vm::Value)]) -> Result<(), RestoreError> {
        self.scheduler = Scheduler::new();
        let mut memory = memory.unwrap_or_else(|| self.factory_memory());
        if let Some(image) = self.machine.nonvolatile.image.as_ref().filter(|image| image.in_use) {
            memory = self.with_image(memory, image);
        }
        self.set_memory(&memory)?;
        for (number, value) in retained {
            if retained_place(*number).is_none() {
                return Err(ControllerError::UnknownParameter(i64::from(*number)).into());
            }
            self.machine.write_parameter(i64::from(*number), value)?;
        }
        if let Some(parameters) = self.machine.nonvolatile.parameters.clone() {
            self.machine.load_system_parameters(&parameters)?;
        }
        self.update_program_flags();
        self.changes.everywhere();
        Ok(())
    }

    /// Memory with what an image has in its place. User parameters that find no room beside it are lost.
    fn with_image(&self, memory: Memory, image: &FlashImage) -> Memory {
        if image.everything {
            return image.memory.clone();
        }
        let room = u64::from(self.machine.model.system_memory());
        let mut with = Memory { user: memory.user, ..image.memory.clone() };
        with.blocks.extend(memory.blocks.into_iter().filter(|(block, _)| !of_programs(*block)));
        if with.blocks.iter().map(|(_, bytes)| u64::from(*bytes)).sum::<u64>() > room {
            with.blocks.retain(|(block, _)| *block != SystemBlock::Parameters);
            with.user.clear();
        }
        with
    }

    fn factory_memory(&self) -> Memory {
        Memory { blocks: SystemMemory::new(self.machine.model).blocks().collect(), ..Memory::default() }
    }

    /// Replaces working memory; every program stops.
    fn set_memory(&mut self, memory: &Memory) -> Result<(), RestoreError> {
        let model = self.machine.model;
        self.machine.memory = SystemMemory::restored(model, &memory.blocks, &memory.user)?;
        for task in self.tasks().collect::<Vec<_>>() {
            let program = self.program_mut(task);
            // Statistics of the run go on.
            *program = Program { statements: program.statements, ..Program::new() };
        }
        self.machine.config.clone_from(&memory.hardware);
        self.machine.password.clone_from(&memory.password);
        if self.boot.done {
            // Setup code does not execute its `#DEFINE`: its names hold as long as it runs.
            self.aliases.clear();
        }
        let places = self.merge_aliases(&memory.aliases)?;
        for unit in &memory.programs {
            let unit = unit.renumber_aliases(&places)?;
            self.store_text(unit)?;
        }
        for text in &memory.typed {
            if let Some(task) = self.task_of(text.name)? {
                self.replace_text(task, StoredText::of_lines(&text.lines));
            }
        }
        Ok(())
    }

    /// Enters an image: its aliases come behind those that are known, and its setup code is executed when time begins.
    fn download(&mut self, image: Arc<Image>) -> Result<(), RestoreError> {
        let places = self.merge_aliases(&image.aliases)?;
        let same = (0..).zip(&places).all(|(place, known)| place == *known);
        self.image = if same {
            image
        } else {
            let renumbered = |unit: &Unit| unit.renumber_aliases(&places);
            let programs = image.programs.iter().map(renumbered).collect::<Result<_, _>>()?;
            let aliases = self.aliases.entries().to_vec();
            Arc::new(Image { aliases, boot: renumbered(&image.boot)?, programs, ..Image::clone(&image) })
        };
        self.boot.code = Code::load_with(&self.image.boot, self.aliases.entries(), self.load)?;
        Ok(())
    }

    /// Adds aliases to the table, and says where each of them is in it.
    fn merge_aliases(&mut self, aliases: &[Alias]) -> Result<Vec<u16>, RestoreError> {
        aliases.iter().map(|alias| self.aliases.merge(alias).ok_or(RestoreError::Aliases)).collect()
    }

    /// Reports why something could not be restored.
    fn told(&mut self, result: Result<(), RestoreError>, observer: &mut dyn Observer) {
        if let Err(error) = result {
            self.faulted = true;
            let seconds = self.machine.clock.seconds();
            let message = error.to_string();
            observer.fault(&FaultReport {
                seconds,
                unit: UnitName::Boot,
                file: None,
                line: None,
                statement: 1,
                message,
                heard: false,
            });
        }
    }
}

/// Whether `FLASH SAVE` keeps a block.
fn of_programs(block: SystemBlock) -> bool {
    matches!(block, SystemBlock::Program(_) | SystemBlock::Plc(_) | SystemBlock::Aliases)
}
