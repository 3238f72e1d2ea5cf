//! Cam and ballscrew tables: segments whose points are arrays of programs (guide, "Cam Profiler", "Setpoint Compensation").

use acrc_catalog::{CommandId, command};
use acrc_motion::axis::{Cam, CamSegment};

use super::tables::{ArrayPlace, Arrays};
use crate::axis::Axis;
use crate::error::ControllerError;
use crate::machine::Machine;

/// Segments that a table may have.
const MOST_SEGMENTS: usize = 4096;

/// Which of the two profilers with a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TableKind {
    /// `CAM`: adds to the primary setpoint.
    Cam,
    /// `BSC`: adds to the secondary setpoint.
    Ballscrew,
}

/// A stretch of a table.
#[derive(Clone, Copy, Debug)]
pub(super) struct Segment {
    /// Counts of the source.
    length: f64,
    /// Where its points are.
    pub(super) place: ArrayPlace,
    /// How many points the array had when the profiler was told of it.
    points: usize,
}

/// Where the points of a table are.
#[derive(Clone, Debug, Default)]
pub(crate) struct Table {
    pub(super) segments: Vec<Option<Segment>>,
    /// The profiler does not know all of it yet.
    fresh: bool,
}

impl TableKind {
    /// The command that defines a segment.
    fn segment(self) -> CommandId {
        match self {
            Self::Cam => command::CAM_SEG,
            Self::Ballscrew => command::BSC_SEG,
        }
    }

    /// The first word of its commands.
    fn name(self) -> &'static str {
        match self {
            Self::Cam => command::CAM.info().name,
            Self::Ballscrew => command::BSC.info().name,
        }
    }
}

impl Axis {
    /// A profiler with its table.
    pub(super) fn table(&mut self, kind: TableKind) -> (&mut Cam, &mut Table) {
        match kind {
            TableKind::Cam => (&mut self.profilers.cam, &mut self.cam_table),
            TableKind::Ballscrew => (&mut self.profilers.ballscrew, &mut self.ballscrew_table),
        }
    }
}

impl Machine {
    /// Takes place for the segments of a table (`CAM DIM`); none gives it back (`CAM CLEAR`).
    pub(crate) fn dim_table(&mut self, axis: u8, kind: TableKind, segments: usize) -> Result<(), ControllerError> {
        if segments > MOST_SEGMENTS {
            return Err(ControllerError::DimensionRange { limit: MOST_SEGMENTS as i64 });
        }
        let (cam, table) = self.axes[usize::from(axis)].table(kind);
        cam.dim(segments);
        *table = Table { segments: vec![None; segments], fresh: false };
        Ok(())
    }

    /// Defines a segment of a table (`CAM SEG`).
    pub(crate) fn set_segment(
        &mut self,
        axis: u8,
        kind: TableKind,
        (segment, length): (usize, f64),
        place: ArrayPlace,
    ) -> Result<(), ControllerError> {
        let command = kind.segment().info().name;
        if length <= 0.0 {
            let problem = format!("a segment of length {length} holds nothing");
            return Err(ControllerError::BadValue { command, problem });
        }
        let (_, table) = self.axes[usize::from(axis)].table(kind);
        let count = table.segments.len();
        let Some(entry) = table.segments.get_mut(segment) else {
            let problem = format!("segment {segment} is outside the {count} segments of its DIM");
            return Err(ControllerError::BadValue { command, problem });
        };
        *entry = Some(Segment { length, place, points: 0 });
        table.fresh = true;
        self.motion.wake();
        Ok(())
    }

    /// Lets an axis follow its table, or stops that.
    pub(crate) fn switch_table(&mut self, axis: u8, kind: TableKind, on: bool) -> Result<(), ControllerError> {
        self.admit(axis, on)?;
        let followers = self.axes[usize::from(axis)].followers;
        let follower = if kind == TableKind::Cam { followers.cam } else { followers.ballscrew };
        let follower = self.follow(follower.feed);
        let state = &mut self.axes[usize::from(axis)];
        let (cam, _) = state.table(kind);
        if !on {
            cam.halt();
        } else if !cam.is_on() {
            cam.on();
            match kind {
                TableKind::Cam => state.followers.cam = follower,
                TableKind::Ballscrew => state.followers.ballscrew = follower,
            }
        }
        self.motion.wake();
        Ok(())
    }

    /// The shift that passes through a table have built up, units.
    pub(crate) fn table_shift(&mut self, axis: u8, kind: TableKind) -> f64 {
        self.axes[usize::from(axis)].table(kind).0.shift()
    }

    /// Gives the shift another value.
    pub(crate) fn set_table_shift(&mut self, axis: u8, kind: TableKind, shift: f64) -> Result<(), ControllerError> {
        let (cam, _) = self.axes[usize::from(axis)].table(kind);
        cam.set_shift(shift).map_err(|error| ControllerError::Move(error.to_string()))?;
        self.motion.wake();
        Ok(())
    }

    /// Switches a profiler off whose arrays have gone, so that its offset stays.
    pub(super) fn drop_lost_tables(&mut self, axis: u8, arrays: &dyn Arrays) {
        for kind in [TableKind::Cam, TableKind::Ballscrew] {
            let (cam, table) = self.axes[usize::from(axis)].table(kind);
            let lost = |segment: &Segment| arrays.size(segment.place) < segment.points;
            if cam.is_on() && table.segments.iter().flatten().any(lost) {
                cam.halt();
                let name = kind.name();
                self.notes.insert(format!("AXIS{axis}: an array of its {name} has gone; the offset stays"));
            }
        }
    }

    /// Tells the profilers of an axis how many points the arrays of new segments have.
    pub(super) fn resolve_tables(&mut self, axis: u8, arrays: &dyn Arrays) {
        for kind in [TableKind::Cam, TableKind::Ballscrew] {
            let (cam, table) = self.axes[usize::from(axis)].table(kind);
            if !std::mem::take(&mut table.fresh) {
                continue;
            }
            for (index, segment) in table.segments.iter_mut().enumerate() {
                let Some(segment) = segment else { continue };
                segment.points = arrays.size(segment.place);
                let Segment { length, place, points } = *segment;
                if let Err(error) = cam.set_segment(index, CamSegment { length, points }) {
                    let (class, array) = (place.class, place.array);
                    self.notes.insert(format!("AXIS{axis}: segment {index} with {class}{array} is left out: {error}"));
                }
            }
        }
    }
}
