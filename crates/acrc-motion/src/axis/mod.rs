//! One axis: its own profilers, its registers and what limits it (the guide's chapters "Making Motion" and "Servo Loop
//! Fundamentals").
//!
//! # A tick
//!
//! A controller goes through these steps in every servo period, for each axis:
//!
//! 1. [`KillProtocol::update`] with the kill flags as programs and people have left them; an axis that stops does so by
//!    [`AxisProfilers::stop`], with the velocity that its master gives it, before the master's moves are dropped.
//! 2. The masters advance, then [`AxisProfilers::advance`] with what the sources did since the last tick.
//! 3. [`AxisProfilers::registers`] sums up the setpoints; a [`GantryLock`] replaces the primary one.
//! 4. [`servo`](crate::servo): the loop and the machine, which yield the next actual position.
//! 5. [`Capture::see`] for edges that were passed, [`TravelLimits::update`], [`Bands::flags`], and [`Homing::update`] with
//!    [`TravelLimits::homing_inputs`].
//!
//! # Units
//!
//! Positions and offsets are programming units of the axis (u); a controller that shows them in pulses multiplies by PPU.
//! Sources are counted in their own pulses.

mod backlash;
mod bands;
mod cam;
mod capture;
mod gear;
mod hand_wheel;
mod homing;
mod jog;
mod kill;
mod limits;
mod profilers;
mod registers;
mod side;
mod window;

pub use backlash::{Backlash, BacklashRule};
pub use bands::{BandFlags, Bands};
pub use cam::{Cam, CamError, CamPoints, CamReport, CamSegment, CamSettings};
pub use capture::{Capture, CaptureMode, CaptureSource, MarkerSeek, SeekStep};
pub use gear::{Gear, GearSettings, GearState};
pub use hand_wheel::HandWheel;
pub use homing::{HomeInputs, Homing, HomingOptions, HomingStatus};
pub use jog::{AxisState, Jog, JogError, JogFlags, JogReport, JogSettings};
pub use kill::{Groups, KillActions, KillFlags, KillProtocol, NumberSet, Refusal, members};
pub use limits::{LimitFlags, LimitKind, LimitSettings, LimitStop, Sides, TravelLimits, limit_inputs};
pub use profilers::{AxisProfilers, SourceCounts};
pub use registers::{GantryLock, Registers};
pub use side::Side;
pub use window::Window;
