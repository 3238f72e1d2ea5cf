//! Positions that a mark of an encoder or an input captures (guide, "Homing"; `INTCAP`, `MSEEK`, `HSINT`).

use acrc_catalog::law;
use acrc_motion::axis::{Capture, CaptureMode, CaptureSource, MarkerSeek, SeekStep};
use acrc_motion::{Move, MoveSettings, Target};
use acrc_vm::Value;

use crate::coordination::Condition;
use crate::machine::Machine;
use crate::registers::map::Form;

/// What captures the position of an axis.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct CaptureState {
    capture: Capture,
    /// The encoder whose position is captured.
    encoder: u8,
}

/// A move that looks for the marks of encoders (`MSEEK`).
#[derive(Debug)]
pub(crate) struct Seek {
    /// Its axes and their slots. They become zero at their marks.
    axes: Vec<(u8, usize, MarkerSeek)>,
    /// With which they go back to them.
    settings: MoveSettings,
}

impl Seek {
    pub(crate) fn new(axes: impl Iterator<Item = (u8, usize)>, settings: MoveSettings) -> Self {
        Self { axes: axes.map(|(axis, slot)| (axis, slot, MarkerSeek::new())).collect(), settings }
    }
}

/// What ends the move of a search early: the capture of an axis.
pub(crate) fn sought(axis: u8) -> Condition {
    Condition { flag: law::CAPTURE_COMPLETE.at(u32::from(axis)), state: true }
}

impl Machine {
    /// Waits for the edge that a mode means; until then the capture of the axis is not complete.
    pub(crate) fn arm_capture(&mut self, axis: u8, mode: u8, encoder: u8) {
        self.flags.set_law(law::CAPTURE_COMPLETE, u32::from(axis), false);
        let Some(edge) = CaptureMode::from_number(mode) else {
            self.notes.insert(format!(
                "capture mode {mode} of axis {axis}: what it waits for is not known; nothing is captured"
            ));
            return;
        };
        let scripted = self.world().driven_inputs().contains(&law::CAPTURE_COMPLETE.at(u32::from(axis)));
        if !scripted && !self.can_see(edge.source, encoder) {
            let source = match edge.source {
                CaptureSource::FirstMarker | CaptureSource::SecondMarker => "marker",
                CaptureSource::FirstExternal | CaptureSource::SecondExternal => "capture input",
            };
            self.notes.insert(format!(
                "capture mode {mode} of axis {axis}: the world gives axis {encoder} no {source} for it, so nothing is captured"
            ));
        }
        let state = &mut self.axes[usize::from(axis)].capture;
        state.encoder = encoder;
        state.capture.arm(edge);
    }

    /// Whether the world has a signal.
    fn can_see(&self, source: CaptureSource, encoder: u8) -> bool {
        let world = self.mechanics.of(encoder).map(|mechanism| &mechanism.world);
        world.is_some_and(|world| match source {
            CaptureSource::FirstMarker => world.marker.is_some(),
            CaptureSource::SecondMarker => false,
            CaptureSource::FirstExternal => !world.capture_inputs.is_empty(),
            CaptureSource::SecondExternal => world.capture_inputs.len() > 1,
        })
    }

    /// An edge was seen with an encoder at a position, pulses.
    pub(super) fn see_edge(&mut self, encoder: u8, edge: CaptureMode, position: f64) {
        for axis in 0..self.model.axes {
            let state = &mut self.axes[usize::from(axis)];
            if state.capture.encoder != encoder || !state.capture.capture.see(edge, position / state.pulses_per_unit) {
                continue;
            }
            let register = law::HARDWARE_CAPTURE.at(u32::from(axis));
            if !self.registers.set(register, Form::Long, &Value::Double(position.round())) {
                self.notes.insert(format!("a position of axis {axis} was captured that its register cannot hold"));
            }
            self.flags.set_law(law::CAPTURE_COMPLETE, u32::from(axis), true);
            self.motion.wake();
        }
    }

    /// An input has changed: it may be one that captures.
    pub(super) fn see_input(&mut self, input: u32, rising: bool) {
        if !self.mechanics.captures {
            return;
        }
        for axis in 0..self.model.axes {
            let inputs = self.mechanics.of(axis).map(|mechanism| &mechanism.world.capture_inputs);
            let place = inputs.and_then(|inputs| inputs.iter().position(|wired| *wired == input));
            let source = match place {
                Some(0) => CaptureSource::FirstExternal,
                Some(_) => CaptureSource::SecondExternal,
                None => continue,
            };
            let state = &self.axes[usize::from(axis)];
            let position = self.registers_of(axis).actual * state.pulses_per_unit;
            self.see_edge(axis, CaptureMode { source, rising }, position);
        }
    }

    /// Whether a master looks for marks: other moves wait until it has found them.
    pub(crate) fn seeks(&self, master: usize) -> bool {
        self.masters[master].ahead.seek.is_some()
    }

    /// Whether a master has come to the end of all that it was told, searches included.
    pub(crate) fn stands(&self, master: usize) -> bool {
        !self.moves(master) && !self.seeks(master)
    }

    /// Whether every axis of a search has its mark.
    pub(crate) fn has_sought(&self, master: usize) -> bool {
        let captured = |axis: u8| self.axes[usize::from(axis)].capture.capture.captured().is_some();
        let seek = self.masters[master].ahead.seek.as_ref();
        seek.is_some_and(|seek| seek.axes.iter().all(|(axis, ..)| captured(*axis)))
    }

    /// Lets the searches go on whose moves have ended: back to the marks, which then become zero.
    pub(crate) fn end_seeks(&mut self) {
        if !self.mechanics.seeks {
            return;
        }
        for master in 0..self.masters.len() {
            if !self.masters[master].profiler.in_motion()
                && let Some(seek) = self.masters[master].ahead.seek.take()
            {
                self.end_seek(master, seek);
            }
        }
        self.mechanics.seeks = self.masters.iter().any(|master| master.ahead.seek.is_some());
    }

    /// A master begins to look for marks.
    pub(crate) fn begin_seek(&mut self, master: usize, seek: Seek) {
        self.masters[master].ahead.seek = Some(seek);
        self.mechanics.seeks = true;
    }

    fn end_seek(&mut self, master: usize, mut seek: Seek) {
        let mut back = Move::new(seek.settings);
        for (axis, slot, search) in &mut seek.axes {
            match search.update(&mut self.axes[usize::from(*axis)].capture.capture, false) {
                SeekStep::ReturnTo(position) => back.targets[*slot] = Some(Target::Absolute(position)),
                SeekStep::ZeroAt(position) => self.zero_at(*axis, position),
                SeekStep::Missed => {
                    self.notes.insert(format!("MSEEK met no marker on the way of axis {axis}"));
                }
                SeekStep::Wait | SeekStep::StopMove => {}
            }
        }
        if back.targets.iter().all(Option::is_none) {
            return;
        }
        if let Err(error) = self.masters[master].profiler.push(&back) {
            self.notes.insert(format!("MSEEK of master {master} does not return to its marker: {error}"));
        }
        self.masters[master].ahead.seek = Some(seek);
        self.begin_moves(master);
    }

    fn zero_at(&mut self, axis: u8, position: f64) {
        let before = self.registers_of(axis);
        if let Err(error) = self.set_registers(axis, &before, &before.zeroed_at(position)) {
            self.notes.insert(format!("MSEEK of axis {axis}: {error}"));
        }
    }
}
