//! The machine that a project makes of its controller: which axes and masters its programs attach, put together from
//! the effects of all files. It holds answers, not how they came about, so that an edit that changes none of them costs
//! nothing.

use acrc_syntax::units::Level;

use crate::index::{AttachmentKind, Exports};

/// What the setup and the programs of a project make of the controller.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Machine {
    /// Masters with the programs that attach them, sorted.
    pub masters: Vec<(u32, Level)>,
    /// Axes with the programs that attach them to their masters, sorted.
    pub axes: Vec<(u32, Level)>,
    /// Some attachment does not say its number, so that there may be more.
    pub open: bool,
}

impl Machine {
    /// Puts together what the files do.
    pub(crate) fn new<'a>(files: impl Iterator<Item = &'a Exports>) -> Self {
        let mut machine = Self::default();
        for attachment in files.flat_map(|exports| &exports.attachments) {
            match &attachment.kind {
                AttachmentKind::Master { master } => match master {
                    Some(master) => machine.masters.push((*master, attachment.level)),
                    None => machine.open = true,
                },
                AttachmentKind::Slave { axis, .. } => match axis {
                    Some(axis) => machine.axes.push((*axis, attachment.level)),
                    None => machine.open = true,
                },
                AttachmentKind::Axis { .. } | AttachmentKind::Detach { .. } | AttachmentKind::DetachAll => {}
            }
        }
        for list in [&mut machine.masters, &mut machine.axes] {
            list.sort_unstable();
            list.dedup();
        }
        machine
    }

    /// Whether some program attaches this axis to its master.
    pub fn has_axis(&self, axis: u32) -> bool {
        self.axes.iter().any(|(attached, _)| *attached == axis)
    }

    /// Whether some program attaches this master.
    pub fn has_master(&self, master: u32) -> bool {
        self.masters.iter().any(|(attached, _)| *attached == master)
    }
}
