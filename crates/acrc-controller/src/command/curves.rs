//! Curves from points: `SPLINE`, `NURB` and `K` (guide, command list; the binary move packet names points, knots and weights).
//!
//! Between `MODE` and `END` a line gives a point of the curve, with `K` in front its knot as well. Each piece is queued as a
//! move when the point behind it is known, so the program runs ahead of a curve as it does of other moves.

use acrc_catalog::{CommandId, command};
use acrc_image::AxisName;
use acrc_motion::{ControlPoint, CurveBuilder, CurveError, Move, PushError, Span, Target};
use acrc_vm::{Arg, ArgValue, Call, Outcome};

use super::arguments::{real, scalar};
use super::moves::refused;
use super::{Action, Context, Entry};
use crate::error::ControllerError;
use crate::machine::Machine;
use crate::master::{Master, SLOTS};

pub(super) const COMMANDS: &[Entry] = &[
    (command::SPLINE_MODE, Action::Run(begin)),
    (command::SPLINE_END, Action::Run(end)),
    (command::NURB_MODE, Action::Run(begin)),
    (command::NURB_RANK, Action::Run(rank)),
    (command::NURB_END, Action::Run(end)),
    (command::K, Action::Run(knot)),
];

/// Rank of a NURBS curve without `NURB RANK`: cubic pieces.
pub(crate) const CUBIC: usize = 4;

/// The knot that ends a curve.
pub(crate) const LAST_KNOT: f64 = -1.0;

/// A curve whose points a program is giving.
#[derive(Debug)]
pub(crate) struct Curve {
    nurbs: bool,
    /// Made with the first point, when the rank is known.
    builder: Option<Box<CurveBuilder>>,
    /// A piece that has found no room yet.
    piece: Option<Box<Span>>,
    /// The point before, u.
    point: [f64; SLOTS],
}

impl Curve {
    /// Whether it is a NURBS curve.
    pub(crate) fn is_nurbs(&self) -> bool {
        self.nurbs
    }

    /// The point before in a slot, u.
    pub(crate) fn point(&self, slot: usize) -> f64 {
        self.point.get(slot).copied().unwrap_or(0.0)
    }
}

impl Master {
    /// Begins a curve where the moves given so far end.
    pub(crate) fn begin_curve(&mut self, nurbs: bool) {
        let point = std::array::from_fn(|slot| self.profiler.programmed_target(slot));
        self.ahead.curve = Some(Box::new(Curve { nurbs, builder: None, piece: None, point }));
    }
}

/// A line of a curve.
#[derive(Default)]
pub(crate) struct Line {
    pub(crate) knot: Option<f64>,
    pub(crate) point: ControlPoint,
    /// It gives any axis a value.
    pub(crate) has_point: bool,
}

/// `SPLINE MODE`, `NURB MODE`: what follows are points. The mode says what the lines hold, which they show themselves.
fn begin(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    scalar(call)?;
    let master = usize::from(context.machine.master_of(context.program(call)?)?);
    let master = &mut context.machine.masters[master];
    if master.ahead.curve.is_some() {
        return Err(open(call.command));
    }
    master.begin_curve(call.command == command::NURB_MODE);
    Ok(Outcome::Done)
}

/// `NURB RANK 4`: before the first point.
fn rank(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    let master = usize::from(context.machine.master_of(context.program(call)?)?);
    let master = &mut context.machine.masters[master];
    let Some(value) = scalar(call)? else {
        return Err(ControllerError::Expected { command, expected: "a rank" });
    };
    if master.ahead.curve.as_ref().is_some_and(|curve| curve.builder.is_some()) {
        let problem = "the curve has points already: the rank comes before them".to_owned();
        return Err(ControllerError::BadValue { command, problem });
    }
    let rank = value as usize;
    CurveBuilder::nurbs(rank).map_err(wrong)?;
    master.rank = rank;
    Ok(Outcome::Done)
}

/// `K 0.5 X1 Y2 W1`
fn knot(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    let master = context.movable(call)?;
    let Some((Arg::Value(knot, _), point)) = call.arguments.split_first() else {
        return Err(ControllerError::Expected { command, expected: "a knot and the axes of a point" });
    };
    let knot = real(command, knot)?;
    if knot == LAST_KNOT && point.is_empty() {
        return context.end_curve(call, master);
    }
    context.line(call, master, Some(knot), point)
}

/// `SPLINE END`, `NURB END`: what is left of the curve becomes moves.
fn end(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let master = context.movable(call)?;
    context.end_curve(call, master)
}

impl Context<'_> {
    /// A statement of moves while a curve is open: a point of it.
    pub(super) fn point(&mut self, call: &Call, master: usize) -> Result<Outcome, ControllerError> {
        if !matches!(call.command, command::AXIS_MOVE | command::MOV) {
            return Err(open(call.command));
        }
        self.line(call, master, None, call.arguments)
    }

    /// A line of a curve: its point, with the knot in front of it.
    pub(super) fn line(
        &mut self,
        call: &Call,
        master: usize,
        knot: Option<f64>,
        point: &[Arg],
    ) -> Result<Outcome, ControllerError> {
        if self.machine.masters[master].ahead.curve.is_none() {
            let problem = "no curve is open: SPLINE MODE or NURB MODE comes first".to_owned();
            return Err(ControllerError::BadValue { command: call.command.info().name, problem });
        }
        if !self.machine.deliver_piece(call.command, master)? {
            return Ok(Outcome::Again);
        }
        let line = self.read_line(call, master, knot, point)?;
        self.machine.add_line(call.command, master, &line)?;
        Ok(Outcome::Done)
    }

    /// Queues what is left of a curve, piece by piece.
    fn end_curve(&mut self, call: &Call, master: usize) -> Result<Outcome, ControllerError> {
        let ended = self.machine.end_curve(call.command, master)?;
        Ok(if ended { Outcome::Done } else { Outcome::Again })
    }

    fn read_line(
        &self,
        call: &Call,
        master: usize,
        knot: Option<f64>,
        arguments: &[Arg],
    ) -> Result<Line, ControllerError> {
        let program = self.program(call)?;
        let mut line = Line { knot, ..Line::default() };
        for argument in arguments {
            if let Arg::Axis { name, slash: false, value: ArgValue::Value(weight) } = argument
                && knot.is_some()
                && is_weight(*name)
            {
                line.point.weight = Some(real(call.command.info().name, weight)?);
                continue;
            }
            let (slot, target) = self.straight_target(call.command, program, argument)?;
            let before = self.machine.masters[master].ahead.curve.as_ref().map_or(0.0, |curve| curve.point(slot));
            line.point.position[slot] = Some(match target {
                Target::Relative(distance) => before + distance,
                Target::Absolute(position) => position,
                Target::Sine(sine) => sine.target,
            });
            line.has_point = true;
        }
        Ok(line)
    }
}

impl Machine {
    /// Gives a line to the curve, and queues the piece that it completes. Where that finds no room, the next line waits.
    pub(crate) fn add_line(&mut self, kind: CommandId, master: usize, line: &Line) -> Result<(), ControllerError> {
        if self.extend_curve(master, line)? {
            let note = "a curve does not begin where the axes are, so they jump to its first point";
            self.notes.insert(format!("master {master}: {note}"));
        }
        self.deliver_piece(kind, master)?;
        Ok(())
    }

    /// Gives a line to the curve. True when the curve begins where the axes are not.
    fn extend_curve(&mut self, master: usize, line: &Line) -> Result<bool, ControllerError> {
        let state = &mut self.masters[master];
        let rank = state.rank;
        let Some(curve) = &mut state.ahead.curve else { return Ok(false) };
        let before = curve.point;
        let elsewhere = (0..SLOTS).any(|slot| line.point.position[slot].is_some_and(|point| point != before[slot]));
        let begins = curve.builder.is_none();
        if begins {
            let builder = if curve.nurbs { CurveBuilder::nurbs(rank).map_err(wrong)? } else { CurveBuilder::spline() };
            curve.builder = Some(Box::new(builder));
        }
        let Some(builder) = &mut curve.builder else { return Ok(false) };
        // A spline without knots begins where the axes are, whether the program says so or not.
        let implied = begins && elsewhere && !curve.nurbs && line.knot.is_none();
        if implied {
            let mut first = ControlPoint::new();
            for slot in (0..SLOTS).filter(|slot| line.point.position[*slot].is_some()) {
                first.position[slot] = Some(before[slot]);
            }
            builder.push(None, Some(&first)).map_err(wrong)?;
        }
        let piece = builder.push(line.knot, line.has_point.then_some(&line.point)).map_err(wrong)?;
        for (place, position) in curve.point.iter_mut().zip(line.point.position) {
            *place = position.unwrap_or(*place);
        }
        curve.piece = piece.map(Box::new);
        Ok(begins && elsewhere && !implied)
    }

    /// Queues what is left of a curve, piece by piece. False when there is no room for one.
    pub(crate) fn end_curve(&mut self, kind: CommandId, master: usize) -> Result<bool, ControllerError> {
        loop {
            if !self.deliver_piece(kind, master)? {
                return Ok(false);
            }
            let Some(curve) = &mut self.masters[master].ahead.curve else { return Ok(true) };
            match curve.builder.as_mut().and_then(|builder| builder.finish()) {
                Some(piece) => curve.piece = Some(Box::new(piece)),
                None => {
                    self.masters[master].ahead.curve = None;
                    return Ok(true);
                }
            }
        }
    }

    /// Queues the piece that waits, if one does. False when there is no room for it.
    pub(crate) fn deliver_piece(&mut self, kind: CommandId, master: usize) -> Result<bool, ControllerError> {
        let Some(curve) = &mut self.masters[master].ahead.curve else { return Ok(true) };
        let Some(piece) = curve.piece.take() else { return Ok(true) };
        self.prepare_master(master)?;
        let state = &mut self.masters[master];
        let next = state.gated(&Move::new(state.move_settings()));
        match state.profiler.push_span(&next, &piece) {
            Ok(()) => {
                state.ahead.gate = None;
                self.begin_moves(master);
                Ok(true)
            }
            Err(PushError::Full | PushError::Stopping | PushError::OpenEnd) => {
                if let Some(curve) = &mut state.ahead.curve {
                    curve.piece = Some(piece);
                }
                Ok(false)
            }
            Err(error) => Err(refused(kind, error)),
        }
    }
}

/// Behind a knot W is the weight of the point.
fn is_weight(name: AxisName) -> bool {
    name.to_string() == "W"
}

/// What is not possible between the points of a curve.
pub(super) fn open(command: CommandId) -> ControllerError {
    let problem = "a curve is open: its END comes first".to_owned();
    ControllerError::BadValue { command: command.info().name, problem }
}

fn wrong(error: CurveError) -> ControllerError {
    ControllerError::Move(error.to_string())
}
