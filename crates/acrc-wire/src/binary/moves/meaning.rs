//! What a move says.

use super::codes::{
    ARC_OR_KNOT, BLOCK_SKIP, COUNT_DOWN, COUNTER, COUNTERCLOCKWISE, CURVE, FLOATING_POINT, FOV_LOCKOUT, FVEL_LOCKOUT,
    INCREMENTAL_CENTER, INCREMENTAL_TARGET, INTERRUPT, NURB, STP_RAMP,
};
use super::{Move, MoveField, Slot};
use crate::Field;

/// The state of the master's flag "Enable Rapid Move Modes" (secondary master flags, index 5; off at power-up). It
/// decides what the bits 0 and 2 of header code 0 mean.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RapidMoveModes {
    /// The flag is clear.
    #[default]
    Disabled,
    /// The flag is set.
    Enabled,
}

/// How a move begins, ends, and follows the overrides: bits 0 to 2 of header code 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StartRule {
    /// With rapid move modes disabled.
    Lockouts {
        /// The final velocity is zero for this move.
        final_velocity: bool,
        /// The feedrate override is 1.0 for this move.
        feedrate_override: bool,
        /// The stop ramp is the deceleration; otherwise there is none.
        stop_ramp: bool,
    },
    /// With rapid move modes enabled.
    Mode {
        /// The kind of move.
        mode: MoveMode,
        /// The override that applies, feedrate or rapid, is 1.0 for this move.
        override_lockout: bool,
    },
}

/// The kinds of moves when rapid move modes are enabled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MoveMode {
    /// Mode 0.
    FeedContinuous,
    /// Mode 1.
    FeedCornering,
    /// Mode 2.
    FeedStopping,
    /// Mode 3.
    Rapid,
}

impl MoveMode {
    /// Its number: bit 0 is in bit 2 of header code 0, bit 1 in bit 0.
    pub const fn number(self) -> u8 {
        self as u8
    }

    const fn of(bit_1: bool, bit_0: bool) -> Self {
        match (bit_1, bit_0) {
            (false, false) => Self::FeedContinuous,
            (false, true) => Self::FeedCornering,
            (true, false) => Self::FeedStopping,
            (true, true) => Self::Rapid,
        }
    }
}

/// How a move changes the move counter of its master.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Counter {
    /// Counts up.
    Up,
    /// Counts down.
    Down,
}

/// A coordinate in programming units or pulses, as its move has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Number {
    /// A long integer.
    Long(i32),
    /// An IEEE single.
    Single(f32),
}

/// The two axes of an arc, primary first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArcPlane {
    /// Slaves 0 and 1.
    Slaves01,
    /// Slaves 1 and 2.
    Slaves12,
    /// Slaves 2 and 0.
    Slaves20,
}

impl ArcPlane {
    /// Every plane, in the order of their numbers.
    pub const ALL: [Self; 3] = [Self::Slaves01, Self::Slaves12, Self::Slaves20];

    /// The primary and the secondary axis.
    pub const fn axes(self) -> [Slot; 2] {
        match self {
            Self::Slaves01 => [Slot(0), Slot(1)],
            Self::Slaves12 => [Slot(1), Slot(2)],
            Self::Slaves20 => [Slot(2), Slot(0)],
        }
    }
}

/// The direction of an arc: counterclockwise is from the positive primary axis toward the positive secondary axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArcDirection {
    /// Clockwise.
    Clockwise,
    /// Counterclockwise.
    Counterclockwise,
}

/// An arc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc<C> {
    /// Its axes. None for the plane that the guide reserves.
    pub plane: Option<ArcPlane>,
    /// Its direction.
    pub direction: ArcDirection,
    /// Its center on the primary and the secondary axis.
    pub center: [C; 2],
    /// Whether the center counts from the present targets of the slaves.
    pub incremental: bool,
    /// Scaling of its radius on the primary and the secondary axis.
    pub scaling: Option<[f32; 2]>,
}

/// What a move goes along.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Path {
    /// A line to the targets.
    Line,
    /// An arc of two slaves; the others go along a line.
    Arc(Arc<Number>),
    /// A piece of a spline; the targets are its control point.
    Spline {
        /// Its knot.
        knot: Option<f32>,
    },
    /// A piece of a NURB; the targets are its control point.
    Nurb {
        /// Its knot.
        knot: Option<f32>,
        /// Its weight.
        weight: Option<f32>,
    },
}

impl Move {
    /// The master that moves.
    pub fn master(&self) -> Slot {
        self.codes.master()
    }

    /// The velocity of the master, if the move sets it.
    pub fn velocity(&self) -> Option<f32> {
        self.field(MoveField::Velocity).map(Field::single)
    }

    /// The final velocity of the master, if the move sets it.
    pub fn final_velocity(&self) -> Option<f32> {
        self.field(MoveField::FinalVelocity).map(Field::single)
    }

    /// The acceleration and deceleration of the master, if the move sets them.
    pub fn acceleration(&self) -> Option<f32> {
        self.field(MoveField::Acceleration).map(Field::single)
    }

    /// How it begins, ends and follows the overrides.
    pub fn rule(&self, modes: RapidMoveModes) -> StartRule {
        let bits = [FVEL_LOCKOUT, FOV_LOCKOUT, STP_RAMP].map(|bit| self.codes.has(bit));
        match (modes, bits) {
            (RapidMoveModes::Disabled, [final_velocity, feedrate_override, stop_ramp]) => {
                StartRule::Lockouts { final_velocity, feedrate_override, stop_ramp }
            }
            (RapidMoveModes::Enabled, [bit_1, override_lockout, bit_0]) => {
                StartRule::Mode { mode: MoveMode::of(bit_1, bit_0), override_lockout }
            }
        }
    }

    /// How it changes the move counter of its master, if it does.
    pub fn counter(&self) -> Option<Counter> {
        let direction = if self.codes.has(COUNT_DOWN) { Counter::Down } else { Counter::Up };
        self.codes.has(COUNTER).then_some(direction)
    }

    /// Whether the host is interrupted when it starts.
    pub fn interrupts(&self) -> bool {
        self.codes.has(INTERRUPT)
    }

    /// Whether it sets the master's block skip check.
    pub fn checks_block_skip(&self) -> bool {
        self.codes.has(BLOCK_SKIP)
    }

    /// Whether its targets count from the present targets of the slaves.
    pub fn is_incremental(&self) -> bool {
        self.codes.has(INCREMENTAL_TARGET)
    }

    /// The slaves that it has targets for.
    pub fn targets(&self) -> impl Iterator<Item = (Slot, Number)> {
        Slot::all().filter_map(|slave| Some((slave, self.number(MoveField::Target(slave))?)))
    }

    /// What it goes along.
    pub fn path(&self) -> Path {
        let single = |field| self.field(field).map(Field::single);
        let primary = single(MoveField::PrimaryScalingOrKnot);
        let secondary = single(MoveField::SecondaryScalingOrWeight);
        let centers = (self.number(MoveField::PrimaryCenter), self.number(MoveField::SecondaryCenter));
        match (self.codes.has(CURVE), centers) {
            (true, _) if self.codes.has(NURB) => Path::Nurb { knot: primary, weight: secondary },
            (true, _) => Path::Spline { knot: primary.filter(|_| self.codes.has(ARC_OR_KNOT)) },
            (false, (Some(first), Some(second))) => Path::Arc(Arc {
                plane: ArcPlane::ALL.get(usize::from(self.codes.plane())).copied(),
                direction: self.direction(),
                center: [first, second],
                incremental: self.codes.has(INCREMENTAL_CENTER),
                scaling: primary.zip(secondary).map(|(primary, secondary)| [primary, secondary]),
            }),
            (false, _) => Path::Line,
        }
    }

    fn direction(&self) -> ArcDirection {
        if self.codes.has(COUNTERCLOCKWISE) { ArcDirection::Counterclockwise } else { ArcDirection::Clockwise }
    }

    fn number(&self, field: MoveField) -> Option<Number> {
        let field = self.field(field)?;
        let floating_point = self.codes.has(FLOATING_POINT);
        Some(if floating_point { Number::Single(field.single()) } else { Number::Long(field.long()) })
    }
}
