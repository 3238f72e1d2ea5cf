//! The cam profiler of one axis (the guide's "Cam Profiler"; CAM DIM, SEG, SRC, FLZ, SCALE, OFFSET, SHIFT, CYCLE, ON, OFF,
//! RES, CLEAR), and ballscrew compensation (BSC), which has the same commands.
//!
//! A source walks through a table of points; between points the output is interpolated linearly. At the end the table
//! begins anew. If its last point differs from its first, the table is incremental: each pass adds the difference to the
//! cam shift, so the output goes on without a jump; backwards it takes the difference off again. The cam offset is
//! `point · SCALE + OFFSET + SHIFT`. A cam adds to the primary setpoint, a ballscrew to the secondary one.
//!
//! Nothing is compiled: points, scale and offsets act in the tick in which they change.
//!
//! What the guide leaves open, and how it is read here, stands in `docs/fidelity.md`, "Gear, cam and sources".

mod table;

pub use table::{CamError, CamPoints, CamSegment};

use table::Table;

use crate::value::{InvalidValue, Quantity, finite};

/// The settings of a cam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CamSettings {
    /// Factor on the points (CAM SCALE).
    pub scale: f64,
    /// Added to the output, u (CAM OFFSET).
    pub offset: f64,
    /// Added to the source, counts (CAM FLZ).
    pub source_offset: f64,
    /// Passes until the cam goes off; zero: it does not (CAM CYCLE).
    pub cycles: u32,
}

impl Default for CamSettings {
    /// The points as they are, for ever.
    fn default() -> Self {
        Self { scale: 1.0, offset: 0.0, source_offset: 0.0, cycles: 0 }
    }
}

impl CamSettings {
    fn validate(&self) -> Result<(), InvalidValue> {
        finite(Quantity::CamScale, self.scale)?;
        finite(Quantity::Position, self.offset)?;
        finite(Quantity::Position, self.source_offset)?;
        Ok(())
    }
}

/// What happened in a tick of a cam.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CamReport {
    /// Passes through the table that were completed; negative when it was left at its beginning.
    pub cycles: i64,
    /// The cam has gone off after the number of passes it was given.
    pub finished: bool,
}

/// The cam or ballscrew profiler of one axis.
#[derive(Clone, Debug, Default)]
pub struct Cam {
    settings: CamSettings,
    table: Table,
    on: bool,
    /// Source counts while on.
    counts: f64,
    /// Passes through the table that the counts stand for, the source offset included.
    turns: i64,
    /// Passes since the cam went on.
    cycles: i64,
    shift: f64,
    /// What CAM RES has moved to the coordinated position.
    preload: f64,
    output: f64,
    velocity: f64,
}

impl Cam {
    /// The settings in force.
    pub fn settings(&self) -> &CamSettings {
        &self.settings
    }

    /// Changes the settings; they act from the next tick on.
    pub fn set_settings(&mut self, settings: CamSettings) -> Result<(), InvalidValue> {
        settings.validate()?;
        self.settings = settings;
        Ok(())
    }

    /// Takes place for a number of segments and forgets those there were (CAM DIM); zero gives the place back (CAM CLEAR).
    /// The cam is off then, and at the beginning of its table.
    pub fn dim(&mut self, segments: usize) {
        self.table = Table::with_segments(segments);
        self.halt();
        self.counts = 0.0;
        self.turns = 0;
    }

    /// Defines a segment (CAM SEG).
    pub fn set_segment(&mut self, index: usize, segment: CamSegment) -> Result<(), CamError> {
        self.table.set(index, segment)
    }

    /// Lets the axis follow (CAM ON). Counting of passes begins anew.
    pub fn on(&mut self) {
        self.on = true;
        self.cycles = 0;
    }

    /// The offset stays where it is (CAM OFF, or a kill).
    pub fn halt(&mut self) {
        self.on = false;
        self.velocity = 0.0;
    }

    /// Whether the axis follows.
    pub fn is_on(&self) -> bool {
        self.on
    }

    /// Makes the offset `offset`, u, and clears the shift (CAM RES).
    pub fn preload(&mut self, offset: f64) -> Result<(), InvalidValue> {
        finite(Quantity::Position, offset)?;
        self.preload += offset - (self.output - self.shift);
        self.shift = 0.0;
        self.output = offset;
        Ok(())
    }

    /// Sets the shift, u (CAM SHIFT).
    pub fn set_shift(&mut self, shift: f64) -> Result<(), InvalidValue> {
        self.shift = finite(Quantity::Position, shift)?;
        Ok(())
    }

    /// Lets a tick of `dt` seconds pass in which the source changed by `counts`.
    pub fn advance(&mut self, counts: f64, dt: f64, points: &impl CamPoints) -> CamReport {
        let length = self.table.length();
        if !self.on || length == 0.0 || !counts.is_finite() {
            return CamReport::default();
        }
        self.counts += counts;
        let report = self.turn(length, points);
        let place = self.counts + self.settings.source_offset - self.turns as f64 * length;
        let value = self.table.value(place, points);
        let output = value * self.settings.scale + self.settings.offset + self.shift + self.preload;
        self.velocity = if dt > 0.0 && self.on { (output - self.output) / dt } else { 0.0 };
        self.output = output;
        report
    }

    /// Brings the number of passes in line with the counts.
    fn turn(&mut self, length: f64, points: &impl CamPoints) -> CamReport {
        let passes = floor((self.counts + self.settings.source_offset) / length) - self.turns;
        if passes == 0 {
            return CamReport::default();
        }
        let limit = i64::from(self.settings.cycles);
        let finished = limit > 0 && (self.cycles + passes).abs() >= limit;
        let passes = if finished { passes.signum() * limit - self.cycles } else { passes };
        self.turns += passes;
        self.cycles += passes;
        self.shift += passes as f64 * self.table.rise(points) * self.settings.scale;
        if finished {
            self.on = false;
            self.counts = self.turns as f64 * length - self.settings.source_offset;
        }
        CamReport { cycles: passes, finished }
    }

    /// Passes completed since the cam went on.
    pub fn cycles(&self) -> i64 {
        self.cycles
    }

    /// The shift that passes through the table have built up, u.
    pub fn shift(&self) -> f64 {
        self.shift
    }

    /// The cam offset, u.
    pub fn offset(&self) -> f64 {
        self.output
    }

    /// Velocity of the offset in the last tick, u/s.
    pub fn velocity(&self) -> f64 {
        self.velocity
    }
}

/// The greatest whole number that is not above `x`.
fn floor(x: f64) -> i64 {
    let whole = x as i64;
    if x < whole as f64 { whole - 1 } else { whole }
}
