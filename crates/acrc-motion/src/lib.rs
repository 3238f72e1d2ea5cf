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
//! What the documents leave open of coordinated moves, and how it is read here, is in the table "Motion" of
//! `docs/fidelity.md`, one row each. The modules of [`axis`], [`servo`] and [`source`] begin with theirs.
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
