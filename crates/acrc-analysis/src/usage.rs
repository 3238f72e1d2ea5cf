//! What the programs of a project use by number: which axes and masters appear in commands, which programs have code,
//! which user flags somebody sets. Checks that judge one file by all others ask this, and it holds answers only, so that
//! an edit that changes none of them costs nothing.

use acrc_catalog::{BitKind, ObjectKind, OperandClass, Space, command, law};
use acrc_syntax::units::Level;

use crate::index::{AliasTarget, AttachmentKind, Effects, Exports, On, WriteKind, Written};
use crate::symbols::Symbols;

/// The wizard has limits for this many axes.
const AXES: u32 = 16;

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
    /// User flags that some code sets, sorted.
    pub set_flags: Vec<u32>,
    /// Some code sets a flag whose number is computed, so that it may be any.
    pub sets_any_flag: bool,
}

impl Usage {
    /// Puts together what the files do.
    pub(crate) fn new<'a>(files: impl Iterator<Item = (&'a Exports, &'a Effects)>, symbols: &Symbols) -> Self {
        let mut usage = Self::default();
        let mut limits = Vec::new();
        for (exports, effects) in files {
            usage.add_objects(exports, effects);
            for write in &effects.writes {
                let Some((class, number)) = written(&write.what, symbols) else { continue };
                usage.add_write(write.how, class, number);
                if let Some(number) = number.filter(|number| write.level == Level::System && is_wizards(class, *number))
                {
                    usage.wizard |= class == OperandClass::Bit;
                    limits.push(number);
                }
            }
        }
        usage.wizard |= has_both_limits(&limits);
        for list in [&mut usage.axes, &mut usage.masters, &mut usage.set_flags] {
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
            if let AttachmentKind::Axis { axis: Some(axis) } = attachment.kind {
                self.axes.push(axis);
            }
        }
        for command in &effects.commands {
            match command.on {
                On::Object(ObjectKind::Axis, Some(axis)) => self.axes.push(axis),
                On::Object(ObjectKind::Master, Some(master)) => self.masters.push(master),
                _ => {}
            }
            // Which flag a rung puts out is not among the writes.
            self.sets_any_flag |= [command::OUT, command::OUT_NOT].contains(&command.command);
        }
    }

    fn add_write(&mut self, how: WriteKind, class: OperandClass, number: Option<u32>) {
        let Some(number) = number else {
            self.sets_any_flag |= matches!(class, OperandClass::Bit | OperandClass::Parameter);
            return;
        };
        match class {
            OperandClass::Bit if how != WriteKind::Clear && acrc_catalog::bit(number).kind == Some(BitKind::User) => {
                self.set_flags.push(number);
            }
            // A whole word of flags is written at once.
            OperandClass::Parameter => {
                self.sets_any_flag |= acrc_catalog::parameter(number).object == Space::Flags;
            }
            _ => {}
        }
    }
}

/// Whether the parameters hold the positive and the negative travel limit of some axis.
fn has_both_limits(parameters: &[u32]) -> bool {
    let (positive, negative) = (law::WIZARD_SOFT_EOT_POS, law::WIZARD_SOFT_EOT_NEG);
    (0..AXES).any(|axis| [positive, negative].iter().all(|limit| parameters.contains(&limit.at(axis))))
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

/// What a write reaches: its class, and its number unless that is computed.
fn written(what: &Written, symbols: &Symbols) -> Option<(OperandClass, Option<u32>)> {
    let small = |number: u64| u32::try_from(number).ok();
    match what {
        Written::Operand(class, number) => Some((*class, Some(small(*number)?))),
        Written::Computed(class) => Some((*class, None)),
        Written::Alias(name) => match symbols.alias(name)?.operand.target {
            AliasTarget::Operand(class, number) => Some((class, number.and_then(small))),
            _ => None,
        },
    }
}
