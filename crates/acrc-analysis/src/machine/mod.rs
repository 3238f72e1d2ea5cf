//! The machine that a project makes of its controller: which axes and masters its programs attach, and what is done to
//! them somewhere, put together from the effects of all files. It holds answers, not how they came about, so that an
//! edit that changes none of them costs nothing.
//!
//! What is done is collected for projects that show how their controller is set up; of others nothing follows from what
//! they do nowhere.
//!
//! An answer is "never" only when nothing can do it: an axis that is addressed by a computed number, or a flag whose
//! number is computed, may be any.

mod axes;
mod build;

use acrc_syntax::units::Level;

pub use axes::AxisSet;

use crate::Deed;

/// What the setup and the programs of a project make of the controller.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Machine {
    /// Masters with the programs that attach them, sorted.
    pub masters: Vec<(u32, Level)>,
    /// Axes with the programs that attach them to their masters, sorted.
    pub axes: Vec<(u32, Level)>,
    /// Some attachment does not say its number, so that there may be more.
    pub open: bool,
    /// The project shows how its controller is set up: it attaches masters and axes, and says what an axis is. What
    /// such a project does nowhere is probably done nowhere.
    pub complete: bool,
    /// The first file whose programs name axes, in a project that attaches nothing at all.
    pub unattached: Option<u32>,
    /// The programs whose text the project holds, sorted.
    pub programs: Vec<Level>,
    /// Axes whose output is steps.
    pub steppers: AxisSet,
    /// Axes whose output is of another kind, by ATTACH AXIS.
    pub servos: AxisSet,
    /// By deed: the axes to which it is done.
    axis_deeds: [AxisSet; Deed::COUNT],
    /// Deeds that are done to a master or a program, with its level, sorted.
    level_deeds: Vec<(Deed, Level)>,
    /// By deed: it may be done to any master or program.
    open_levels: [bool; Deed::COUNT],
    /// Motion in stored text by axis and program, with the first file that has it, sorted.
    first: Vec<(Deed, u32, Level, u32)>,
    /// Axes whose drives stored text enables, with the programs, sorted. No axis where its number is not known.
    enabled: Vec<(Option<u32>, Level)>,
    /// Coordinated moves in stored text by level, with the first file that has them, sorted.
    first_moves: Vec<(Level, u32)>,
}

impl Machine {
    /// Whether some program attaches this axis to its master.
    pub fn has_axis(&self, axis: u32) -> bool {
        self.axes.iter().any(|(attached, _)| *attached == axis)
    }

    /// Whether some program attaches this master.
    pub fn has_master(&self, master: u32) -> bool {
        self.masters.iter().any(|(attached, _)| *attached == master)
    }

    /// The axes to which something is done.
    pub fn axes_with(&self, deed: Deed) -> AxisSet {
        self.axis_deeds.get(deed as usize).copied().unwrap_or_default()
    }

    /// Whether something is never done to an axis.
    pub fn never(&self, deed: Deed, axis: u32) -> bool {
        !self.axes_with(deed).may_have(axis)
    }

    /// Whether something is done to the master of a program, or to a program.
    pub fn does_at(&self, deed: Deed, level: Level) -> bool {
        self.level_deeds.binary_search(&(deed, level)).is_ok()
    }

    /// Whether something is never done to the master of a program, or to a program.
    pub fn never_at(&self, deed: Deed, level: Level) -> bool {
        !self.open_levels.get(deed as usize).is_some_and(|open| *open) && !self.does_at(deed, level)
    }

    /// The first file of the project whose stored text does one of `deeds`, which are motion, to an axis.
    pub fn first_file_with(&self, deeds: &[Deed], axis: u32) -> Option<u32> {
        let of_axis = self.first.iter().filter(|(deed, of, ..)| *of == axis && deeds.contains(deed));
        of_axis.map(|(.., file)| *file).min()
    }

    /// The programs whose stored text enables, or may enable, the drive of an axis, which clears its kill too (guide, "Kill
    /// All Motion Request").
    pub fn programs_enabling(&self, axis: u32) -> impl Iterator<Item = Level> {
        self.enabled.iter().filter(move |(of, _)| of.is_none_or(|of| of == axis)).map(|(_, level)| *level)
    }

    /// The axes that stored text sets in motion, each with the first file of the project where it does, more than once
    /// where it does so in several ways.
    pub fn moved(&self) -> impl Iterator<Item = (u32, u32)> {
        self.first.iter().map(|(_, axis, _, file)| (*axis, *file))
    }

    /// The programs whose stored text sets an axis in motion, each with the first file of the project where it does, in
    /// the order of the files.
    pub fn programs_moving(&self, axis: u32) -> Vec<(Level, u32)> {
        let mut moving: Vec<(u32, Level)> =
            self.first.iter().filter(|(_, of, ..)| *of == axis).map(|(_, _, level, file)| (*file, *level)).collect();
        moving.sort_unstable();
        let mut programs: Vec<(Level, u32)> = Vec::new();
        for (file, level) in moving {
            if !programs.iter().any(|(other, _)| *other == level) {
                programs.push((level, file));
            }
        }
        programs
    }

    /// The first file of the project whose stored text has coordinated moves of the program of a level.
    pub fn first_file_moving(&self, level: Level) -> Option<u32> {
        self.first_moves.iter().find(|(of, _)| *of == level).map(|(_, file)| *file)
    }
}
