//! What statements outside of programs do that matters to a download.

use acrc_analysis::deed::{Deed, acts};
use acrc_catalog::memory::{Stream, SystemBlock};
use acrc_catalog::{CommandId, Keyword, ObjectKind, command};
use acrc_image::{Image, Node, UnitName};
use acrc_syntax::ast::{Argument, Command, Dim, Expr, ExprKind, Statement, StatementKind};
use acrc_syntax::units::Level;

use super::problem::{Problem, codes};
use super::script::{Place, unit_at};

/// A statement that a download may have to leave out or to move.
#[derive(Clone, Debug, PartialEq)]
pub enum Special {
    /// `NEW ALL`
    EraseAll,
    /// `NEW`, `NEW PROG1`
    Erase(Vec<UnitName>),
    /// `CLEAR` at the system prompt.
    Clear,
    /// `DIM` at the system prompt; `None` for a size that is no constant.
    Dim(Option<(SystemBlock, u64)>),
    /// `PASSWORD`
    Protect,
    /// `ECHO`, `MODE`: they are about the channel of whoever types them.
    Channel,
}

/// What immediate statements of one line do, as far as a download has to know.
#[derive(Clone, Debug, Default, PartialEq)]
#[expect(clippy::struct_excessive_bools, reason = "independent yes-or-no facts")]
pub struct Traits {
    /// It stands alone on its line, and is one of these.
    pub special: Option<Special>,
    /// Something may be answered without anything being wrong.
    pub speaks: bool,
    /// It may take its time.
    pub waits: bool,
    /// `DETACH ALL`, or `DETACH` of the program at the prompt.
    pub detaches: Option<Detached>,
    /// Attaches a master or slave to the program at the prompt.
    pub attaches: bool,
    /// Gives variables to the program at the prompt.
    pub dims_locals: bool,
    /// Frees the variables of the program at the prompt.
    pub clears_locals: bool,
    /// What moves, enables or starts something at once.
    pub acts: Vec<Deed>,
}

/// What a `DETACH` frees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Detached {
    /// All programs.
    All,
    /// The program at the prompt.
    Program,
}

/// Commands that never give the prompt back, or end the connection.
const ENDLESS: &[(CommandId, &str, &str)] = &[
    (command::LRUN, "shows the output of a program and gives the prompt back only at ESC", "use RUN"),
    (command::LISTEN, "shows the output of a program and gives the prompt back only at ESC", "leave it out"),
    (command::TALK_TO, "connects the terminal to another stream until ESC", "leave it out"),
    (command::REBOOT, "restarts the controller in the middle of the download", "leave it out and use --save"),
    (command::FLASH_LOAD, "puts the image in flash memory in the place of what is being sent", "leave it out"),
];

/// Commands that wait or write to slow memory.
const SLOW: &[CommandId] = &[
    command::DWL,
    command::INH,
    command::IHPOS,
    command::ESAVE,
    command::ELOAD,
    command::ERASE,
    command::FLASH_SAVE,
    command::FLASH_IMAGE,
    command::FLASH_RES,
    command::FLASH_ERASE,
];

/// Commands that answer whatever stands behind them.
const SPEAKING: &[CommandId] =
    &[command::LIST, command::HELP, command::VER, command::CPU, command::DIAG, command::PROM];

impl Special {
    /// What a statement typed at `level` is, if it is one of these.
    pub fn of(statement: &Statement, level: Level) -> Option<Self> {
        let command = match &statement.kind {
            StatementKind::Dim(dim) if level == Level::System && !dim.sizes.is_empty() => {
                return Some(Self::Dim(system_dimension(dim)));
            }
            StatementKind::Command(command) => command,
            _ => return None,
        };
        match command.id {
            command::NEW => Some(erased(command, level)),
            command::CLEAR if level == Level::System => Some(Self::Clear),
            command::PASSWORD => Some(Self::Protect),
            command::ECHO | command::MODE => Some(Self::Channel),
            _ => None,
        }
    }
}

/// The programs that a `NEW` erases.
fn erased(new: &Command, level: Level) -> Special {
    let mut units = Vec::new();
    for argument in &new.arguments {
        match argument {
            Argument::Word(word) if word.keyword == Keyword::All => return Special::EraseAll,
            Argument::Object(object) => {
                let index = object.index.and_then(|index| u8::try_from(index).ok());
                units.extend(index.map(|index| match object.kind {
                    ObjectKind::Plc => UnitName::Plc(index),
                    _ => UnitName::Program(index),
                }));
            }
            _ => {}
        }
    }
    if new.arguments.is_empty() {
        units.extend(unit_at(level));
    }
    Special::Erase(units)
}

/// The block and size of a `DIM` of system memory, when they are constants.
pub(super) fn system_dimension(dim: &Dim) -> Option<(SystemBlock, u64)> {
    let mut numbers = dim.index.iter().chain(&dim.sizes).map(constant);
    let (first, second) = (numbers.next()??, numbers.next());
    let indexed = |block: fn(u8) -> SystemBlock| Some((block(u8::try_from(first).ok()?), second??));
    let alone = |block: SystemBlock| second.is_none().then_some((block, first));
    match dim.id {
        command::DIM_PROG => indexed(SystemBlock::Program),
        command::DIM_PLC => indexed(SystemBlock::Plc),
        command::DIM_STREAM => indexed(|number| SystemBlock::Stream(Stream::Numbered(number))),
        command::DIM_P => alone(SystemBlock::Parameters),
        command::DIM_DEF => alone(SystemBlock::Aliases),
        command::DIM_COM1 => alone(SystemBlock::Stream(Stream::Com(1))),
        command::DIM_COM2 => alone(SystemBlock::Stream(Stream::Com(2))),
        command::DIM_FIFO => alone(SystemBlock::Stream(Stream::Fifo)),
        command::DIM_DPCB => alone(SystemBlock::Stream(Stream::Dpcb)),
        _ => None,
    }
}

fn constant(expr: &Expr) -> Option<u64> {
    match &expr.kind {
        ExprKind::Integer(number) => Some(*number),
        ExprKind::Real(number) if number.fract() == 0.0 && *number >= 0.0 => Some(*number as u64),
        ExprKind::Paren(inner) => constant(inner),
        _ => None,
    }
}

impl Traits {
    /// Of the statements of one line, typed at `level`.
    pub fn of(text: &str, statements: &[Statement], level: Level, image: &Image) -> Self {
        let mut traits = Self::default();
        if let [only] = statements {
            traits.special = Special::of(only, level);
        }
        for statement in statements {
            traits.add(text, statement, level, image);
        }
        traits
    }

    fn add(&mut self, text: &str, statement: &Statement, level: Level, image: &Image) {
        match &statement.kind {
            StatementKind::Print(_) | StatementKind::Input(_) => {
                self.speaks = true;
                self.waits |= matches!(statement.kind, StatementKind::Input(_));
            }
            StatementKind::Dim(dim) => {
                self.speaks |= dim.sizes.is_empty();
                self.dims_locals |= level != Level::System && !dim.sizes.is_empty();
            }
            StatementKind::Command(command) => self.command(text, command, level, image),
            _ => {}
        }
    }

    fn command(&mut self, text: &str, command: &Command, level: Level, image: &Image) {
        let info = command.id.info();
        let asks = command.arguments.iter().all(|argument| match argument {
            Argument::Axis(axis) => axis.value.is_none(),
            Argument::Object(object) => object.value.is_none(),
            _ => false,
        });
        self.speaks |= !info.report.is_empty() && asks || SPEAKING.contains(&command.id);
        self.waits |= SLOW.contains(&command.id);
        match command.id {
            command::DETACH_ALL => self.detaches = Some(Detached::All),
            command::DETACH if command.arguments.is_empty() => self.detaches = Some(Detached::Program),
            command::DETACH if command.arguments.iter().any(is_all) => self.detaches = Some(Detached::All),
            command::ATTACH_MASTER | command::ATTACH_SLAVE => self.attaches = true,
            command::CLEAR => self.clears_locals |= level != Level::System,
            _ => {}
        }
        let at_once = |deed: &Deed| deed.is_motion() || matches!(deed, Deed::DriveOn | Deed::Run);
        self.acts.extend(acts(command).map(|act| act.deed).filter(at_once));
        self.acts.extend(flag_set(text, command, image));
    }
}

fn is_all(argument: &Argument) -> bool {
    matches!(argument, Argument::Word(word) if word.keyword == Keyword::All)
}

/// What setting a flag by number or alias does at once.
fn flag_set(text: &str, command: &Command, image: &Image) -> Option<Deed> {
    let (command::SET, Some(Argument::Bit(bit))) = (command.id, command.arguments.first()) else { return None };
    let number = constant(&bit.index).or_else(|| {
        let name = text.get(bit.index.span.range())?;
        let alias = image.aliases.iter().find(|alias| alias.name == name)?;
        match &alias.target {
            Node::Scalar { index, .. } => match **index {
                Node::Long(number) => u64::try_from(number).ok(),
                _ => None,
            },
            _ => None,
        }
    })?;
    match acrc_catalog::bit(u32::try_from(number).ok()?).field {
        "drive_enable" | "wizard_drive_enable" => Some(Deed::DriveOn),
        "run_request" => Some(Deed::Run),
        "jog_forward" | "jog_reverse" => Some(Deed::Jog),
        "jog_home_request" => Some(Deed::Home),
        _ => None,
    }
}

/// Why a statement cannot be a part of a download.
pub(super) fn unsendable(place: Place, statement: &Statement) -> Option<Problem> {
    let StatementKind::Command(command) = &statement.kind else { return None };
    let (id, what, help) = ENDLESS.iter().find(|(id, ..)| *id == command.id)?;
    let place = Place { span: statement.span, ..place };
    let message = format!("{} cannot be sent: it {what}", id.info().name);
    Some(Problem::new(codes::NOT_SENDABLE, place, message, "not sent").with_help(*help))
}

/// A block that begins on a line and does not end there: what is typed is executed line by line.
pub(super) fn open_block(place: Place, statements: &[Statement]) -> Option<Problem> {
    let mut open: Vec<&Statement> = Vec::new();
    for statement in statements {
        match &statement.kind {
            StatementKind::If(condition) if condition.then.is_none() => open.push(statement),
            StatementKind::For(_) => open.push(statement),
            StatementKind::Command(command) => match command.id {
                command::WHILE => open.push(statement),
                command::ENDIF | command::NEXT | command::WEND => _ = open.pop(),
                _ => {}
            },
            _ => {}
        }
    }
    let place = Place { span: open.first()?.span, ..place };
    let message = "a block over several lines cannot be typed: each line is executed by itself";
    let help = "write it on one line, or into a program";
    Some(Problem::new(codes::NOT_SENDABLE, place, message, "does not end on this line").with_help(help))
}

/// The prompt behind a statement.
pub(super) fn level_behind(level: Level, statement: &Statement) -> Level {
    let StatementKind::Command(command) = &statement.kind else { return level };
    let number = || match command.arguments.first() {
        Some(Argument::Value(value)) => constant(value).and_then(|number| u8::try_from(number).ok()),
        _ => None,
    };
    match command.id {
        command::SYS => Level::System,
        command::PROG => number().map_or(level, Level::Program),
        command::PLC => number().map_or(level, Level::Plc),
        _ => level,
    }
}
