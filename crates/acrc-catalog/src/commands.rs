//! Commands, their daughters and the forms of statements without a word of their own (guide, "Basic Setup" and the command groups).

use crate::generated::{COMMAND_BY_OPCODE, COMMANDS};
use crate::{Confidence, Levels, ObjectKind, Shape};

/// A row of the command table; its number is the operation code of the stored program (1 to 1023, stable).
///
/// Values come from [`crate::command`], from look-ups, or from [`CommandId::from_opcode`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CommandId(pub u16);

impl CommandId {
    /// The row.
    pub fn info(self) -> &'static Command {
        self.find().expect("a command id is an operation code of the catalogue")
    }

    /// The command of an operation code, if there is one.
    pub fn from_opcode(opcode: u16) -> Option<Self> {
        Self(opcode).find().map(|command| command.id)
    }

    fn find(self) -> Option<&'static Command> {
        let place = COMMAND_BY_OPCODE.get(usize::from(self.0))?;
        COMMANDS.get(usize::from(*place))
    }
}

/// A command.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(clippy::struct_excessive_bools, reason = "independent yes-or-no columns of a table")]
pub struct Command {
    /// Its identifier and operation code.
    pub id: CommandId,
    /// All words of its name: `JOG HOME`.
    pub name: &'static str,
    /// The last word of its name: `HOME`.
    pub word: &'static str,
    /// The command of which it is a daughter: `JOG`.
    pub parent: Option<CommandId>,
    /// The statement that it is a part or another form of: `IF` for `ENDIF`, `PRINT` for `?`.
    pub belongs_to: Option<CommandId>,
    /// It is documented on its own but never a statement: `THEN`.
    pub clause: bool,
    /// The command group of the guide.
    pub group: &'static str,
    /// What it does, in one line.
    pub summary: &'static str,
    /// What else is worth knowing; empty for nothing.
    pub note: &'static str,
    /// Its format in the notation of the guide: `{}` optional, `|` choice, `...` repeated.
    pub signature: &'static str,
    /// Its arguments, each once.
    pub arguments: &'static [Argument],
    /// How the arguments are written.
    pub shape: Shape,
    /// Fewest items of the shape.
    pub min_args: u8,
    /// Most items of the shape; 255 stands for any number.
    pub max_args: u8,
    /// Fewest values of one axis or tuple, where the shape has any; 0 elsewhere.
    pub tuple_min: u8,
    /// Most values of one axis or tuple, where the shape has any; 0 elsewhere.
    pub tuple_max: u8,
    /// An axis may stand without a value: for a report, or for the default.
    pub bare_axis: bool,
    /// It sets a value that stays until it is set again, reports it when the value is left out, and starts nothing.
    pub setting: bool,
    /// Where it is accepted. Behind an object prefix such as `AXIS0` the levels of the prefix apply.
    pub levels: Levels,
    /// What it reports at a prompt when its arguments are left out; empty for nothing.
    pub report: &'static str,
    /// Objects that may stand before it, `AXISn PPU`, or whose number its first word carries, `DACn GAIN`.
    pub prefixes: &'static [ObjectKind],
    /// It takes axis names.
    pub takes_axes: bool,
    /// It means nothing without a daughter.
    pub daughter_required: bool,
    /// Models that have it; empty for all.
    pub models: &'static str,
    /// Where the row comes from (`data/README.md`).
    pub source: &'static str,
    /// How well it is attested.
    pub confidence: Confidence,
    /// Its daughters, in the order of their operation codes.
    pub daughters: &'static [CommandId],
    /// The rows that belong to it.
    pub parts: &'static [CommandId],
}

/// An argument of a command. Empty texts stand for nothing known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Argument {
    /// Its name in the signature.
    pub name: &'static str,
    /// What is written: `FP32`, `long`, `string`, `object`, ...
    pub kind: &'static str,
    /// Its unit; `units` are the programming units set with `PPU`.
    pub unit: &'static str,
    /// Accepted values.
    pub range: &'static str,
    /// Value with factory settings, or when it is left out.
    pub default: &'static str,
    /// The same as a number, where it is one.
    pub default_value: Option<f64>,
    /// Left out, it is the first argument with its sign turned: `EXC X 2` is `EXC X (2, -2)`.
    pub opposite: bool,
}

/// Every command, in the order of the operation codes.
pub fn all_commands() -> impl ExactSizeIterator<Item = &'static Command> {
    COMMANDS.iter()
}
