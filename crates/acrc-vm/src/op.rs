//! The register form that a program is decoded to before it runs.
//!
//! An expression becomes instructions with up to three operands, each a slot in a file of its type: 32-bit integers,
//! 64-bit floating point numbers, and values whose type is known only at run time (parameters) or that are strings.
//! Local variables `LV` and `DV` lie in the first two files behind the scratch slots of the running statement.
//!
//! A 32-bit floating point number travels in the file of 64-bit numbers, rounded to 32 bits where the language rounds
//! it. For a sum, difference, product or quotient of two such numbers that gives the same result as computing with
//! 32 bits.

use acrc_catalog::OperandClass;

use crate::functions::{Math, TextFunction};
use crate::locals::DimBlock;

/// A place in a file.
pub(crate) type Slot = u16;

/// Scratch slots at the start of each file. An expression of the deepest nesting that an image may hold fits.
pub(crate) const SCRATCH: usize = 512;

/// Which of less, equal and greater make a relation true, as three bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Relation(u8);

impl Relation {
    pub(crate) const LESS: Self = Self(0b001);
    pub(crate) const EQUAL: Self = Self(0b010);
    pub(crate) const LESS_OR_EQUAL: Self = Self(0b011);
    pub(crate) const GREATER: Self = Self(0b100);
    pub(crate) const NOT_EQUAL: Self = Self(0b101);
    pub(crate) const GREATER_OR_EQUAL: Self = Self(0b110);

    /// Does it hold between two values?
    #[inline]
    pub(crate) fn holds<T: PartialOrd + ?Sized>(self, left: &T, right: &T) -> bool {
        let order = 1u8 << (u8::from(left >= right) + u8::from(left > right));
        self.0 & order != 0
    }

    /// The relation that holds between the operands in the other order.
    pub(crate) const fn swapped(self) -> Self {
        Self((self.0 & 0b010) | ((self.0 & 0b001) << 2) | ((self.0 & 0b100) >> 2))
    }
}

/// Longs from the first to the last: whether another one is in any relation to a constant is whether it lies within a
/// range or outside of it, which takes one comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct LongRange {
    first: i32,
    /// How far the last one is from the first.
    span: u32,
}

impl LongRange {
    /// The range for `x relation value`, and whether `x` has to lie inside of it.
    pub(crate) const fn new(relation: Relation, value: i32) -> (Self, bool) {
        let below = value.wrapping_sub(i32::MIN) as u32;
        match relation {
            Relation::EQUAL => (Self { first: value, span: 0 }, true),
            Relation::NOT_EQUAL => (Self { first: value, span: 0 }, false),
            Relation::LESS_OR_EQUAL => (Self { first: i32::MIN, span: below }, true),
            Relation::GREATER => (Self { first: i32::MIN, span: below }, false),
            Relation::GREATER_OR_EQUAL => (Self { first: value, span: u32::MAX - below }, true),
            _ => (Self { first: value, span: u32::MAX - below }, false),
        }
    }

    #[inline]
    pub(crate) const fn contains(self, value: i32) -> bool {
        value.wrapping_sub(self.first) as u32 <= self.span
    }
}

/// Integer operators that are not in the fast set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LongOperator {
    Rem,
    And,
    Nand,
    Or,
    Nor,
    Xor,
    Xnor,
    ShiftLeft,
    ShiftRight,
}

/// Operators on values whose types are known at run time only.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ValueOperator {
    Add,
    Sub,
    Mul,
    Div,
}

/// What a device is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum DeviceQuery {
    /// `INKEY$`: a character or nothing.
    TakeCharacter,
    /// `GETCH`: waits for a character.
    AwaitCharacter,
    /// `KBHIT`: is there one?
    Waits,
}

/// One instruction. `to` is written, everything else is read.
///
/// The first word of a name is the file that the operands are in.
#[derive(Clone, Copy, Debug, PartialEq)]
#[rustfmt::skip] // One instruction a line.
pub(crate) enum Op {
    /// A statement that does nothing.
    Nothing,

    // Longs.
    LongConst { to: Slot, value: i32 },
    LongMove { to: Slot, from: Slot },
    LongNegate { to: Slot, from: Slot },
    LongNot { to: Slot, from: Slot },
    LongAbs { to: Slot, from: Slot },
    LongAdd { to: Slot, left: Slot, right: Slot },
    LongSub { to: Slot, left: Slot, right: Slot },
    LongMul { to: Slot, left: Slot, right: Slot },
    LongAddConst { to: Slot, left: Slot, value: i32 },
    LongMulConst { to: Slot, left: Slot, value: i32 },
    LongRemConst { to: Slot, left: Slot, value: i32 },
    LongOperate { operator: LongOperator, to: Slot, left: Slot, right: Slot },
    LongCompare { relation: Relation, to: Slot, left: Slot, right: Slot },

    // Doubles.
    DoubleConst { to: Slot, value: f64 },
    DoubleMove { to: Slot, from: Slot },
    DoubleNegate { to: Slot, from: Slot },
    DoubleAbs { to: Slot, from: Slot },
    DoubleAdd { to: Slot, left: Slot, right: Slot },
    DoubleSub { to: Slot, left: Slot, right: Slot },
    DoubleMul { to: Slot, left: Slot, right: Slot },
    DoubleDiv { to: Slot, left: Slot, right: Slot },
    DoubleAddConst { to: Slot, left: Slot, value: f64 },
    DoubleMulConst { to: Slot, left: Slot, value: f64 },
    DoubleDivConst { to: Slot, left: Slot, value: f64 },
    DoublePower { to: Slot, left: Slot, right: Slot },
    DoubleMath { function: Math, to: Slot, from: Slot },
    DoubleCompare { relation: Relation, to: Slot, left: Slot, right: Slot },
    /// Rounds to 32 bits.
    DoubleRound { to: Slot, from: Slot },
    Random { to: Slot, below: Slot },

    // Values.
    ValueConst { to: Slot, index: u32 },
    ValueMove { to: Slot, from: Slot },
    ValueNegate { to: Slot, from: Slot },
    ValueAbs { to: Slot, from: Slot },
    ValueOperate { operator: ValueOperator, to: Slot, left: Slot, right: Slot },
    /// A value against a real constant, which counts with 32 bits beside a value of 32 bits.
    RealCompare { relation: Relation, to: Slot, left: Slot, index: u32 },
    TextJoin { to: Slot, left: Slot, right: Slot },
    TextCompare { relation: Relation, to: Slot, left: Slot, right: Slot },
    /// Arguments in the value slots from `from`.
    TextCall { function: TextFunction, to: Slot, from: Slot, count: u8 },
    Device { query: DeviceQuery, to: Slot, device: Slot },

    // From file to file.
    LongToDouble { to: Slot, from: Slot },
    DoubleToLong { to: Slot, from: Slot },
    LongToValue { to: Slot, from: Slot },
    DoubleToValue { to: Slot, from: Slot },
    SingleToValue { to: Slot, from: Slot },
    ValueToLong { to: Slot, from: Slot },
    ValueToDouble { to: Slot, from: Slot },
    /// -1 for every number but zero.
    ValueTruth { to: Slot, from: Slot },

    // Variables.
    LoadSingle { to: Slot, index: u32 },
    StoreSingle { index: u32, from: Slot },
    LoadText { to: Slot, index: u32 },
    StoreText { index: u32, from: Slot },
    LoadLongElement { to: Slot, array: u16, element: Slot },
    StoreLongElement { array: u16, element: Slot, from: Slot },
    LoadDoubleElement { to: Slot, array: u16, element: Slot },
    StoreDoubleElement { array: u16, element: Slot, from: Slot },
    /// `LA0(n) = LA0(n) + right`
    AddLongElement { array: u16, element: Slot, right: Slot },
    AddDoubleElement { array: u16, element: Slot, right: Slot },
    /// A variable by a computed number, through the file of values.
    LoadVariable { class: OperandClass, to: Slot, index: Slot },
    StoreVariable { class: OperandClass, index: Slot, from: Slot },
    /// An element of any class, through the file of values.
    LoadElement { class: OperandClass, to: Slot, array: Slot, element: Slot },
    StoreElement { class: OperandClass, array: Slot, element: Slot, from: Slot },

    // Parameters and flags.
    LoadUser { to: Slot, number: u16 },
    StoreUser { number: u16, from: Slot },
    /// `P0 = P0 + value`
    AddUserConst { number: u16, value: f64 },
    LoadParameter { to: Slot, number: i32 },
    LoadParameterAt { to: Slot, number: Slot },
    StoreParameter { number: i32, from: Slot },
    StoreParameterAt { number: Slot, from: Slot },
    LoadBit { to: Slot, number: i32 },
    LoadBitAt { to: Slot, number: Slot },
    StoreBit { number: i32, from: Slot },
    StoreBitAt { number: Slot, from: Slot },
    /// `SET` and `CLR` with a constant.
    SetBit { number: i32, state: bool },

    // Flow.
    Jump { target: u32 },
    /// Goes back to the condition of a loop.
    Again { target: u32 },
    /// Jumps when a long is zero.
    JumpUnless { from: Slot, target: u32 },
    JumpUnlessLong { relation: Relation, left: Slot, right: Slot, target: u32 },
    JumpUnlessLongConst { range: LongRange, inside: bool, left: Slot, target: u32 },
    /// `IF (n MOD divisor = value)`, the usual way to do something in every so manieth pass.
    JumpUnlessRem { relation: Relation, left: Slot, divisor: i32, value: i32, target: u32 },
    JumpUnlessDouble { relation: Relation, left: Slot, right: Slot, target: u32 },
    JumpUnlessDoubleConst { relation: Relation, left: Slot, value: f64, target: u32 },
    /// Jumps when a flag is clear, or when it is set.
    JumpUnlessBit { number: i32, state: bool, target: u32 },
    Gosub { target: u32 },
    Return,
    /// Starts a loop: `end` and `step` are doubles. `whole` for a long counter, whose step is a whole number.
    LoopBegin { index: u16, end: Slot, step: Slot, whole: bool },
    /// Leaves the loop when the counter is beyond its end.
    LoopTest { index: u16, counter: Slot, target: u32 },
    LoopTestLong { index: u16, counter: Slot, target: u32 },
    /// Adds the step.
    LoopStep { index: u16, to: Slot, from: Slot },
    /// Adds the step and goes back unless the counter is then beyond the end.
    LoopNext { index: u16, counter: Slot, target: u32 },
    LoopNextLong { index: u16, counter: Slot, target: u32 },
    End,
    /// A statement that cannot be executed.
    Raise { index: u32 },

    // The rest.
    Dim { block: DimBlock, array: Slot, count: Slot, length: Slot },
    Clear,
    ClearMoves,
    Call { index: u32 },
}

// The size of an instruction is felt in every loop.
const _: () = assert!(size_of::<Op>() <= 16);

impl Op {
    /// Whether what follows in the list is not executed right behind it.
    pub(crate) const fn leaves(&self) -> bool {
        matches!(
            self,
            Self::Jump { .. } | Self::Again { .. } | Self::Gosub { .. } | Self::Return | Self::End | Self::Call { .. }
        )
    }

    /// Whether the loop of the numbers leaves it to others.
    pub(crate) const fn is_slow(&self) -> bool {
        matches!(
            self,
            Self::DoublePower { .. }
                | Self::DoubleMath { .. }
                | Self::Random { .. }
                | Self::ValueConst { .. }
                | Self::ValueMove { .. }
                | Self::ValueNegate { .. }
                | Self::ValueAbs { .. }
                | Self::ValueOperate { .. }
                | Self::RealCompare { .. }
                | Self::TextJoin { .. }
                | Self::TextCompare { .. }
                | Self::TextCall { .. }
                | Self::Device { .. }
                | Self::LongToValue { .. }
                | Self::DoubleToValue { .. }
                | Self::SingleToValue { .. }
                | Self::ValueToLong { .. }
                | Self::ValueToDouble { .. }
                | Self::ValueTruth { .. }
                | Self::LoadText { .. }
                | Self::StoreText { .. }
                | Self::LoadVariable { .. }
                | Self::StoreVariable { .. }
                | Self::LoadElement { .. }
                | Self::StoreElement { .. }
                | Self::LoadParameter { .. }
                | Self::LoadParameterAt { .. }
                | Self::StoreParameter { .. }
                | Self::StoreParameterAt { .. }
                | Self::LoadBit { .. }
                | Self::LoadBitAt { .. }
                | Self::StoreBit { .. }
                | Self::StoreBitAt { .. }
                | Self::SetBit { .. }
                | Self::JumpUnlessBit { .. }
                | Self::Dim { .. }
                | Self::Clear
                | Self::Call { .. }
        )
    }

    /// Where it jumps to, for jumps.
    pub(crate) fn target(mut self) -> Option<u32> {
        self.target_mut().copied()
    }

    /// Where it jumps to, for jumps.
    pub(crate) fn target_mut(&mut self) -> Option<&mut u32> {
        match self {
            Self::Jump { target }
            | Self::Again { target }
            | Self::JumpUnless { target, .. }
            | Self::JumpUnlessLong { target, .. }
            | Self::JumpUnlessLongConst { target, .. }
            | Self::JumpUnlessRem { target, .. }
            | Self::JumpUnlessDouble { target, .. }
            | Self::JumpUnlessDoubleConst { target, .. }
            | Self::JumpUnlessBit { target, .. }
            | Self::Gosub { target }
            | Self::LoopTest { target, .. }
            | Self::LoopTestLong { target, .. }
            | Self::LoopNext { target, .. }
            | Self::LoopNextLong { target, .. } => Some(target),
            _ => None,
        }
    }
}
