//! What the programs of a project use by number: which axes and masters appear in commands, which programs have code,
//! which user flags somebody sets. Checks that judge one file by all others ask this, and it holds answers only, so that
//! an edit that changes none of them costs nothing.

use acrc_catalog::{BitKind, ObjectKind, OperandClass, Space, law};
use acrc_syntax::units::Level;

use crate::index::{AliasTarget, AttachmentKind, Effects, Exports, WriteKind};
use crate::symbols::Symbols;

/// What the files of a project use by number.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Usage {
    /// Axes that are configured (`ATTACH AXISn`) or commanded (`AXISn ...`), sorted.
    pub axes: Vec<u32>,
    /// Masters that commands name (`MASTERn`), sorted.
    pub masters: Vec<u32>,
    /// Programs whose stored text does something, sorted.
    pub programs: Vec<Level>,
    /// The setup writes parameters or flags as code of the vendor's wizard does: a flag that it keeps for itself, or both
    /// travel limits of an axis.
    pub wizard: bool,
    /// A program that the wizard may fill ([`is_wizards_program`]) writes both travel limits of an axis, as its code does.
    pub wizard_program: bool,
}

/// The user flags that some code of a project sets.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct SetFlags {
    /// Sorted.
    flags: Vec<u32>,
    /// Some code sets a flag whose number is computed, or a whole word of flags.
    any: bool,
}

impl SetFlags {
    /// Puts together what the files do.
    pub(crate) fn new<'a>(files: impl Iterator<Item = &'a Effects>, symbols: &Symbols) -> Self {
        let mut set = Self::default();
        for effects in files {
            set.any |= effects.computed_user_flags;
            for write in &effects.user {
                set.add(write.how, write.class, write.number);
            }
            for (name, how) in &effects.aliases {
                let alias = symbols.alias(name);
                let Some(AliasTarget::Operand(class, number)) = alias.map(|alias| alias.operand.target) else {
                    continue;
                };
                match number.map(u32::try_from) {
                    Some(Ok(number)) => set.add(*how, class, number),
                    Some(Err(_)) => {}
                    None => set.any |= class == OperandClass::Bit,
                }
            }
        }
        set.flags.sort_unstable();
        set.flags.dedup();
        set
    }

    fn add(&mut self, how: WriteKind, class: OperandClass, number: u32) {
        if how != WriteKind::Clear && is_user_flag(class, number) {
            self.flags.push(number);
        }
        self.any |= class == OperandClass::Parameter && acrc_catalog::parameter(number).object == Space::Flags;
    }

    /// Whether some code may set the flag.
    pub(crate) fn may_set(&self, flag: u32) -> bool {
        self.any || self.flags.binary_search(&flag).is_ok()
    }
}

impl Usage {
    /// Puts together what the files do.
    pub(crate) fn new<'a>(files: impl Iterator<Item = (&'a Exports, &'a Effects)>) -> Self {
        let mut usage = Self::default();
        let (mut limits, mut program_limits) = (Vec::new(), Vec::new());
        for (exports, effects) in files {
            usage.add_objects(exports, effects);
            for write in &effects.user {
                if !is_wizards(write.class, write.number) {
                    continue;
                }
                if write.system {
                    usage.wizard |= write.class == OperandClass::Bit;
                    limits.push(write.number);
                } else if write.wizards && write.class == OperandClass::Parameter {
                    program_limits.push(write.number);
                }
            }
        }
        usage.wizard |= has_both_limits(&limits);
        usage.wizard_program = has_both_limits(&program_limits);
        for list in [&mut usage.axes, &mut usage.masters] {
            list.sort_unstable();
            list.dedup();
        }
        usage.programs.sort_unstable();
        usage.programs.dedup();
        usage
    }

    fn add_objects(&mut self, exports: &Exports, effects: &Effects) {
        self.programs.extend_from_slice(&exports.stored);
        for attachment in &exports.attachments {
            if let AttachmentKind::Axis { axis: Some(axis), .. } = attachment.kind {
                self.axes.push(axis);
            }
        }
        for (kind, index) in &effects.objects {
            match kind {
                ObjectKind::Axis => self.axes.push(*index),
                _ => self.masters.push(*index),
            }
        }
    }
}

/// Whether it is a flag that means what a program makes of it.
pub(crate) fn is_user_flag(class: OperandClass, number: u32) -> bool {
    class == OperandClass::Bit && acrc_catalog::bit(number).kind == Some(BitKind::User)
}

/// Whether the parameters hold the positive and the negative travel limit of some axis.
fn has_both_limits(parameters: &[u32]) -> bool {
    let (positive, negative) = (law::WIZARD_SOFT_EOT_POS, law::WIZARD_SOFT_EOT_NEG);
    (0..positive.count()).any(|axis| [positive, negative].iter().all(|limit| parameters.contains(&limit.at(axis))))
}

/// Whether the wizard of firmware up to 1.18.14 saves code for limits and drive faults as this program (guide, "Resources
/// Reserved for Generated Code").
pub fn is_wizards_program(level: Level) -> bool {
    matches!(level, Level::Program(7) | Level::Plc(5..=7))
}

/// Whether a parameter or flag is one that code of the vendor's wizard uses (guide, "Resources Reserved for Generated
/// Code").
pub fn is_wizards(class: OperandClass, number: u32) -> bool {
    let (object, field) = match class {
        OperandClass::Parameter => {
            let info = acrc_catalog::parameter(number);
            (info.object, info.field)
        }
        OperandClass::Bit => {
            let info = acrc_catalog::bit(number);
            (info.object, info.field)
        }
        _ => return false,
    };
    object == Space::User && field.starts_with("wizard_")
}
