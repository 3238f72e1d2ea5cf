//! What a download will do: a project and what the controller has, to steps in their order.
//!
//! Two ways lead to the same result. A project that shares out the system memory (`CLEAR`, `DIM PROG0(...)`) is sent as a whole:
//! every program goes first, since `CLEAR` is refused while one is stored and `DIM` while its block has memory. What the project
//! does not say itself (`NEW ALL`, `CLEAR`, `DETACH ALL`) is put before it. Where the controller has the memory of the project
//! already, and for a project that only brings programs, the programs that are the same stay. Those that are not are erased
//! before anything else is sent, so that at no time an old program stands beside new settings or names.

use std::collections::BTreeSet;

use acrc_catalog::memory::SystemBlock;
use acrc_catalog::{Model, law};
use acrc_image::UnitName;
use acrc_syntax::units::Level;

use super::demand::{Demand, kept};
use super::immediate::{Special, Traits};
use super::listing::Names;
use super::objection::{Objection, objections};
use super::script::{Kind, Place, Script, ScriptLine, level_of};
use super::state::{Fate, State};
use super::survey::{Survey, switch};

/// A note on a project that has settings only.
pub const NOTHING_STORED: &str = "nothing is stored: no PROGRAM ... ENDP is in the project";

/// A memory that outlasts power.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Save {
    /// Programs, memory and aliases as the image that is loaded at power-up.
    Flash,
    /// System parameters: attachments and settings.
    Eeprom,
}

impl Save {
    /// The command that saves.
    pub const fn command(self) -> &'static str {
        match self {
            // FLASH SAVE would leave out user parameters and the memory that they need.
            Self::Flash => "FLASH IMAGE",
            Self::Eeprom => "ESAVE",
        }
    }
}

/// What a user allows and wants.
#[derive(Clone, Debug, Default)]
#[expect(clippy::struct_excessive_bools, reason = "independent things that a user says")]
pub struct Settings {
    /// Halt programs that run.
    pub halt: bool,
    /// Go on although drives are enabled.
    pub with_drives_enabled: bool,
    /// Send everything, also programs that are there already.
    pub everything: bool,
    /// What lifts the protection of the programs, besides the password of the project.
    pub password: Option<String>,
    /// Programs to start at the end.
    pub run: Vec<UnitName>,
    /// Do not list the programs and compare them at the end.
    pub unverified: bool,
    /// Memories to save in at the end.
    pub save: BTreeSet<Save>,
}

/// What a step does to the programs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Deed {
    /// Nothing.
    Nothing,
    /// It halts the programs; then nothing may move any more.
    Halt,
    /// It erases these.
    Erase(Vec<UnitName>),
    /// It clears system memory.
    Clear,
    /// The text of a program begins.
    Open(UnitName),
    /// A line of a text.
    Text(UnitName),
    /// The text of a program ends here; it is complete unless other lines of it follow.
    Close(UnitName, Fate),
    /// A line takes its place in a text.
    Number(UnitName, Fate),
}

/// A line to be sent, and what is to come back.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// What is sent.
    pub line: String,
    /// The line of the source; `None` for what the project does not say itself.
    pub place: Option<Place>,
    /// The prompt at which it is sent.
    pub level: Level,
    /// The prompt that has to follow.
    pub behind: Level,
    /// Something may be answered.
    pub speaks: bool,
    /// It may take its time.
    pub waits: bool,
    /// What it does to the programs.
    pub deed: Deed,
}

/// A program that is erased.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Erased {
    /// The program.
    pub unit: UnitName,
    /// Its lines; `None` where the controller does not show them.
    pub lines: Option<usize>,
    /// Bytes of its text, where that can be read.
    pub bytes: Option<u32>,
}

/// What a download will do.
#[derive(Clone, Debug, Default)]
pub struct Plan {
    /// System memory is cleared and shared out again.
    pub whole: bool,
    /// What is sent.
    pub steps: Vec<Step>,
    /// What is sent when all programs have been verified, since they cannot be listed behind it.
    pub protect: Vec<Step>,
    /// Programs that are there already.
    pub kept: Vec<UnitName>,
    /// Programs that are erased.
    pub erased: Vec<Erased>,
    /// Blocks of system memory that are given back, with their sizes.
    pub freed: Vec<(SystemBlock, u64)>,
    /// Aliases that are forgotten.
    pub forgotten: usize,
    /// What is worth knowing before.
    pub notes: Vec<(Option<Place>, String)>,
    /// What is known of the programs before the first step.
    pub state: State,
}

impl Plan {
    /// The steps of a project for a controller in this state.
    ///
    /// # Errors
    /// Everything that speaks against it.
    pub fn new(script: &Script, survey: &Survey, model: &Model, settings: &Settings) -> Result<Self, Vec<Objection>> {
        let demand = Demand::of(script);
        let objections = objections(script, survey, &demand, settings);
        if !objections.is_empty() {
            return Err(objections);
        }
        let mut kept = if settings.everything { Vec::new() } else { kept(script, survey) };
        let whole = demand.shares_memory() && (kept.is_empty() || !demand.is_met_by(script, survey));
        if whole {
            kept.clear();
        }
        let mut builder = Builder::new(script, survey, whole, &kept, model);
        builder.prepare(&demand, settings);
        for index in 0..script.lines.len() {
            builder.line(index, &demand);
        }
        builder.goto(Level::System);
        Ok(builder.finish())
    }
}

struct Builder<'a> {
    script: &'a Script,
    survey: &'a Survey,
    kept: &'a [UnitName],
    plan: Plan,
    level: Level,
    model: &'a Model,
}

impl<'a> Builder<'a> {
    fn new(script: &'a Script, survey: &'a Survey, whole: bool, kept: &'a [UnitName], model: &'a Model) -> Self {
        let mut state = State::default();
        for unit in survey.programs.keys().copied().chain(script.units().map(|unit| unit.name)) {
            let fate = match (kept.contains(&unit), survey.programs.contains_key(&unit) || survey.protected.is_some()) {
                (true, _) => Fate::Kept,
                (false, true) => Fate::Old,
                (false, false) => Fate::Missing,
            };
            state.set(unit, fate);
        }
        let plan = Plan { whole, state, kept: kept.to_vec(), ..Plan::default() };
        Self { script, survey, kept, plan, level: Level::System, model }
    }

    /// What comes before the lines of the project.
    fn prepare(&mut self, demand: &Demand, settings: &Settings) {
        if self.script.stores_nothing() {
            self.plan.notes.push((None, NOTHING_STORED.to_owned()));
        }
        self.note_activity();
        if !self.survey.running.is_empty() || !self.survey.moving.is_empty() {
            self.own("HALT ALL", Deed::Halt);
        }
        if self.survey.protected.is_some() {
            let own = self.script.image.password().ok().flatten();
            if let Some(password) = settings.password.clone().or(own) {
                self.own(&format!("PASSWORD OFF \"{password}\""), Deed::Nothing);
            }
        }
        if self.plan.whole {
            self.plan.erased = self.all().into_iter().map(|unit| self.erased(unit)).collect();
            self.plan.freed = self.survey.memory.iter().flatten().map(|(block, size)| (*block, *size)).collect();
            self.plan.forgotten = self.survey.alias_lines.len();
            if !demand.erases_first {
                self.own("NEW ALL", Deed::Erase(self.all()));
            }
            if !demand.clears_first {
                self.own("CLEAR", Deed::Clear);
            }
            if !demand.attaches.is_empty() {
                self.own("DETACH ALL", Deed::Nothing);
            }
            return;
        }
        for unit in self.stale(demand) {
            let erased = self.erased(unit);
            self.plan.erased.push(erased);
            self.goto(level_of(unit));
            self.own("NEW", Deed::Erase(vec![unit]));
        }
        if demand.shares_memory() && !demand.attaches.is_empty() {
            // What a project before this one has attached elsewhere goes as well.
            self.goto(Level::System);
            self.own("DETACH ALL", Deed::Nothing);
        } else {
            for level in &demand.attaches {
                self.goto(*level);
                self.own("DETACH", Deed::Nothing);
            }
        }
        for level in &demand.dims_locals {
            self.goto(*level);
            self.own("CLEAR", Deed::Nothing);
        }
    }

    /// Programs that the controller has.
    fn all(&self) -> Vec<UnitName> {
        if self.survey.protected.is_some() {
            let plcs = (0..self.model.plcs).map(UnitName::Plc);
            return (0..self.model.programs).map(UnitName::Program).chain(plcs).collect();
        }
        self.survey.programs.keys().copied().collect()
    }

    /// What goes on at the controller, where that is allowed.
    fn note_activity(&mut self) {
        let Survey { running, moving, enabled, version, .. } = self.survey;
        let mut notes: Vec<String> =
            running.iter().map(|unit| format!("{unit} runs, or is paused, and is halted")).collect();
        notes.extend(moving.iter().map(|what| format!("{what} is in motion: what follows begins when that has ended")));
        notes.extend(enabled.iter().map(|axis| format!("the drive of AXIS{axis} is enabled and stays so")));
        let model = self.model;
        let named = |model: &&Model| version.iter().any(|line| line.to_ascii_uppercase().contains(model.name));
        let other = acrc_catalog::models().iter().find(named).filter(|_| !named(&model));
        if let Some(other) = other {
            notes.push(format!("the project is for {}, and the controller says that it is {}", model.name, other.name));
        }
        self.plan.notes.extend(notes.into_iter().map(|note| (None, note)));
    }

    fn erased(&self, unit: UnitName) -> Erased {
        let listing = self.survey.programs.get(&unit);
        let names = Names::new(self.survey.aliases.as_deref().unwrap_or_default(), &[]);
        let stored = listing.and_then(|listing| listing.unit(unit, &names.tables));
        Erased { unit, lines: listing.map(|listing| listing.lines.len()), bytes: stored.map(|unit| unit.memory()) }
    }

    /// The programs that are not as the project has them, and those that it erases without having them.
    fn stale(&self, demand: &Demand) -> Vec<UnitName> {
        let erases = |unit: &UnitName| {
            let named = |line: &ScriptLine| match &line.kind {
                Kind::Immediate(Traits { special: Some(Special::Erase(units)), .. }) => units.contains(unit),
                _ => false,
            };
            demand.erases_all || self.script.unit(*unit).is_some() || self.script.lines.iter().any(named)
        };
        self.all().into_iter().filter(|unit| !self.kept.contains(unit)).filter(erases).collect()
    }

    /// Changes the prompt.
    fn goto(&mut self, level: Level) {
        if self.level != level {
            let step = Step { behind: level, ..self.step(&switch(level), Deed::Nothing) };
            self.plan.steps.push(step);
            self.level = level;
        }
    }

    fn own(&mut self, line: &str, deed: Deed) {
        let step = self.step(line, deed);
        self.plan.steps.push(step);
    }

    fn step(&self, line: &str, deed: Deed) -> Step {
        let (level, behind) = (self.level, self.level);
        Step { line: line.to_owned(), place: None, level, behind, speaks: false, waits: false, deed }
    }

    /// A line of the project.
    fn line(&mut self, index: usize, demand: &Demand) {
        let Some(line) = self.script.lines.get(index) else { return };
        if line.unit().is_some_and(|unit| self.kept.contains(&unit)) {
            return;
        }
        let complete = |unit| if demand.ends.get(&unit) == Some(&index) { Fate::Sent } else { Fate::Partial };
        let deed = match (&line.kind, line.unit()) {
            (Kind::Open, Some(unit)) => Deed::Open(unit),
            (Kind::Stored, Some(unit)) => Deed::Text(unit),
            (Kind::Close, Some(unit)) => Deed::Close(unit, complete(unit)),
            (Kind::Numbered, Some(unit)) => Deed::Number(unit, complete(unit)),
            (Kind::Immediate(traits), _) => return self.immediate(line, traits),
            _ => Deed::Nothing,
        };
        self.push(line, deed, &Traits::default());
    }

    fn immediate(&mut self, line: &ScriptLine, traits: &Traits) {
        let deed = match &traits.special {
            Some(Special::EraseAll | Special::Erase(_) | Special::Clear | Special::Dim(_)) if !self.plan.whole => {
                return;
            }
            Some(Special::EraseAll) => Deed::Erase(self.all()),
            Some(Special::Erase(units)) => Deed::Erase(units.clone()),
            Some(Special::Clear) => Deed::Clear,
            Some(Special::Channel) => {
                let note = format!("`{}` is not sent: it is about the terminal that types it", line.text);
                return self.plan.notes.push((Some(line.place), note));
            }
            Some(Special::Protect) => {
                let step = Step { place: Some(line.place), ..self.step(&line.text, Deed::Nothing) };
                self.plan.protect.push(Step { level: line.level, behind: line.behind, ..step });
                return;
            }
            Some(Special::Dim(_)) | None => Deed::Nothing,
        };
        if let Some(first) = traits.acts.first() {
            let what = match first {
                acrc_analysis::Deed::DriveOn => "enables a drive",
                acrc_analysis::Deed::Run => "starts a program",
                _ => "moves an axis",
            };
            self.plan.notes.push((Some(line.place), format!("`{}` {what} at once", line.text)));
        }
        self.push(line, deed, traits);
    }

    fn push(&mut self, line: &ScriptLine, deed: Deed, traits: &Traits) {
        // Within a text a prompt is not changed: what is typed would be stored.
        self.goto(line.level);
        let step = Step { place: Some(line.place), behind: line.behind, ..self.step(&line.text, deed) };
        self.plan.steps.push(Step { speaks: traits.speaks, waits: traits.waits, ..step });
        self.level = line.behind;
    }

    fn finish(mut self) -> Plan {
        self.plan.state.lines = self.plan.steps.len();
        self.plan
    }
}

/// The flag that makes `LIST` number all lines.
pub(super) fn numbers_flag() -> u32 {
    law::LIST_LINE_NUMBERS.at(0)
}
