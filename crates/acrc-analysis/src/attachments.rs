//! The attachments of a project, played through in the order in which they are made (guide, "Master/Slave
//! Attachments"): what they contradict.

use acrc_syntax::units::Level;

use crate::index::{Attachment, AttachmentKind, Exports, Name, Sequence};

/// An attachment that the controller refuses because of what stands, or does not stand, before it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Conflict {
    /// The file, by its place in the project.
    pub file: u32,
    /// The attachment, by its place in [`Exports::attachments`].
    pub attachment: u32,
    /// The level of the earlier attachment that is in the way; of this one when one is missing.
    pub level: Level,
    /// What is wrong.
    pub what: Contradiction,
}

/// What is wrong with an attachment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Contradiction {
    /// Something of an earlier slave is taken.
    Slave {
        /// What both want.
        taken: Taken,
        /// The slot of the earlier one.
        slot: u32,
        /// Its axis.
        axis: u32,
    },
    /// A slave is attached, and the program has no master yet.
    NoMaster,
    /// Another program has the master.
    MasterElsewhere {
        /// The master.
        master: u32,
    },
    /// The program has another master.
    SecondMaster {
        /// The master that it has.
        first: u32,
    },
}

/// What two attachments both want.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Taken {
    /// The slot of the master.
    Slot,
    /// The axis; it may be attached once in the whole system.
    Axis,
    /// The axis name; it may be given once in a program.
    Name,
}

/// A slave that stands.
struct Slave<'a> {
    level: Level,
    slot: u32,
    axis: u32,
    name: Option<&'a Name>,
}

/// A master that stands.
struct Master {
    level: Level,
    /// Its number; `None` when it is not written, or when it is not certain that the master stands.
    number: Option<u32>,
}

#[derive(Default)]
struct Standing<'a> {
    slaves: Vec<Slave<'a>>,
    masters: Vec<Master>,
}

/// Plays the attachments through in the order in which they happen. Conditional ones contradict nothing: whether they
/// happen is not known.
pub(crate) fn conflicts<'a>(files: impl Iterator<Item = &'a Exports> + Clone) -> Vec<Conflict> {
    let masters = MasterSites::new(files.clone());
    let mut conflicts = Vec::new();
    let mut typed = Standing::default();
    for (file, exports) in (0..).zip(files) {
        let mut stored = Standing::default();
        let mut current = Sequence::Immediate;
        for (place, attachment) in (0..).zip(&exports.attachments) {
            if attachment.sequence != current {
                stored = Standing::default();
                current = attachment.sequence;
            }
            let standing = if current == Sequence::Immediate { &mut typed } else { &mut stored };
            let level = attachment.level;
            let found = if standing.lacks_master(attachment) && !masters.may_come_first(file, attachment) {
                // One finding a program is enough.
                standing.masters.push(Master { level, number: None });
                Some((Contradiction::NoMaster, level))
            } else {
                standing.play(attachment)
            };
            conflicts.extend(found.map(|(what, level)| Conflict { file, attachment: place, level, what }));
        }
    }
    conflicts
}

/// Where masters are attached.
struct MasterSites {
    /// The level, the file, and whether in stored text.
    sites: Vec<(Level, u32, bool)>,
    /// The project says what its axes are, or frees what is attached: its masters are not those of its controller.
    is_setup: bool,
}

impl MasterSites {
    fn new<'a>(files: impl Iterator<Item = &'a Exports> + Clone) -> Self {
        let sets_up = |change: &Attachment| match change.kind {
            AttachmentKind::Axis { .. } => true,
            AttachmentKind::DetachAll => change.sequence == Sequence::Immediate,
            _ => false,
        };
        let is_setup = files.clone().any(|exports| exports.attachments.iter().any(sets_up));
        let sites = (0..).zip(files).flat_map(|(file, exports)| {
            let masters = exports.attachments.iter().filter(|a| matches!(a.kind, AttachmentKind::Master { .. }));
            masters.map(move |a| (a.level, file, a.sequence != Sequence::Immediate))
        });
        Self { sites: sites.collect(), is_setup }
    }

    /// Whether a master that was not met yet may still be attached before this slave: the order of files, and of stored
    /// programs, is not certain. A project that attaches no master at all may find them on its controller.
    fn may_come_first(&self, file: u32, slave: &Attachment) -> bool {
        let typed_here = slave.sequence == Sequence::Immediate;
        let counts = |site: &(Level, u32, bool)| site.0 == slave.level && !(typed_here && site.1 == file && !site.2);
        (self.sites.is_empty() && !self.is_setup) || self.sites.iter().any(counts)
    }
}

impl<'a> Standing<'a> {
    fn lacks_master(&self, attachment: &Attachment) -> bool {
        matches!(attachment.kind, AttachmentKind::Slave { .. })
            && matches!(attachment.level, Level::Program(_))
            && !self.masters.iter().any(|master| master.level == attachment.level)
    }

    /// Applies one change; returns what it contradicts, with the level of that.
    fn play(&mut self, change: &'a Attachment) -> Option<(Contradiction, Level)> {
        match &change.kind {
            AttachmentKind::DetachAll => self.detach(change, |_| true, true),
            AttachmentKind::Detach { slot, axis } => {
                let whole = slot.is_none() && axis.is_none();
                let goes =
                    |slave: &Slave| slot.is_none_or(|slot| slot == slave.slot) && axis.is_none_or(|a| a == slave.axis);
                self.detach(change, |slave| slave.level == change.level && goes(slave), whole);
            }
            AttachmentKind::Master { master } => return self.attach_master(change, *master),
            AttachmentKind::Slave { .. } if change.conditional => {}
            AttachmentKind::Slave { slot: Some(slot), axis: Some(axis), name } => {
                let slave = Slave { level: change.level, slot: *slot, axis: *axis, name: name.as_ref() };
                return self.attach_slave(slave);
            }
            AttachmentKind::Slave { .. } | AttachmentKind::Axis { .. } => {}
        }
        None
    }

    /// A conditional DETACH may have freed what is attached next, and may not have.
    fn detach(&mut self, change: &Attachment, goes: impl Fn(&Slave) -> bool, masters: bool) {
        self.slaves.retain(|slave| !goes(slave));
        let concerned =
            |master: &Master| masters && (change.kind == AttachmentKind::DetachAll || master.level == change.level);
        if change.conditional {
            self.masters.iter_mut().filter(|master| concerned(master)).for_each(|master| master.number = None);
        } else {
            self.masters.retain(|master| !concerned(master));
        }
    }

    fn attach_master(&mut self, change: &Attachment, master: Option<u32>) -> Option<(Contradiction, Level)> {
        let level = change.level;
        if !change.conditional
            && let Some(master) = master
        {
            let own = self.masters.iter().find(|other| other.level == level).and_then(|other| other.number);
            if let Some(first) = own {
                return (first != master).then_some((Contradiction::SecondMaster { first }, level));
            }
            if let Some(other) = self.masters.iter().find(|other| other.number == Some(master)) {
                return Some((Contradiction::MasterElsewhere { master }, other.level));
            }
        }
        self.masters.push(Master { level, number: master.filter(|_| !change.conditional) });
        None
    }

    fn attach_slave(&mut self, slave: Slave<'a>) -> Option<(Contradiction, Level)> {
        let same_program = |other: &&Slave| other.level == slave.level;
        let find = |wanted: &dyn Fn(&&Slave) -> bool| self.slaves.iter().find(wanted);
        let earlier = [
            (Taken::Slot, find(&|other| same_program(other) && other.slot == slave.slot)),
            (Taken::Axis, find(&|other| other.axis == slave.axis)),
            (Taken::Name, find(&|other| same_program(other) && slave.name.is_some() && other.name == slave.name)),
        ];
        let first = earlier.into_iter().find_map(|(taken, other)| other.map(|other| (taken, other)));
        if let Some((taken, other)) = first {
            return Some((Contradiction::Slave { taken, slot: other.slot, axis: other.axis }, other.level));
        }
        self.slaves.push(slave);
        None
    }
}
