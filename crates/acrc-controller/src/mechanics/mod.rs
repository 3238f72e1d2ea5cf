//! What the axes drive, where the world says more of it than nothing: servo loop and plant, switches and marks along the way, captures, faults (guide,
//! "Servo Loop Fundamentals", "Following Error", "Homing", "Error Handling").
//!
//! The arithmetic is that of [`acrc_motion::servo`] and [`acrc_motion::axis`]. An axis of which the world says nothing has no entry here and costs
//! nothing: its actual position is its setpoint.
//!
//! Positions are in pulses of the encoder. The *place* of a machine is what it has moved since power-up; no command changes it. The actual position
//! of the axis is the place without the *origin*, which `RES` and its like move, and without what an encoder has missed.

mod captures;
mod faults;
mod sensors;
mod settings;
mod tick;

pub(crate) use captures::{CaptureState, Seek, sought};

use acrc_motion::axis::Bands;
use acrc_motion::servo::{Dac, Motor, Plant, Servo};

use crate::axis::Axis;
use crate::machine::Machine;
use crate::world::{AxisWorld, PlantWorld, World};

/// Seconds after which a motor stands whose encoder does not count.
const STANDING: f64 = 0.02;

/// The mechanics of all axes.
#[derive(Clone, Debug, Default)]
#[expect(clippy::struct_excessive_bools, reason = "each spares a search in every tick")]
pub(crate) struct Mechanics {
    /// By axis; empty when the world says nothing of any.
    axes: Vec<Option<Box<Mechanism>>>,
    /// The next tick changes one of them although nothing else happens.
    busy: bool,
    /// One of them moves, although its setpoint may not.
    moves: bool,
    /// An input captures positions.
    captures: bool,
    /// A master looks for marks.
    seeks: bool,
}

impl Mechanics {
    pub(crate) fn new(world: &World, axes: u8, period: f64) -> Self {
        let mut mechanics = Self::default();
        for axis in world.concerned_axes().filter(|axis| *axis < axes) {
            mechanics.axes.resize_with(usize::from(axes), || None);
            let described = world.axes().find(|(described, _)| *described == axis).map(|(_, world)| world.clone());
            let described = described.unwrap_or_default();
            mechanics.captures |= !described.capture_inputs.is_empty();
            mechanics.axes[usize::from(axis)] = Some(Box::new(Mechanism::new(described, period)));
        }
        mechanics
    }

    /// Whether the world says nothing of any axis.
    fn is_empty(&self) -> bool {
        self.axes.is_empty()
    }

    #[inline]
    pub(crate) fn of(&self, axis: u8) -> Option<&Mechanism> {
        self.axes.get(usize::from(axis))?.as_deref()
    }

    fn of_mut(&mut self, axis: u8) -> Option<&mut Mechanism> {
        self.axes.get_mut(usize::from(axis))?.as_deref_mut()
    }

    /// Whether the next tick changes something although nothing else happens.
    pub(crate) fn is_busy(&self) -> bool {
        self.busy
    }

    /// Whether something moves although its setpoint may not.
    pub(crate) fn moves(&self) -> bool {
        self.moves
    }

    /// The controller has lost power: its drives are off, and its registers begin where the machines are.
    pub(crate) fn restart(&mut self) {
        for mechanism in self.axes.iter_mut().flatten() {
            mechanism.origin = mechanism.counted();
            // As the flags are at power-up.
            (mechanism.in_position, mechanism.error_allowed) = (true, true);
            mechanism.forget();
        }
        // A machine that still turns is nothing that the controller moves.
        self.moves = false;
    }

    /// The axes whose encoders have no signals.
    pub(crate) fn blind(&self) -> impl Iterator<Item = u8> {
        let axes = (0..).zip(&self.axes);
        axes.filter_map(|(axis, mechanism)| mechanism.as_ref().is_some_and(|mechanism| mechanism.blind).then_some(axis))
    }
}

/// What one axis drives.
#[derive(Clone, Debug)]
#[expect(clippy::struct_excessive_bools, reason = "each is a state of its own")]
pub(crate) struct Mechanism {
    world: AxisWorld,
    plant: Plant,
    servo: Option<Servo>,
    dac: Dac,
    /// The analog output that drives the motor.
    dac_number: u8,
    /// Output of the loop at the terminal, V.
    volts: f64,
    /// Setpoint of the last tick, pulses of the axis.
    setpoint: f64,
    /// Where the machine is, pulses since power-up.
    place: f64,
    /// What the encoder shows where the actual position is zero.
    origin: f64,
    /// What the encoder has not counted.
    missed: f64,
    /// Where the load is behind the play, pulses.
    load: f64,
    /// Where the marks were last looked for, pulses.
    looked: f64,
    /// Something holds it.
    jammed: bool,
    /// Its encoder has no signals.
    blind: bool,
    /// The drive was on in the last tick.
    driven: bool,
    bands: Bands,
    in_position: bool,
    error_allowed: bool,
    /// The last tick has changed nothing, and the next one will not.
    steady: bool,
    /// Ticks since the encoder has counted.
    quiet: u32,
    /// The levels of its switches as they were last shown.
    levels: Vec<Option<bool>>,
}

impl Mechanism {
    fn new(world: AxisWorld, period: f64) -> Self {
        let (plant, servo) = match world.plant {
            PlantWorld::Ideal => (Plant::default(), None),
            PlantWorld::Stepper(stepper) => (Plant::Stepper(stepper), None),
            PlantWorld::Motor(motor) => {
                let motor = Motor::new(motor.model).map_or(Plant::default(), Plant::Motor);
                (motor, Servo::new(period).ok())
            }
        };
        Self {
            levels: vec![None; world.switches.len()],
            world,
            plant,
            servo,
            dac: Dac::default(),
            dac_number: 0,
            volts: 0.0,
            setpoint: 0.0,
            place: 0.0,
            origin: 0.0,
            missed: 0.0,
            load: 0.0,
            looked: 0.0,
            jammed: false,
            blind: false,
            driven: false,
            bands: Bands::default(),
            in_position: true,
            error_allowed: true,
            steady: false,
            quiet: 0,
        }
    }

    /// What the encoder has counted, pulses.
    fn counted(&self) -> f64 {
        self.place - self.missed
    }

    /// The actual position, pulses; `None` where it is the setpoint.
    pub(crate) fn actual(&self) -> Option<f64> {
        (!self.is_led()).then(|| self.counted() - self.origin)
    }

    /// Whether the machine goes wherever the setpoint is.
    pub(crate) fn is_ideal(&self) -> bool {
        matches!(self.plant, Plant::Ideal { .. })
    }

    /// Whether it is there now.
    fn is_led(&self) -> bool {
        self.is_ideal() && !self.jammed && !self.blind
    }

    /// Whether the following error lies in the in-position band.
    pub(crate) fn in_position(&self) -> bool {
        self.in_position
    }

    /// Forgets what the loop remembers.
    fn forget(&mut self) {
        self.steady = false;
        if let Some(servo) = &mut self.servo {
            servo.reset();
        }
    }
}

impl Machine {
    /// Lets the actual position of an axis be called by another number: nothing moves. `setpoint` is what the secondary setpoint becomes. All in units.
    pub(crate) fn rename_actual(&mut self, axis: u8, before: f64, after: f64, setpoint: f64) {
        let state = &self.axes[usize::from(axis)];
        let scale = state.pulses_per_unit;
        let [old, new] = [before, after].map(|units| state.pulses(units));
        self.renumber_encoder(axis, old, new);
        let Some(mechanism) = self.mechanics.of_mut(axis) else { return };
        if mechanism.is_led() {
            mechanism.place = before * scale + mechanism.origin;
        }
        mechanism.origin = mechanism.counted() - after * scale;
        if setpoint == after {
            mechanism.plant.match_setpoint(after * scale + mechanism.origin);
        }
        mechanism.forget();
    }

    /// Where the load of an axis is, behind the play of its mechanics, in units of the machine.
    pub(crate) fn load(&self, axis: u8) -> Option<f64> {
        let mechanism = self.mechanics.of(axis)?;
        Some(mechanism.units(mechanism.load, &self.axes[usize::from(axis)]))
    }
}

impl Mechanism {
    /// A place in units of the machine.
    fn units(&self, place: f64, axis: &Axis) -> f64 {
        axis.units(place) + self.world.start
    }
}
