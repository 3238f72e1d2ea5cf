//! The layout of the words. This table is the only definition of it: encoder, decoder and [`crate::dump`] are made from it, and a test holds
//! `docs/image-format.md` to it.

use crate::decode::Decoder;
use crate::encode::Encoder;
use crate::error::{EncodeError, Problem};
use crate::field::{Child, Field, Id, List, OptionalValue, Parens, Text};
use crate::node::Node;
use acrc_catalog::{CommandId, FunctionId, Keyword, ObjectKind, OperandClass, Operator, UnaryOperator};

/// Bits of the tag of a node word, from bit 0.
pub const TAG_BITS: u32 = 5;
/// Bits of the mark of a node word, behind the tag.
pub const MARK_BITS: u32 = 2;
/// Where the fields of a node word begin.
pub const FIRST_FIELD: u32 = TAG_BITS + MARK_BITS;
/// Tag of the word that wraps a constant from the fifth item on; its one field is the kind of the constant.
pub const CONST: u32 = 15;
/// Tag of the word behind the last of fifteen or more items.
pub const END: u32 = 16;

/// The layout of one kind of node word.
#[derive(Clone, Copy, Debug)]
pub struct Layout {
    /// Its name.
    pub name: &'static str,
    /// Its tag.
    pub tag: u32,
    /// Its fields, from [`FIRST_FIELD`] upwards.
    pub fields: &'static [FieldLayout],
}

/// A field of a word.
#[derive(Clone, Copy, Debug)]
pub struct FieldLayout {
    /// Its name.
    pub name: &'static str,
    /// Its width in bits.
    pub width: u32,
    /// Its bits for people; nothing when they say nothing that the words behind do not.
    pub show: fn(u32) -> Option<String>,
}

macro_rules! node_words {
    ($($variant:ident = $tag:literal $shape:ident ( $($field:ident : $codec:ty),* );)*) => {
        /// Every kind of node word, in the order of tags.
        pub const LAYOUTS: &[Layout] = &[
            $(Layout { name: stringify!($variant), tag: $tag, fields: &[$(FieldLayout {
                name: stringify!($field),
                width: <$codec as Field>::BITS,
                show: <$codec as Field>::show,
            }),*] },)*
            Layout { name: "Const", tag: CONST, fields: &[FieldLayout { name: "kind", width: 2, show: |_| None }] },
            Layout { name: "End", tag: END, fields: &[] },
        ];

        $(const _: () = assert!(FIRST_FIELD $(+ <$codec as Field>::BITS)* <= 32);)*

        /// Writes a node that is no constant.
        pub(crate) fn store(node: &Node, mark: u32, out: &mut Encoder) -> Result<(), EncodeError> {
            match node {
                $(node_words!(@$shape $variant $($field)*) => {
                    // A function of its own for each kind: a nested node then costs one small stack frame and not the sum of all.
                    fn store(mark: u32, out: &mut Encoder, $($field: &<$codec as Field>::Value),*) -> Result<(), EncodeError> {
                        let mut word = FieldWriter { word: $tag | mark << TAG_BITS, at: FIRST_FIELD };
                        $(word.put(<$codec as Field>::head($field)?, <$codec as Field>::BITS);)*
                        out.word(word.word);
                        $(<$codec as Field>::store($field, out)?;)*
                        Ok(())
                    }
                    store(mark, out, $($field),*)
                })*
                Node::Long(_) | Node::Single(_) | Node::Double(_) => Err(Problem::Misplaced("a constant").into()),
            }
        }

        /// Reads what follows a node word.
        pub(crate) fn load(word: u32, input: &mut Decoder<'_>) -> Result<Node, Problem> {
            match word & ((1 << TAG_BITS) - 1) {
                $($tag => {
                    fn load(word: u32, input: &mut Decoder<'_>) -> Result<Node, Problem> {
                        let mut bits = FieldReader { rest: word >> FIRST_FIELD };
                        $(let $field = <$codec as Field>::parse(bits.take(<$codec as Field>::BITS))?;)*
                        if bits.rest != 0 {
                            return Err(Problem::NotCanonical(word));
                        }
                        $(let $field = <$codec as Field>::load($field, input)?;)*
                        Ok(node_words!(@$shape $variant $($field)*))
                    }
                    load(word, input)
                })*
                tag => Err(Problem::Unknown { what: "node tag", code: tag }),
            }
        }
    };
    (@named $variant:ident $($field:ident)*) => { Node::$variant { $($field),* } };
    (@plain $variant:ident $($field:ident)*) => { Node::$variant($($field),*) };
}

node_words! {
    String = 1 named (parens: Parens, bytes: Text);
    Scalar = 2 named (parens: Parens, class: Id<OperandClass>, index: Child);
    Array = 3 named (parens: Parens, class: Id<OperandClass>, array: Child, element: Child);
    Alias = 4 named (parens: Parens, index: Id<u16>);
    LabelRef = 5 plain (ordinal: Id<u16>);
    Unary = 6 named (parens: Parens, op: Id<UnaryOperator>, operand: Child);
    Binary = 7 named (parens: Parens, op: Id<Operator>, left: Child, right: Child);
    Call = 8 named (parens: Parens, function: Id<FunctionId>, arguments: List<0, 4>);
    Axis = 9 named (name: Id<crate::name::AxisName>, slash: Id<bool>, value: OptionalValue);
    Object = 10 named (kind: Id<ObjectKind>, index: Id<Option<u16>>, slash: Id<bool>, prefix: Id<bool>, value: OptionalValue);
    Tuple = 11 plain (values: List<2, 7>);
    Word = 12 named (keyword: Id<Keyword>, index: Id<Option<u16>>);
    Interpolation = 13 plain (command: Id<CommandId>);
    Device = 14 plain (number: Child);
}

/// Puts fields into a word, from the lowest free bit upwards.
pub(crate) struct FieldWriter {
    /// The word so far.
    pub(crate) word: u32,
    /// The lowest free bit.
    pub(crate) at: u32,
}

impl FieldWriter {
    /// Adds a field. `bits` fits `width`.
    pub(crate) fn put(&mut self, bits: u32, width: u32) {
        self.word |= bits << self.at;
        self.at += width;
    }
}

/// Takes fields from the bits of a word, from the lowest upwards.
pub(crate) struct FieldReader {
    /// The bits not taken yet.
    pub(crate) rest: u32,
}

impl FieldReader {
    /// The next field. `width` is below 32.
    pub(crate) fn take(&mut self, width: u32) -> u32 {
        let bits = self.rest & ((1 << width) - 1);
        self.rest >>= width;
        bits
    }
}

/// The command word: how the statement is set off, what it does, how many items follow, and how the first four of them are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CommandWord {
    /// Code of [`crate::Separator`].
    pub separator: u32,
    /// Operation code.
    pub opcode: u32,
    /// Items; [`MANY`] when an [`END`] word closes them.
    pub count: u32,
    /// Kind and mark of the first items.
    pub slots: [Slot; SLOTS],
}

/// How one of the first items is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Slot {
    /// 0 node, 1 long, 2 single, 3 double.
    pub kind: u32,
    /// Code of [`crate::Mark`].
    pub mark: u32,
}

/// Items that have a slot in the command word.
pub const SLOTS: usize = 4;
/// The count that says that an [`END`] word follows the last item.
pub const MANY: u32 = 15;

/// Name and width of the fields of a command word, from bit 0 upwards.
pub const COMMAND_FIELDS: &[(&str, u32)] = &[
    ("separator", 2),
    ("opcode", 10),
    ("count", 4),
    ("kind 1", 2),
    ("mark 1", 2),
    ("kind 2", 2),
    ("mark 2", 2),
    ("kind 3", 2),
    ("mark 3", 2),
    ("kind 4", 2),
    ("mark 4", 2),
];

impl CommandWord {
    /// The word.
    pub fn pack(&self) -> u32 {
        let mut word = FieldWriter { word: 0, at: 0 };
        let heads = [self.separator, self.opcode, self.count];
        let values = heads.into_iter().chain(self.slots.iter().flat_map(|slot| [slot.kind, slot.mark]));
        for (value, &(_, width)) in values.zip(COMMAND_FIELDS) {
            word.put(value, width);
        }
        word.word
    }

    /// The fields of a word.
    pub fn unpack(word: u32) -> Self {
        let mut bits = FieldReader { rest: word };
        let mut widths = COMMAND_FIELDS.iter().map(|&(_, width)| width);
        let mut next = || widths.next().map_or(0, |width| bits.take(width));
        let (separator, opcode, count) = (next(), next(), next());
        Self { separator, opcode, count, slots: std::array::from_fn(|_| Slot { kind: next(), mark: next() }) }
    }
}
