//! Everything of the controller but the programs' text: memory, flags, axes, masters, attachments. One tick of it moves the machine on by a
//! servo period.

use std::collections::BTreeSet;

use acrc_catalog::{Model, law};
use acrc_image::AxisName;
use acrc_motion::axis::BacklashRule;
use acrc_motion::{HoldState, Master as Profiler, Phase};
use acrc_syntax::units::Level;
use acrc_vm::Text;

use crate::axis::Axis;
use crate::error::ControllerError;
use crate::flags::Flags;
use crate::host_interface::FastUpdates;
use crate::master::{Master, SLOTS};
use crate::mechanics::Mechanics;
use crate::memory::SystemMemory;
use crate::motion::{Arrays, AxisMotion, NoArrays};
use crate::network::Network;
use crate::nonvolatile::NonVolatile;
use crate::registers::Registers;
use crate::request::Request;
use crate::settings::Settings;
use crate::streams::Streams;
use crate::task::Task;
use crate::terminal::Terminal;
use crate::time::Clock;
use crate::world::World;

/// The attachments and run state of one program, as other programs and flags see them.
#[derive(Clone, Debug, Default)]
pub(crate) struct Attachment {
    pub(crate) master: Option<u8>,
    /// Names of the axes in the slots of its master.
    pub(crate) names: [Option<AxisName>; SLOTS],
}

/// The controller without its programs.
#[derive(Debug)]
pub(crate) struct Machine {
    pub(crate) model: &'static Model,
    pub(crate) clock: Clock,
    pub(crate) flags: Flags,
    pub(crate) memory: SystemMemory,
    pub(crate) nonvolatile: NonVolatile,
    pub(crate) settings: Settings,
    /// Parameters without behaviour of their own, by number.
    pub(crate) registers: Registers,
    pub(crate) axes: Vec<Axis>,
    pub(crate) masters: Vec<Master>,
    pub(crate) attachments: Vec<Attachment>,
    /// Count of each encoder beyond the actual position of the axis that it measures, in pulses.
    pub(crate) encoder_offsets: Vec<i32>,
    /// What commands have added to the count of each encoder while nothing moved, in pulses: nothing follows that.
    pub(crate) renumbered: Vec<i32>,
    /// Tick at which the clock parameter was last set, and to what.
    pub(crate) clock_base: (u64, i32),
    /// How often it has restarted since power-up.
    pub(crate) restarts: u32,
    /// The prompt level of the immediate statement that is being executed: of the setup code, or of the channel that typed it.
    pub(crate) level: Level,
    pub(crate) terminal: Terminal,
    /// What the axes do by themselves.
    pub(crate) motion: AxisMotion,
    /// What they drive.
    pub(crate) mechanics: Mechanics,
    /// The texts of `IP`: address, mask and gateway.
    pub(crate) network: Network,
    /// What protects the programs from `LIST` (`PASSWORD`).
    pub(crate) password: Option<Text>,
    /// The hardware of `CONFIG` where it is not that of the factory.
    pub(crate) config: Option<String>,
    /// Updates of fast status.
    pub(crate) fast_status: FastUpdates,
    pub(crate) requests: Vec<Request>,
    pub(crate) streams: Streams,
    /// What the run relied on without proof, or left out; each said once.
    pub(crate) notes: BTreeSet<String>,
    pub(crate) random: u64,
    pub(crate) world: World,
    /// When backlash compensation is added.
    pub(crate) backlash: BacklashRule,
    /// Which scripted event comes next.
    pub(crate) next_event: usize,
}

impl Machine {
    pub(crate) fn new(model: &'static Model, world: World, seed: u64) -> Self {
        let mut machine = Self {
            model,
            clock: Clock::new(model.servo_period),
            flags: Flags::new(),
            memory: SystemMemory::new(model),
            nonvolatile: NonVolatile::default(),
            settings: Settings::default(),
            registers: Registers::new(),
            axes: (0..model.axes).map(|_| Axis::new()).collect(),
            masters: (0..model.masters).map(|_| Master::new()).collect(),
            attachments: vec![Attachment::default(); usize::from(model.programs)],
            encoder_offsets: vec![0; usize::from(model.axes)],
            renumbered: vec![0; usize::from(model.axes)],
            clock_base: (0, 0),
            restarts: 0,
            level: Level::System,
            terminal: Terminal::default(),
            motion: AxisMotion::new(),
            mechanics: Mechanics::new(&world, model.axes, model.servo_period),
            network: Network::of(model),
            password: None,
            config: None,
            fast_status: FastUpdates::default(),
            requests: Vec::new(),
            streams: Streams::default(),
            notes: BTreeSet::new(),
            random: seed,
            world,
            backlash: BacklashRule::default(),
            next_event: 0,
        };
        for axis in 0..u32::from(model.axes) {
            // There is no following error before anything moves.
            machine.flags.set_law(law::NOT_EXCESS_ERROR, axis, true);
        }
        machine.set_defaults();
        machine.note_missing_axes();
        machine.sense_all();
        machine
    }

    /// The world it runs in.
    pub(crate) fn world(&self) -> &World {
        &self.world
    }

    /// Applies the events that are due at the present tick.
    pub(crate) fn apply_events(&mut self) {
        while self.next_event_tick().is_some_and(|tick| tick <= self.clock.ticks()) {
            let world = std::mem::take(&mut self.world);
            let event = &world.events()[self.next_event];
            for (bits, state) in [(&event.set, true), (&event.clear, false)] {
                for bit in bits {
                    self.set_from_outside(*bit, state);
                }
            }
            for (number, value) in &event.parameters {
                self.script_parameter(*number, *value);
            }
            for happening in &event.happenings {
                self.happen(*happening);
            }
            self.world = world;
            self.motion.wake();
            self.next_event += 1;
        }
    }

    /// Notes what the world says of axes that the model lacks.
    fn note_missing_axes(&mut self) {
        let (model, axes) = (self.model.name, self.model.axes);
        for axis in self.world.concerned_axes().filter(|axis| *axis >= axes) {
            let last = axes.saturating_sub(1);
            self.notes.insert(format!("the world describes axis {axis}: the {model} has axis 0 to {last}"));
        }
    }

    /// How many scripted events have happened.
    pub(crate) fn applied_events(&self) -> usize {
        self.next_event
    }

    /// Tick of the next scripted event.
    pub(crate) fn next_event_tick(&self) -> Option<u64> {
        self.world.events().get(self.next_event).map(|event| self.clock.tick_at(event.at))
    }

    /// Whether a master has moves that run or wait.
    pub(crate) fn moves(&self, master: usize) -> bool {
        self.masters[master].profiler.in_motion()
    }

    /// Whether anything moves.
    pub(crate) fn in_motion(&self) -> bool {
        self.masters.iter().any(|master| master.profiler.in_motion())
            || self.motion.is_awake() && self.axes.iter().any(Axis::moves)
            || self.mechanics.moves()
    }

    /// Whether the next tick may change something: something moves, or axes look at what has just happened.
    pub(crate) fn is_busy(&self) -> bool {
        self.motion.is_awake()
            || self.is_sampling_due()
            || self.mechanics.is_busy()
            || self.masters.iter().any(|master| master.profiler.in_motion())
    }

    /// Moves time on by one tick: scripted events, then the profilers, then the flags that follow from them.
    pub(crate) fn tick(&mut self, arrays: &mut dyn Arrays) {
        self.clock.advance(1);
        self.read_sources();
        self.apply_events();
        for index in 0..self.masters.len() {
            if self.masters[index].profiler.in_motion() {
                self.advance_master(index);
            } else if self.masters[index].settling {
                self.settle_master(index);
            }
        }
        self.start_groups();
        self.advance_axes(self.clock.period(), arrays);
        self.end_seeks();
    }

    /// Takes note of what ended moves have left behind.
    pub(crate) fn settle(&mut self) {
        for index in 0..self.masters.len() {
            if self.masters[index].settling {
                self.settle_master(index);
            }
        }
    }

    fn settle_master(&mut self, index: usize) {
        let master = &mut self.masters[index];
        master.settling = false;
        let advanced = master.profiler.advance(self.clock.period());
        self.note_drop(index, advanced.dropped_velocity);
    }

    /// Notes a velocity that dropped to zero at the end of a move.
    fn note_drop(&mut self, index: usize, velocity: f64) {
        if velocity > 0.0 {
            let velocity = rounded(velocity);
            self.notes.insert(format!(
                "master {index}: a move ended at {velocity} units/s with nothing to follow it, so its velocity dropped to zero at once (STP 0, FVEL, or a path too short to slow down)"
            ));
        }
    }

    /// Moves time on by `ticks` in which nothing happens.
    pub(crate) fn skip(&mut self, ticks: u64) {
        self.settle();
        self.clock.advance(ticks);
        self.apply_events();
        self.advance_axes(0.0, &mut NoArrays);
    }

    /// Moves time on to a tick up to which nothing happens; not back.
    pub(crate) fn skip_to(&mut self, tick: u64) {
        if let Some(ticks) = tick.checked_sub(self.clock.ticks()).filter(|ticks| *ticks > 0) {
            self.skip(ticks);
        }
    }

    fn advance_master(&mut self, index: usize) {
        let master = &self.masters[index];
        let mut from = [0.0; SLOTS];
        for (slot, _) in master.attached() {
            from[slot] = master.profiler.position(slot);
        }
        let accelerated = master.profiler.vector_acceleration() > 0.0;
        let advanced = self.pass_time(index);
        let master = &mut self.masters[index];
        let crest = if accelerated { crest(&master.profiler) } else { 1.0 };
        master.statistics.moves += u64::from(advanced.completed);
        if advanced.completed > 0 {
            master.ahead.redirection = None;
        }
        master.settling = !master.profiler.in_motion();
        master.statistics.motion_ticks += 1;
        for (slot, axis) in master.attached() {
            let (velocity, acceleration) = master.motion(slot);
            let position = master.profiler.position(slot);
            let axis = &mut self.axes[usize::from(axis)];
            if axis.profilers.active() {
                axis.carried = position - from[slot];
                continue;
            }
            axis.statistics.record(from[slot], position, velocity * crest, acceleration);
        }
        if advanced.stopped {
            self.stopped(index);
        }
        self.note_drop(index, advanced.dropped_velocity);
        self.watch_moves(index);
        self.update_master_flags(index);
    }

    /// Brings the flags of a master and of its axes in line with its profiler.
    pub(crate) fn update_master_flags(&mut self, index: usize) {
        let profiler = &self.masters[index].profiler;
        let hold = profiler.hold_state();
        let phase = profiler.phase();
        let states = [
            (law::IN_MOTION, profiler.in_motion()),
            (law::ACCELERATING, phase == Phase::Accelerating),
            (law::DECELERATING, phase == Phase::Decelerating),
            (law::STOPPING, phase == Phase::Stopping),
            (law::FEEDHOLDING, hold == HoldState::Feedholding),
            (law::IN_FEEDHOLD, hold == HoldState::InFeedhold),
        ];
        for (law, state) in states {
            self.flags.set_law(law, index as u32, state);
        }
        for slot in 0..SLOTS {
            if let Some(axis) = self.masters[index].slots[slot] {
                self.update_in_position(axis);
            }
        }
    }

    /// The axis that a program knows by a name.
    pub(crate) fn named_axis(&self, program: u8, name: AxisName) -> Result<u8, ControllerError> {
        let unknown = || ControllerError::UnknownAxis { program, name: name.to_string() };
        let attachment = self.attachments.get(usize::from(program)).ok_or_else(unknown)?;
        let slot = attachment.names.iter().position(|entry| *entry == Some(name)).ok_or_else(unknown)?;
        let master = self.master_of(program)?;
        self.masters[usize::from(master)].slots[slot].ok_or_else(unknown)
    }

    /// The master of a program.
    pub(crate) fn master_of(&self, program: u8) -> Result<u8, ControllerError> {
        self.attachments
            .get(usize::from(program))
            .and_then(|attachment| attachment.master)
            .ok_or(ControllerError::NoMaster(program))
    }

    /// The name that some program gives an axis.
    pub(crate) fn axis_name(&self, axis: u8) -> Option<AxisName> {
        let slave = self.axes[usize::from(axis)].slave?;
        let program = self.masters[usize::from(slave.master)].program?;
        self.attachments[usize::from(program)].names[usize::from(slave.slot)]
    }

    /// Drive enable of an axis.
    pub(crate) fn set_drive(&mut self, axis: u8, enabled: bool) {
        if enabled && !self.is_motion_enabled() {
            self.notes.insert(format!(
                "the drive of axis {axis} was not enabled: the motion enable input is open or latched (BIT5646, BIT5645)"
            ));
            return;
        }
        self.motion.wake();
        self.flags.set_law(law::DRIVE_ENABLE, u32::from(axis), enabled);
        self.flags.set_law(law::DRIVE_ENABLED_STATUS, u32::from(axis), enabled);
        self.axes[usize::from(axis)].was_enabled |= enabled;
    }

    /// Bytes that a program has for its text and its variables.
    pub(crate) fn space(&self, task: Task) -> u64 {
        self.memory.size(task.space()).map_or(0, u64::from)
    }

    /// Milliseconds of the free-running clock parameter.
    pub(crate) fn clock_milliseconds(&self) -> i32 {
        let (tick, value) = self.clock_base;
        let elapsed = (self.clock.ticks() - tick) as f64 * self.clock.period() * 1000.0;
        // Wraps to 0 at 2^31.
        ((i64::from(value) + (elapsed + 1e-6) as i64) & 0x7fff_ffff) as i32
    }

    /// Checks an object number against the model.
    pub(crate) fn object(object: &'static str, index: i64, count: u8) -> Result<u8, ControllerError> {
        match u8::try_from(index) {
            Ok(number) if number < count => Ok(number),
            _ => Err(ControllerError::NoSuchObject { object, index, last: count.saturating_sub(1) }),
        }
    }
}

/// A value for a message, with no more digits than a person reads.
fn rounded(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}

/// How much higher than now the velocity was inside a tick that began with acceleration: where the profile turned to deceleration, its peak lies
/// between two ticks.
fn crest(profiler: &Profiler) -> f64 {
    let now = profiler.path_state();
    match profiler.profile() {
        Some(profile) if now.acceleration < 0.0 && now.velocity > 0.0 => profile.peak_velocity() / now.velocity,
        _ => 1.0,
    }
}
