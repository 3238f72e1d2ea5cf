//! Functions that take or give strings.
//!
//! Places in a string count from 1. What reaches beyond a string is cut at its ends; a negative length and a place
//! before 1 are faults.

use acrc_catalog::{FunctionId, function};

use crate::fault::FaultKind;
use crate::format;
use crate::text::Text;
use crate::value::Value;

/// What a string function gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TextResult {
    Text,
    Long,
    Double,
}

macro_rules! text_functions {
    ($($variant:ident = $id:ident $name:literal $result:ident $evaluate:path;)+) => {
        /// A function of strings, or one that gives a string.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub(crate) enum TextFunction { $($variant,)+ }

        impl TextFunction {
            /// The function of the catalogue.
            pub(crate) fn from_id(id: FunctionId) -> Option<Self> {
                match id {
                    $(function::$id => Some(Self::$variant),)+
                    _ => None,
                }
            }

            /// Type of its result.
            pub(crate) const fn result(self) -> TextResult {
                match self { $(Self::$variant => TextResult::$result,)+ }
            }

            /// Evaluates it.
            pub(crate) fn evaluate(self, arguments: &[Value]) -> Result<Value, FaultKind> {
                match self { $(Self::$variant => $evaluate(&Arguments { name: $name, values: arguments }),)+ }
            }
        }
    };
}

text_functions! {
    Asc = ASC "ASC" Long asc;
    Chr = CHR_DOLLAR "CHR$" Text chr;
    Instr = INSTR "INSTR" Long instr;
    LowerCase = LCASE_DOLLAR "LCASE$" Text lower_case;
    Left = LEFT_DOLLAR "LEFT$" Text left;
    Len = LEN "LEN" Long len;
    Mid = MID_DOLLAR "MID$" Text mid;
    Right = RIGHT_DOLLAR "RIGHT$" Text right;
    Space = SPACE_DOLLAR "SPACE$" Text space;
    Str = STR_DOLLAR "STR$" Text str;
    Repeat = STRING_DOLLAR "STRING$" Text repeat;
    UpperCase = UCASE_DOLLAR "UCASE$" Text upper_case;
    Val = VAL "VAL" Double val;
}

/// Longest string that `SPACE$` and `STRING$` make: no string variable of a controller can hold more.
const LONGEST: i32 = 65_535;

/// The arguments of one call.
struct Arguments<'a> {
    name: &'static str,
    values: &'a [Value],
}

impl Arguments<'_> {
    fn get(&self, place: usize) -> Result<&Value, FaultKind> {
        self.values.get(place).ok_or_else(|| FaultKind::Argument(format!("{} needs more arguments", self.name).into()))
    }

    fn text(&self, place: usize) -> Result<&Text, FaultKind> {
        self.get(place)?.as_text()
    }

    fn long(&self, place: usize) -> Result<i32, FaultKind> {
        self.get(place)?.to_long()
    }

    /// An argument that has to lie in a range.
    fn within(&self, place: usize, range: std::ops::RangeInclusive<i32>) -> Result<usize, FaultKind> {
        let value = self.long(place)?;
        match usize::try_from(value) {
            Ok(number) if range.contains(&value) => Ok(number),
            _ => Err(FaultKind::Domain { function: self.name, argument: f64::from(value) }),
        }
    }
}

fn text(bytes: Vec<u8>) -> Value {
    Value::Text(Text::from(bytes))
}

/// Code of the first character; 0 for an empty string, so that `ASC(INKEY$(1))` can be polled.
fn asc(arguments: &Arguments) -> Result<Value, FaultKind> {
    Ok(Value::Long(arguments.text(0)?.as_bytes().first().copied().map_or(0, i32::from)))
}

fn chr(arguments: &Arguments) -> Result<Value, FaultKind> {
    Ok(text(vec![arguments.within(0, 0..=255)? as u8]))
}

/// Place of the second string in the first, 0 when it is not there; a third argument is the place to start at.
fn instr(arguments: &Arguments) -> Result<Value, FaultKind> {
    let (within, wanted) = (arguments.text(0)?.as_bytes(), arguments.text(1)?.as_bytes());
    let start = if arguments.values.len() > 2 { arguments.within(2, 1..=i32::MAX)? } else { 1 };
    let rest = within.get(start - 1..).unwrap_or_default();
    let found = if wanted.is_empty() { None } else { rest.windows(wanted.len()).position(|window| window == wanted) };
    Ok(Value::Long(found.map_or(0, |place| (place + start) as i32)))
}

fn lower_case(arguments: &Arguments) -> Result<Value, FaultKind> {
    Ok(text(arguments.text(0)?.as_bytes().to_ascii_lowercase()))
}

fn upper_case(arguments: &Arguments) -> Result<Value, FaultKind> {
    Ok(text(arguments.text(0)?.as_bytes().to_ascii_uppercase()))
}

fn left(arguments: &Arguments) -> Result<Value, FaultKind> {
    let bytes = arguments.text(0)?.as_bytes();
    let length = arguments.within(1, 0..=i32::MAX)?.min(bytes.len());
    Ok(Value::Text(Text::from(&bytes[..length])))
}

fn right(arguments: &Arguments) -> Result<Value, FaultKind> {
    let bytes = arguments.text(0)?.as_bytes();
    let length = arguments.within(1, 0..=i32::MAX)?.min(bytes.len());
    Ok(Value::Text(Text::from(&bytes[bytes.len() - length..])))
}

fn mid(arguments: &Arguments) -> Result<Value, FaultKind> {
    let bytes = arguments.text(0)?.as_bytes();
    let rest = bytes.get(arguments.within(1, 1..=i32::MAX)? - 1..).unwrap_or_default();
    let length = if arguments.values.len() > 2 { arguments.within(2, 0..=i32::MAX)? } else { rest.len() };
    Ok(Value::Text(Text::from(&rest[..length.min(rest.len())])))
}

fn len(arguments: &Arguments) -> Result<Value, FaultKind> {
    Ok(Value::Long(arguments.text(0)?.len() as i32))
}

fn space(arguments: &Arguments) -> Result<Value, FaultKind> {
    Ok(text(vec![b' '; arguments.within(0, 0..=LONGEST)?]))
}

/// `STRING$(n, code)` and `STRING$(n, "x")`
fn repeat(arguments: &Arguments) -> Result<Value, FaultKind> {
    let count = arguments.within(0, 0..=LONGEST)?;
    let character = match arguments.get(1)? {
        Value::Text(text) => text.as_bytes().first().copied(),
        _ => Some(arguments.within(1, 0..=255)? as u8),
    };
    Ok(text(character.map_or_else(Vec::new, |character| vec![character; count])))
}

fn str(arguments: &Arguments) -> Result<Value, FaultKind> {
    match arguments.get(0)? {
        Value::Text(_) => Err(FaultKind::NumberExpected),
        value => Ok(Value::Text(Text::from(&*format::number(value)))),
    }
}

/// The number at the start of a string; 0 when there is none.
fn val(arguments: &Arguments) -> Result<Value, FaultKind> {
    Ok(Value::Double(leading_number(arguments.text(0)?.as_bytes())))
}

/// The number at the start of a text, behind blanks; 0 when there is none.
pub(crate) fn leading_number(bytes: &[u8]) -> f64 {
    let bytes = bytes.trim_ascii_start();
    let sign = usize::from(matches!(bytes.first(), Some(b'+' | b'-')));
    let mut end = sign + digits(bytes, sign);
    if bytes.get(end) == Some(&b'.') {
        end += 1 + digits(bytes, end + 1);
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let exponent = end + 1 + usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        match digits(bytes, exponent) {
            0 => {}
            count => end = exponent + count,
        }
    }
    let number = bytes.get(..end).and_then(|number| std::str::from_utf8(number).ok());
    number.and_then(|number| number.parse().ok()).filter(|value: &f64| value.is_finite()).unwrap_or(0.0)
}

/// How many digits stand at a place.
fn digits(bytes: &[u8], start: usize) -> usize {
    bytes.iter().skip(start).take_while(|byte| byte.is_ascii_digit()).count()
}
