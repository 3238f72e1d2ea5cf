//! `INPUT`: a typed line goes to variables (guide, "Character I/O").

use acrc_catalog::OperandClass;

use crate::fault::FaultKind;
use crate::functions::leading_number;
use crate::host::{Arg, Host, Reference};
use crate::locals::Locals;
use crate::text::Text;
use crate::value::Value;

/// Whether a typed line has a value for each variable of an `INPUT`, and a number for each that takes one: for a host
/// that asks again until it has.
pub fn input_fits(line: &[u8], arguments: &[Arg]) -> bool {
    fields(line, arguments).all(|(target, field)| field.is_some_and(|field| is_text(target) || is_number(field)))
}

/// Stores a line in the variables that the arguments name.
///
/// A missing value is 0 or an empty string, as `VAL` reads it.
pub(super) fn store<H: Host>(
    line: &Text,
    arguments: &[Arg],
    locals: &mut Locals,
    host: &mut H,
) -> Result<(), FaultKind> {
    for (target, field) in fields(line.as_bytes(), arguments) {
        let field = field.unwrap_or_default();
        let value = if is_text(target) { Value::Text(Text::from(field)) } else { Value::Double(leading_number(field)) };
        write(target, &value, locals, host)?;
    }
    Ok(())
}

/// The variables that the arguments name, each with its part of the line: a comma stands between two values. A string
/// that comes last takes the rest of the line.
fn fields<'a>(line: &'a [u8], arguments: &'a [Arg]) -> impl Iterator<Item = (Reference, Option<&'a [u8]>)> {
    let targets = arguments.iter().filter_map(|argument| match argument {
        Arg::Reference { target, .. } => Some(*target),
        _ => None,
    });
    let mut targets = targets.peekable();
    let mut rest = Some(line);
    std::iter::from_fn(move || {
        let target = targets.next()?;
        let whole = targets.peek().is_none() && is_text(target);
        let field = rest.take().map(|text| match text.iter().position(|byte| *byte == b',').filter(|_| !whole) {
            Some(comma) => {
                rest = text.get(comma + 1..);
                text.get(..comma).unwrap_or_default()
            }
            None => text,
        });
        Some((target, field))
    })
}

fn is_text(target: Reference) -> bool {
    let (Reference::Variable { class, .. } | Reference::Element { class, .. }) = target else { return false };
    matches!(class, OperandClass::StringV | OperandClass::StringA)
}

/// Whether a field is a number and nothing else, beside blanks.
fn is_number(field: &[u8]) -> bool {
    let field = field.trim_ascii();
    let plain = field.iter().all(|byte| byte.is_ascii_digit() || matches!(byte, b'+' | b'-' | b'.' | b'e' | b'E'));
    let number = std::str::from_utf8(field).ok().and_then(|text| text.parse::<f64>().ok());
    plain && number.is_some_and(f64::is_finite)
}

fn write<H: Host>(target: Reference, value: &Value, locals: &mut Locals, host: &mut H) -> Result<(), FaultKind> {
    match target {
        Reference::Parameter(number) => host.set_parameter(number, value),
        Reference::Bit(number) => host.set_bit(number, value.truth()?),
        _ => locals.write(target, value),
    }
}
