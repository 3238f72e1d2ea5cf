//! The motion core: profiles along a path and the masters that run them.
//!
//! This crate is pure computation. It knows no language, no file and no clock: the caller says how much time has
//! passed, and reads where everything is. It implements the coordinated part of the guide's chapter "Making Motion"
//! ("Move Types", "What are Motion Profiles?", "Velocity Profile Commands", "Coordinated Moves Profiler").
//!
//! - [`Profile`] is the motion along one path: planned once, in closed form, and sampled at any time.
//! - [`Master`] is a coordinated-move profiler: it queues [`Move`]s, blends one into the next, and turns the position
//!   along the path into the positions of up to [`AXES`] axes.
//! - [`CurveBuilder`] makes the pieces of splines and NURBS curves from their points and knots.
//! - [`axis`] has what belongs to one axis: jog, homing, gear, cam, setpoint registers, limits and the kill protocol.
//! - [`source`] has ratchets and limiters of sources, and the programmable limit switch.
//! - [`servo`] has the servo loop and the machines it can drive.
//!
//! # Units
//!
//! Lengths are programming units (u), times seconds, so velocities are u/s, accelerations u/s² and jerks u/s³, all
//! along the path. A zero switches a ramp or a feature off: an acceleration of zero is a step in velocity.
//!
//! # Determinism
//!
//! The same calls give the same bits on every machine: only `+ - * /` and the square root are used, each of which
//! IEEE 754 rounds in one way; there is no fused multiply-add and no power. What more is needed (sines and angles of arcs
//! and rotations, tangents of output filters, exponentials of a motor with friction) comes from the crate `libm` without
//! its feature `arch`: the same sequence of such operations on every machine, never the platform's library. The feature
//! `std` (default) only chooses the processor's square root; without it the crate is `no_std` and takes roots in integer
//! arithmetic with the same result.
//!
//! Positions are functions of the time since a profile began and are never integrated, so nothing drifts.
//!
//! # Assumptions
//!
//! What the documents at hand leave open, and how it is read here:
//!
//! - SINE: the phase runs evenly with the part of the path. An axis that is not where its sinusoid begins comes over to
//!   it evenly, so that it is at the target at the end. The length that counts is that of the root of the mean square of
//!   the speed, which makes two sinusoids that draw a circle as long as the circle.
//! - CIRCW, CIRCCW: the first axis named is the primary one. An arc whose end lies in the direction of its start, but is
//!   not the end of the move before, is a straight move. With different weights of both axes the length is that of the
//!   root of the mean square too.
//! - TARC: the second value of each axis is a point on the way. Three points on a line are refused.
//! - ROTARY: acts on absolute targets of straight moves, behind the transformations. At exactly half a turn the axis goes
//!   the way the target says. Positions go on counting.
//! - SCALE comes first, then ROTATE, then OFFSET and FLZ. Relative targets are scaled and rotated, not shifted. An arc
//!   under different factors is an ellipse, and a mirrored one runs the other way round. FLZ puts the programmed zero at
//!   its value from where the last queued move ends. Where ROTATE mixes axes of different weights on an arc or a
//!   sinusoid, each weight goes with the programmed axis.
//! - TANG: the axis is where the path points, also at corners, where it jumps the short way; the documents name no rule
//!   for corners.
//! - SPLINE goes through its points, with the direction at each that of the parabola through it and its neighbours.
//!   NURB draws B-splines with weights; the first knots come with the points. Both begin at their first point. All but
//!   the last piece hand their velocity over; they look ahead as far as pieces wait.
//! - LOOK: up to the first angle a corner costs nothing, from the second on it is a stop, between them the velocity falls
//!   evenly. Moves without STP brake with DEC, and for rest at the end of the last known move.
//! - TRG: the move begins from rest unless its condition holds in the tick in which the move before ends.
//! - INT: the move comes to rest with DEC and is over; the next is laid from there, and is not accepted before.
//! - HSINT: the move goes on to the new end, or comes to rest with DEC and returns where that is too near or behind.
//! - TRJ: what runs and what waits is dropped; the velocity along the path is kept, whatever the new direction.
//! - SYNC: moves of a group begin in the same tick; each takes its own time.
//! - SRC: a count of the source is a servo period for the moves. Counts back run the profile back to where it was last
//!   planned and are lost beyond that; the hold, the gate and the queue do not go back.
//! - ROV acts on rapid moves only, in the way FOV acts on the others.
//! - FOV, ROV and holds in an S-curve: the jerk is kept. An acceleration that does not fit what is wanted ends first.
//!   The last ramp down is left as it was, and so is a ramp if the change would let the move end too fast.
//!
//! # Memory
//!
//! A master owns one ring of waiting moves, and a cam the list of its segments, allocated when their number is set.
//! Everything else has a fixed size: queueing, planning and ticks cannot allocate.
//!
//! # Example
//!
//! ```
//! use acrc_motion::{Master, Move, MoveSettings, Target};
//!
//! let mut master = Master::new(1);
//! let settings = MoveSettings { velocity: 20.0, acceleration: 10.0, stop: 10.0, ..MoveSettings::default() };
//! master.push(&Move::new(settings).to(0, Target::Absolute(200.0)))?;
//! assert_eq!(master.next_event(), Some(12.0)); // 2 s up, 8 s across, 2 s down
//!
//! master.advance(6.0);
//! assert_eq!(master.position(0), 100.0);
//! # Ok::<(), acrc_motion::PushError>(())
//! ```
#![cfg_attr(not(feature = "std"), no_std)]

extern crate alloc;

pub mod axis;
mod master;
mod profile;
mod root;
pub mod servo;
mod solve;
pub mod source;
mod timer;
mod trig;
mod value;
mod wrap;

pub use master::{
    AXES, Advanced, Arc, ControlPoint, CurveBuilder, CurveError, HoldState, Lookahead, Master, Move, MoveSettings,
    Override, Phase, PushError, SettingError, Sine, SpaceArc, Span, Tangent, Target, Turn, start_together,
};
pub use profile::{Profile, ProfileError, ProfileRequest, State};
pub use value::{InvalidValue, Quantity};
