//! Putting a move together.

use core::marker::PhantomData;

use super::codes::{
    ACCELERATION, ARC_OR_KNOT, BLOCK_SKIP, COUNT_DOWN, COUNTER, COUNTERCLOCKWISE, CURVE, FINAL_VELOCITY,
    FLOATING_POINT, FOV_LOCKOUT, FVEL_LOCKOUT, INCREMENTAL_CENTER, INCREMENTAL_TARGET, INTERRUPT, NURB, SCALING,
    SPLINE, STP_RAMP, VELOCITY,
};
use super::{Arc, ArcDirection, ArcPlane, Codes, Counter, FIELDS, Move, MoveField, Slot, StartRule};
use crate::{Field, WireOptions};

/// The type of targets and centers of a move: `i32` or `f32`.
pub trait Coordinate: Copy + Into<Field> + private::Sealed {
    /// Whether the header has to say so.
    const FLOATING_POINT: bool;
}

impl Coordinate for i32 {
    const FLOATING_POINT: bool = false;
}

impl Coordinate for f32 {
    const FLOATING_POINT: bool = true;
}

mod private {
    pub trait Sealed {}
    impl Sealed for i32 {}
    impl Sealed for f32 {}
}

impl Move {
    /// Begins a move of a master, with targets and centers as long integers (`i32`) or IEEE singles (`f32`).
    pub fn build<C: Coordinate>(master: Slot) -> MoveBuilder<C> {
        let mut codes = Codes::default();
        codes.set_master(master);
        codes.set_if(FLOATING_POINT, C::FLOATING_POINT);
        MoveBuilder { codes, fields: [Field::default(); FIELDS], coordinate: PhantomData }
    }
}

/// Puts a move together. The header says no more than it has to: it has its codes 3 to 7 only when something needs them.
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct MoveBuilder<C> {
    codes: Codes,
    fields: [Field; FIELDS],
    coordinate: PhantomData<C>,
}

impl<C: Coordinate> MoveBuilder<C> {
    /// Sets the velocity of the master.
    pub fn velocity(mut self, velocity: f32) -> Self {
        self.codes.set(VELOCITY);
        self.with(MoveField::Velocity, velocity)
    }

    /// Sets the final velocity of the master.
    pub fn final_velocity(mut self, velocity: f32) -> Self {
        self.codes.set(FINAL_VELOCITY);
        self.with(MoveField::FinalVelocity, velocity)
    }

    /// Sets acceleration and deceleration of the master.
    pub fn acceleration(mut self, acceleration: f32) -> Self {
        self.codes.set(ACCELERATION);
        self.with(MoveField::Acceleration, acceleration)
    }

    /// Says how the move begins, ends and follows the overrides. The form has to fit the master's flag.
    pub fn rule(mut self, rule: StartRule) -> Self {
        let [bit_0, bit_1, bit_2] = match rule {
            StartRule::Lockouts { final_velocity, feedrate_override, stop_ramp } => {
                [final_velocity, feedrate_override, stop_ramp]
            }
            StartRule::Mode { mode, override_lockout } => {
                [mode.number() & 2 != 0, override_lockout, mode.number() & 1 != 0]
            }
        };
        self.codes.set_if(FVEL_LOCKOUT, bit_0);
        self.codes.set_if(FOV_LOCKOUT, bit_1);
        self.codes.set_if(STP_RAMP, bit_2);
        self
    }

    /// Lets it change the move counter of the master.
    pub fn counter(mut self, counter: Counter) -> Self {
        self.codes.set(COUNTER);
        self.codes.set_if(COUNT_DOWN, counter == Counter::Down);
        self
    }

    /// Interrupts the host when the move starts.
    pub fn interrupt(mut self) -> Self {
        self.codes.set(INTERRUPT);
        self
    }

    /// Sets the master's block skip check.
    pub fn block_skip(mut self) -> Self {
        self.codes.set(BLOCK_SKIP);
        self
    }

    /// Sends the header in its longest form, which the guide asks for on dual-port channels.
    pub fn extended(mut self) -> Self {
        self.codes.extend();
        self
    }

    /// Lets the targets count from the present targets of the slaves.
    pub fn incremental(mut self) -> Self {
        self.codes.set(INCREMENTAL_TARGET);
        self
    }

    /// The target of a slave, or its coordinate of a control point.
    pub fn target(mut self, slave: Slot, target: C) -> Self {
        self.codes.set_target(slave);
        self.with(MoveField::Target(slave), target)
    }

    /// Goes along an arc. An arc, a spline and a NURB exclude each other.
    pub fn arc(mut self, arc: Arc<C>) -> Self {
        self.codes.set(ARC_OR_KNOT);
        // The plane without axes has the number behind the last one.
        let plane = ArcPlane::ALL.iter().position(|plane| Some(*plane) == arc.plane).unwrap_or(ArcPlane::ALL.len());
        self.codes.set_plane(plane as u8);
        self.codes.set_if(COUNTERCLOCKWISE, arc.direction == ArcDirection::Counterclockwise);
        self.codes.set_if(INCREMENTAL_CENTER, arc.incremental);
        let [primary, secondary] = arc.center;
        let built = self.with(MoveField::PrimaryCenter, primary).with(MoveField::SecondaryCenter, secondary);
        match arc.scaling {
            Some([primary, secondary]) => built.scaling(primary, secondary),
            None => built,
        }
    }

    /// A piece of a spline, with the targets as its control point.
    pub fn spline(mut self, knot: Option<f32>) -> Self {
        self.codes.set(CURVE);
        self.codes.set(SPLINE);
        let Some(knot) = knot else { return self };
        self.codes.set(ARC_OR_KNOT);
        // A spline has no weight; where the line wants the field, 1 is the weight that changes nothing.
        self.scaling(knot, 1.0)
    }

    /// A piece of a NURB, with the targets as its control point.
    pub fn nurb(mut self, knot: f32, weight: f32) -> Self {
        self.codes.set(CURVE);
        self.codes.set(NURB);
        self.scaling(knot, weight)
    }

    /// The move. What it carries may depend on how the documents are read.
    pub fn finish(self, options: &WireOptions) -> Move {
        let present = self.codes.fields(options);
        let mut fields = self.fields;
        for (number, field) in fields.iter_mut().enumerate() {
            if present & (1 << number) == 0 {
                *field = Field::default();
            }
        }
        Move { codes: self.codes, present, fields }
    }

    fn scaling(mut self, primary: f32, secondary: f32) -> Self {
        self.codes.set(SCALING);
        self.with(MoveField::PrimaryScalingOrKnot, primary).with(MoveField::SecondaryScalingOrWeight, secondary)
    }

    fn with(mut self, field: MoveField, value: impl Into<Field>) -> Self {
        if let Some(place) = self.fields.get_mut(usize::from(field.number())) {
            *place = value.into();
        }
        self
    }
}
