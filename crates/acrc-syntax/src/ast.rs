//! The tree of one source text.
//!
//! `AcroBASIC` is a language of lines (guide, "Programming Basics"): the tree is a flat list of lines, each a range of a flat list of statements.
//! Blocks (`IF` .. `ENDIF`) are matched afterwards by [`crate::blocks`], because a program with an unbalanced block is still a list of lines.
//!
//! Nodes hold spans into the source instead of copies. Every byte that belongs to no node (blanks, separators, line breaks, text that could not be
//! read) lies between the spans of its neighbours, so that printing the tree gives back the text that was read.

use acrc_catalog::{CommandId, FunctionId, Keyword, ObjectKind, OperandClass, Operator, UnaryOperator};
use acrc_diagnostics::Span;

/// One physical line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    /// The text of the line without its line break.
    pub span: Span,
    /// The number at its start (`15 VEL 1000`), which stores the line at that place of the program.
    pub number: Option<LineNumber>,
    /// Range of its statements in [`crate::Tree::statements`].
    pub statements: std::ops::Range<u32>,
    /// An apostrophe comment, which the download drops.
    pub comment: Option<Span>,
}

/// A line number written in the source.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LineNumber {
    /// The number; one that 32 bits do not hold is the largest that they do.
    pub value: u32,
    /// Where it stands.
    pub span: Span,
}

impl LineNumber {
    /// The highest number that a line can be stored with: the stored form has 32 bits with a sign.
    pub const MAX: u32 = i32::MAX as u32;
}

/// One statement.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// From its first to its last character; a remark reaches to the end of the line.
    pub span: Span,
    /// How it is set off from the statement before it.
    pub separator: Separator,
    /// What it is.
    pub kind: StatementKind,
}

/// What stands between a statement and the one before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Separator {
    /// It is the first of its line.
    Line,
    /// A colon.
    Colon,
    /// Blanks, or nothing at all: `ACC10 DEC10`.
    Blank,
    /// The `THEN` of a one-line `IF`.
    Then,
}

/// The kinds of statements. A command of the catalogue without a variant of its own is a [`Command`].
#[derive(Clone, Debug, PartialEq)]
pub enum StatementKind {
    /// `REM text`; the span is the text behind the word.
    Remark(Span),
    /// `_name`
    Label(Label),
    /// `target = value`
    Assign(Box<Assign>),
    /// `IF (condition)` and `IF (condition) THEN`. With `THEN` the rest of the line's statements are conditional.
    If(Box<If>),
    /// `FOR variable = start TO end STEP step`
    For(Box<For>),
    /// `PRINT` and `?`
    Print(Box<Print>),
    /// `INPUT`
    Input(Box<Input>),
    /// `DIM` in all its forms
    Dim(Box<Dim>),
    /// `#DEFINE name operand`
    Define(Box<Define>),
    /// Every other command, axis moves included ([`acrc_catalog::command::AXIS_MOVE`] when no keyword is written).
    Command(Box<Command>),
    /// Text that is no statement; exactly one diagnostic says why.
    Error,
}

/// The definition of a label.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Label {
    /// The name without the underscore.
    pub name: Span,
    /// Blanks stand between the underscore and the name, as one listing of the guide has it.
    pub detached: bool,
}

/// An assignment.
#[derive(Clone, Debug, PartialEq)]
pub struct Assign {
    /// An operand or an alias.
    pub target: Expr,
    /// The value.
    pub value: Expr,
}

/// `IF`
#[derive(Clone, Debug, PartialEq)]
pub struct If {
    /// The condition, normally a [`ExprKind::Paren`].
    pub condition: Expr,
    /// The word `THEN` of the one-line form.
    pub then: Option<Span>,
}

/// `FOR`
#[derive(Clone, Debug, PartialEq)]
pub struct For {
    /// The counter.
    pub variable: Expr,
    /// First value.
    pub start: Expr,
    /// Last value.
    pub end: Expr,
    /// The increment; 1 when absent.
    pub step: Option<Expr>,
}

/// `PRINT`
#[derive(Clone, Debug, PartialEq)]
pub struct Print {
    /// Written as `?`.
    pub shorthand: bool,
    /// `#device`
    pub device: Option<Expr>,
    /// `USING "picture"`
    pub using: Option<Expr>,
    /// What is printed.
    pub items: Vec<PrintItem>,
}

/// One item of a `PRINT` and the separator behind it.
#[derive(Clone, Debug, PartialEq)]
pub struct PrintItem {
    /// The value.
    pub value: Expr,
    /// Comma or semicolon behind it. `None` only for the last item of a line that ends with a line break in the output.
    pub separator: Option<PrintSeparator>,
}

/// Comma or semicolon.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PrintSeparator {
    /// Moves to the next column.
    Comma,
    /// Joins without blanks.
    Semicolon,
}

/// `INPUT`
#[derive(Clone, Debug, PartialEq)]
pub struct Input {
    /// `INPUT;` keeps the cursor on the line.
    pub stay: bool,
    /// `#device`
    pub device: Option<Expr>,
    /// The prompt and its separator.
    pub prompt: Option<(Expr, PrintSeparator)>,
    /// Where the values go.
    pub variables: Vec<Expr>,
}

/// `DIM`
#[derive(Clone, Debug, PartialEq)]
pub struct Dim {
    /// The daughter: [`acrc_catalog::command::DIM_LV`], ..., or plain [`acrc_catalog::command::DIM`], which reports.
    pub id: CommandId,
    /// The words `DIM LV`, index not included.
    pub name: Span,
    /// The number behind the word: `DIM PROG0`, `DIM LA0`, `DIM STREAM2`.
    pub index: Option<Expr>,
    /// Count, or count and length.
    pub sizes: Vec<Expr>,
    /// The sizes stand in parentheses. Without them the statement is accepted with a warning (`DIM LV10`).
    pub parenthesised: bool,
}

/// `#DEFINE`
#[derive(Clone, Debug, PartialEq)]
pub struct Define {
    /// The alias.
    pub name: Span,
    /// What it stands for.
    pub operand: Expr,
}

/// A command of the catalogue with its arguments.
#[derive(Clone, Debug, PartialEq)]
pub struct Command {
    /// Object prefix: `AXIS0` of `AXIS0 PPU 4000`. Few commands have one.
    pub prefix: Option<Box<Object>>,
    /// The row of the catalogue.
    pub id: CommandId,
    /// All words of the name (`JOG HOME`); empty at the first argument for an axis move without a keyword.
    pub name: Span,
    /// The arguments in the order of the source.
    pub arguments: Vec<Argument>,
}

/// One argument of a command.
#[derive(Clone, Debug, PartialEq)]
pub enum Argument {
    /// `5`, `-5`, `(P0+1)`, `"text"`, `P0` (not in parentheses: accepted, the checker may say so)
    Value(Expr),
    /// `(24, 0)`
    Tuple(Tuple),
    /// `X`, `X5`, `X/25`, `Y(3,-1)`, and the source of `GEAR SRC X ENC2`
    Axis(Axis),
    /// `ENC0`, `PROG1`, `AXIS3`, `AXIS3 5`, `STREAM2`
    Object(Object),
    /// The flag of `SET 34`, `CLR BIT8467`, `INH -516`, `SET Alias`
    Bit(BitArgument),
    /// `ALL`, `NONE`, `CLOCK`, ...
    Word(Word),
    /// `SINE` between the axes of one move statement
    Interpolation(CommandId, Span),
    /// Label or line number
    Target(Target),
    /// `#1`
    Device(Expr),
}

/// Values in parentheses, two or more.
#[derive(Clone, Debug, PartialEq)]
pub struct Tuple {
    /// With the parentheses.
    pub span: Span,
    /// The values.
    pub values: Vec<Expr>,
}

/// An axis name, or what stands in its place, with its value.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Name and value.
    pub span: Span,
    /// The name.
    pub name: Span,
    /// The slash of an incremental target.
    pub slash: Option<Span>,
    /// [`Argument::Value`], [`Argument::Tuple`], [`Argument::Object`] or [`Argument::Word`].
    pub value: Option<Box<Argument>>,
}

/// An object by number.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// Word, number and value.
    pub span: Span,
    /// Word and number.
    pub name: Span,
    /// Its kind.
    pub kind: ObjectKind,
    /// Its number. `None` when none is written.
    pub index: Option<u32>,
    /// The slash of an incremental value.
    pub slash: Option<Span>,
    /// The value behind it: `RES AXIS0 5`. As in [`Axis::value`].
    pub value: Option<Box<Argument>>,
}

/// A flag as an argument.
#[derive(Clone, Debug, PartialEq)]
pub struct BitArgument {
    /// With sign and word.
    pub span: Span,
    /// The sign: true for minus.
    pub negative: bool,
    /// The word `BIT` is written.
    pub keyword: bool,
    /// The number, a parenthesised expression, or an alias.
    pub index: Expr,
}

/// A word that is only part of a statement, with the number that may be glued to it (`STEPPER4`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Word {
    /// The word and its number.
    pub span: Span,
    /// The word.
    pub keyword: Keyword,
    /// The number.
    pub index: Option<u32>,
}

/// Where `GOTO` and `GOSUB` go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// A label; the span is its name as written, which has no underscore.
    Label(Span),
    /// A line number.
    Line(u32, Span),
}

impl Target {
    /// Where it stands.
    pub fn span(self) -> Span {
        match self {
            Self::Label(span) | Self::Line(_, span) => span,
        }
    }
}

/// An expression.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    /// Where it stands.
    pub span: Span,
    /// What it is.
    pub kind: ExprKind,
}

/// Kinds of expressions (guide, "Parametric Evaluation").
#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind {
    /// Digits without point or exponent. Saturates at `u64::MAX`; the checker reports what does not fit.
    Integer(u64),
    /// A number with a point or an exponent.
    Real(f64),
    /// The text between the quotes.
    String(Span),
    /// `P0`, `P(12288+256)`, `LV0`, `$V0`, `BIT 24`, `BIT(516)`, `LA0(1)`
    Operand(Box<Operand>),
    /// A name: an alias, unless the program declares otherwise.
    Alias,
    /// `(inner)`
    Paren(Box<Expr>),
    /// A sign or `NOT`
    Unary(UnaryOperator, Box<Expr>),
    /// Two operands and an operator with its place
    Binary(Operator, Span, Box<[Expr; 2]>),
    /// A function with its arguments
    Call(FunctionId, Vec<Expr>),
    /// Text that could not be read; a diagnostic says why.
    Error,
}

/// A variable, parameter or flag.
#[derive(Clone, Debug, PartialEq)]
pub struct Operand {
    /// Its class.
    pub class: OperandClass,
    /// The number ([`ExprKind::Integer`]) or the parenthesised expression.
    pub index: Expr,
    /// The element of an array, without its parentheses.
    pub element: Option<Expr>,
}
