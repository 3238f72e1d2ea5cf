//! Position capture and the search for an encoder marker (INTCAP, MSEEK).
//!
//! What the guide leaves open, and how it is read here, stands in `docs/fidelity.md`, "Jog, homing, limits and kills".

/// A signal that can capture a position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CaptureSource {
    /// Marker of the first encoder.
    FirstMarker,
    /// Marker of the second encoder.
    SecondMarker,
    /// First external input.
    FirstExternal,
    /// Second external input.
    SecondExternal,
}

/// An edge of a signal that captures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CaptureMode {
    /// The signal.
    pub source: CaptureSource,
    /// Its rising edge; otherwise the falling one.
    pub rising: bool,
}

impl CaptureMode {
    /// The mode of a number as INTCAP and MSEEK have it; `None` for one whose meaning is not known.
    pub fn from_number(number: u8) -> Option<Self> {
        let source = match number % 4 {
            0 => CaptureSource::FirstMarker,
            1 => CaptureSource::SecondMarker,
            2 => CaptureSource::FirstExternal,
            _ => CaptureSource::SecondExternal,
        };
        (number < 8).then_some(Self { source, rising: number < 4 })
    }
}

/// The capture register of an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Capture {
    armed: Option<CaptureMode>,
    captured: Option<f64>,
}

impl Capture {
    /// Waits for the next edge; the register is not complete until then.
    pub fn arm(&mut self, mode: CaptureMode) {
        *self = Self { armed: Some(mode), captured: None };
    }

    /// Waits no longer.
    pub fn disarm(&mut self) {
        self.armed = None;
    }

    /// Takes notice of an edge at a position, in the unit of the register. True if it was captured.
    pub fn see(&mut self, edge: CaptureMode, position: f64) -> bool {
        if self.armed != Some(edge) {
            return false;
        }
        *self = Self { armed: None, captured: Some(position) };
        true
    }

    /// The captured position (P12292 of axis 0), once the capture is complete (flag 777).
    pub fn captured(&self) -> Option<f64> {
        self.captured
    }
}

/// What a search for the marker asks of its caller.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SeekStep {
    /// Nothing yet.
    Wait,
    /// The marker was found: let the move ramp down.
    StopMove,
    /// The move has ended behind the marker: go back to this position.
    ReturnTo(f64),
    /// The axis stands: make this position zero.
    ZeroAt(f64),
    /// The move has ended without the marker.
    Missed,
}

/// A search for the encoder marker (MSEEK): an incremental move with the capture armed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MarkerSeek {
    stopping: bool,
    returning: bool,
    over: bool,
}

impl MarkerSeek {
    /// A search whose move has just been queued and whose capture was armed.
    pub fn new() -> Self {
        Self::default()
    }

    /// Whether it has come to its end.
    pub fn is_over(&self) -> bool {
        self.over
    }

    /// Looks at the capture and at whether the move still goes on, once a tick.
    pub fn update(&mut self, capture: &mut Capture, in_motion: bool) -> SeekStep {
        if self.over {
            return SeekStep::Wait;
        }
        match (capture.captured(), in_motion) {
            (Some(_), true) if self.stopping || self.returning => SeekStep::Wait,
            (Some(_), true) => {
                self.stopping = true;
                SeekStep::StopMove
            }
            (Some(position), false) if !self.returning => {
                self.returning = true;
                SeekStep::ReturnTo(position)
            }
            (Some(position), false) => {
                self.over = true;
                SeekStep::ZeroAt(position)
            }
            (None, true) => SeekStep::Wait,
            (None, false) => {
                self.over = true;
                capture.disarm();
                SeekStep::Missed
            }
        }
    }
}
