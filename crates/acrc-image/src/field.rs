//! The kinds of fields that words are made of, each with both directions.
//!
//! A field has a part in the bits of its word ([`Field::head`], [`Field::parse`]) and possibly words or bytes that follow the word
//! ([`Field::store`], [`Field::load`]).

use acrc_catalog::{CommandId, FunctionId, Keyword, ObjectKind, OperandClass, Operator, UnaryOperator};

use crate::decode::Decoder;
use crate::encode::Encoder;
use crate::error::{EncodeError, Problem};
use crate::name::AxisName;
use crate::node::{Node, Role};

/// One field of a node word.
pub(crate) trait Field {
    /// Its width in the word.
    const BITS: u32;
    /// What it holds, decoded.
    type Value;
    /// What its bits say before the words behind are read.
    type Head;

    /// Its bits.
    fn head(value: &Self::Value) -> Result<u32, EncodeError>;
    /// Reads its bits.
    fn parse(bits: u32) -> Result<Self::Head, Problem>;
    /// Writes what follows the word.
    fn store(_value: &Self::Value, _out: &mut Encoder) -> Result<(), EncodeError> {
        Ok(())
    }
    /// Reads what follows the word.
    fn load(head: Self::Head, input: &mut Decoder<'_>) -> Result<Self::Value, Problem>;
    /// Its bits for people; nothing when they say nothing that the words behind do not.
    fn show(_bits: u32) -> Option<String> {
        None
    }
}

/// A value with a stable code.
pub(crate) trait Code: Copy {
    /// Width of the code.
    const BITS: u32;
    /// What it is, for messages.
    const WHAT: &'static str;
    /// Its code.
    fn code(self) -> u32;
    /// The value of a code.
    fn from_code(code: u32) -> Option<Self>;
    /// Its name for people; nothing for the plain case.
    fn show(self) -> Option<String>;
}

macro_rules! codes {
    ($($type:ty, $bits:literal, $what:literal, $code:expr, $from:expr, $show:expr;)*) => {
        $(impl Code for $type {
            const BITS: u32 = $bits;
            const WHAT: &'static str = $what;
            fn code(self) -> u32 {
                let code: fn(Self) -> u32 = $code;
                code(self)
            }
            fn from_code(code: u32) -> Option<Self> {
                let from: fn(u32) -> Option<Self> = $from;
                from(code)
            }
            fn show(self) -> Option<String> {
                let show: fn(Self) -> Option<String> = $show;
                show(self)
            }
        })*
    };
}

/// The code of an absent number.
const NO_INDEX: u32 = 1023;

codes! {
    bool, 1, "flag", u32::from, |code| Some(code == 1), |set| set.then(|| "yes".to_owned());
    u16, 16, "number", u32::from, |code| u16::try_from(code).ok(), |number| Some(number.to_string());
    Option<u16>, 10, "object number", |index| index.map_or(NO_INDEX, u32::from),
        |code| Some(u16::try_from(code).ok().filter(|_| code != NO_INDEX)), |index| index.map(|number| number.to_string());
    AxisName, 20, "axis name", AxisName::packed, AxisName::from_packed, |name| Some(name.to_string());
    CommandId, 10, "opcode", |command| u32::from(command.0),
        |code| u16::try_from(code).ok().and_then(CommandId::from_opcode), |command| Some(command.info().name.to_owned());
    FunctionId, 8, "function", |function| u32::from(function.id()),
        |code| u8::try_from(code).ok().and_then(FunctionId::from_id), |function| Some(function.info().name.to_owned());
    Keyword, 8, "keyword", |keyword| u32::from(keyword.id()),
        |code| u8::try_from(code).ok().and_then(Keyword::from_id), |keyword| Some(keyword.to_string());
    ObjectKind, 5, "object kind", |kind| u32::from(kind.id()),
        |code| u8::try_from(code).ok().and_then(ObjectKind::from_id), |kind| Some(kind.to_string());
    OperandClass, 4, "operand class", |class| u32::from(class.id()),
        |code| u8::try_from(code).ok().and_then(OperandClass::from_id), |class| Some(class.to_string());
    Operator, 5, "operator", |operator| u32::from(operator.id()),
        |code| u8::try_from(code).ok().and_then(Operator::from_id), |operator| Some(operator.to_string());
    UnaryOperator, 2, "unary operator", |operator| u32::from(operator.id()),
        |code| u8::try_from(code).ok().and_then(UnaryOperator::from_id), |operator| Some(operator.to_string());
}

/// A field that is the code of a value.
pub(crate) struct Id<T>(std::marker::PhantomData<T>);

impl<T: Code> Field for Id<T> {
    const BITS: u32 = T::BITS;
    type Value = T;
    type Head = T;

    fn head(value: &T) -> Result<u32, EncodeError> {
        let bits = fit(T::WHAT, u64::from(value.code()), (1 << T::BITS) - 1)?;
        Self::parse(bits)?;
        Ok(bits)
    }

    fn parse(bits: u32) -> Result<T, Problem> {
        T::from_code(bits).ok_or(Problem::Unknown { what: T::WHAT, code: bits })
    }

    fn load(head: T, _input: &mut Decoder<'_>) -> Result<T, Problem> {
        Ok(head)
    }

    fn show(bits: u32) -> Option<String> {
        T::from_code(bits).and_then(T::show)
    }
}

/// The number of parentheses around a node.
pub(crate) struct Parens;

impl Field for Parens {
    const BITS: u32 = 3;
    type Value = u8;
    type Head = u8;

    fn head(value: &u8) -> Result<u32, EncodeError> {
        fit("the number of parentheses around an operand", u64::from(*value), 7)
    }

    fn parse(bits: u32) -> Result<u8, Problem> {
        Ok(bits as u8)
    }

    fn load(head: u8, _input: &mut Decoder<'_>) -> Result<u8, Problem> {
        Ok(head)
    }

    fn show(bits: u32) -> Option<String> {
        (bits > 0).then(|| bits.to_string())
    }
}

/// How an operand is written: as a node, or as a raw constant that the word before announces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A node word and what follows it.
    Node,
    /// One raw word.
    Long,
    /// One raw word.
    Single,
    /// Two raw words.
    Double,
}

impl Kind {
    /// Width of its code.
    pub(crate) const BITS: u32 = 2;

    /// The kind in the lowest bits.
    pub(crate) fn from_bits(bits: u32) -> Self {
        match bits & 3 {
            0 => Self::Node,
            1 => Self::Long,
            2 => Self::Single,
            _ => Self::Double,
        }
    }

    /// The kind that a node is written with.
    pub(crate) fn of(node: &Node) -> Self {
        match node {
            Node::Long(_) => Self::Long,
            Node::Single(_) => Self::Single,
            Node::Double(_) => Self::Double,
            _ => Self::Node,
        }
    }
}

/// One operand that is an expression.
pub(crate) struct Child;

impl Field for Child {
    const BITS: u32 = Kind::BITS;
    type Value = Box<Node>;
    type Head = Kind;

    fn head(value: &Box<Node>) -> Result<u32, EncodeError> {
        Ok(Kind::of(value) as u32)
    }

    fn parse(bits: u32) -> Result<Kind, Problem> {
        Ok(Kind::from_bits(bits))
    }

    fn store(value: &Box<Node>, out: &mut Encoder) -> Result<(), EncodeError> {
        out.operand(value, Role::Expression)
    }

    fn load(head: Kind, input: &mut Decoder<'_>) -> Result<Box<Node>, Problem> {
        input.operand(head, Role::Expression).map(Box::new)
    }
}

/// The value of an axis or an object, where it has one.
pub(crate) struct OptionalValue;

impl Field for OptionalValue {
    const BITS: u32 = 1 + Kind::BITS;
    type Value = Option<Box<Node>>;
    type Head = Option<Kind>;

    fn head(value: &Option<Box<Node>>) -> Result<u32, EncodeError> {
        Ok(value.as_ref().map_or(0, |node| 1 | (Kind::of(node) as u32) << 1))
    }

    fn parse(bits: u32) -> Result<Option<Kind>, Problem> {
        match bits {
            0 => Ok(None),
            present if present & 1 == 1 => Ok(Some(Kind::from_bits(present >> 1))),
            other => Err(Problem::NotCanonical(other)),
        }
    }

    fn store(value: &Option<Box<Node>>, out: &mut Encoder) -> Result<(), EncodeError> {
        value.as_ref().map_or(Ok(()), |node| out.operand(node, Role::Value))
    }

    fn load(head: Option<Kind>, input: &mut Decoder<'_>) -> Result<Option<Box<Node>>, Problem> {
        head.map(|kind| input.operand(kind, Role::Value).map(Box::new)).transpose()
    }
}

/// `LEAST` to `MOST` expressions: their number (3 bits) and the kind of each.
pub(crate) struct List<const LEAST: usize, const MOST: usize>;

impl<const LEAST: usize, const MOST: usize> Field for List<LEAST, MOST> {
    const BITS: u32 = 3 + MOST as u32 * Kind::BITS;
    type Value = Vec<Node>;
    type Head = (usize, u32);

    fn head(value: &Vec<Node>) -> Result<u32, EncodeError> {
        let count = fit("the number of values in parentheses", value.len() as u64, MOST as u64)?;
        if value.len() < LEAST {
            return Err(Problem::Operands("a tuple has at least two values").into());
        }
        let kinds = value.iter().rev().fold(0, |kinds, node| kinds << Kind::BITS | Kind::of(node) as u32);
        Ok(count | kinds << 3)
    }

    fn parse(bits: u32) -> Result<Self::Head, Problem> {
        let (count, kinds) = ((bits & 7) as usize, bits >> 3);
        let valid = (LEAST..=MOST).contains(&count) && kinds >> (count as u32 * Kind::BITS) == 0;
        if valid { Ok((count, kinds)) } else { Err(Problem::NotCanonical(bits)) }
    }

    fn store(value: &Vec<Node>, out: &mut Encoder) -> Result<(), EncodeError> {
        value.iter().try_for_each(|node| out.operand(node, Role::Expression))
    }

    fn load((count, kinds): Self::Head, input: &mut Decoder<'_>) -> Result<Vec<Node>, Problem> {
        let kind = |place: usize| Kind::from_bits(kinds >> (place as u32 * Kind::BITS));
        (0..count).map(|place| input.operand(kind(place), Role::Expression)).collect()
    }
}

/// The length of a text whose bytes are the next ones of the pool.
pub(crate) struct Text;

impl Field for Text {
    const BITS: u32 = 16;
    type Value = Vec<u8>;
    type Head = usize;

    fn head(value: &Vec<u8>) -> Result<u32, EncodeError> {
        fit("the length of a text", value.len() as u64, u64::from(u16::MAX))
    }

    fn parse(bits: u32) -> Result<usize, Problem> {
        Ok(bits as usize)
    }

    fn store(value: &Vec<u8>, out: &mut Encoder) -> Result<(), EncodeError> {
        out.text(value);
        Ok(())
    }

    fn load(head: usize, input: &mut Decoder<'_>) -> Result<Vec<u8>, Problem> {
        input.text(head).map(<[u8]>::to_vec)
    }

    fn show(bits: u32) -> Option<String> {
        Some(bits.to_string())
    }
}

/// `value` as field bits, when it is within `limit`.
pub(crate) fn fit(what: &'static str, value: u64, limit: u64) -> Result<u32, EncodeError> {
    if value <= limit { Ok(value as u32) } else { Err(EncodeError::TooLarge { what, value, limit }) }
}
