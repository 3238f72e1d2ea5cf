//! `INPUT`: a typed line goes to variables (guide, "Character I/O").

use acrc_catalog::OperandClass;

use crate::fault::FaultKind;
use crate::functions::leading_number;
use crate::host::{Arg, Host, Reference};
use crate::locals::Locals;
use crate::text::Text;
use crate::value::Value;

/// Stores a line in the variables that the arguments name, a comma between two values.
///
/// A missing value is 0 or an empty string, as `VAL` reads it. A string that comes last takes the rest of the line.
pub(super) fn store<H: Host>(
    line: &Text,
    arguments: &[Arg],
    locals: &mut Locals,
    host: &mut H,
) -> Result<(), FaultKind> {
    let targets = arguments.iter().filter_map(|argument| match argument {
        Arg::Reference { target, .. } => Some(*target),
        _ => None,
    });
    let mut rest = line.as_bytes();
    let mut targets = targets.peekable();
    while let Some(target) = targets.next() {
        let whole = targets.peek().is_none() && is_text(target);
        let end = if whole { None } else { rest.iter().position(|byte| *byte == b',') };
        let field = rest.get(..end.unwrap_or(rest.len())).unwrap_or_default();
        let value = if is_text(target) { Value::Text(Text::from(field)) } else { Value::Double(leading_number(field)) };
        write(target, &value, locals, host)?;
        rest = end.and_then(|end| rest.get(end + 1..)).unwrap_or_default();
    }
    Ok(())
}

fn is_text(target: Reference) -> bool {
    let (Reference::Variable { class, .. } | Reference::Element { class, .. }) = target else { return false };
    matches!(class, OperandClass::StringV | OperandClass::StringA)
}

fn write<H: Host>(target: Reference, value: &Value, locals: &mut Locals, host: &mut H) -> Result<(), FaultKind> {
    match target {
        Reference::Parameter(number) => host.set_parameter(number, value),
        Reference::Bit(number) => host.set_bit(number, value.truth()?),
        _ => locals.write(target, value),
    }
}
