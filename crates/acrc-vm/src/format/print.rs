//! One `PRINT` statement as bytes (guide, "Character I/O").

use acrc_catalog::Keyword;
use acrc_image::Mark;

use super::{Picture, number};
use crate::fault::FaultKind;
use crate::host::Arg;
use crate::value::Value;

/// The device of a `PRINT` that names none: private to each program.
const DEFAULT_DEVICE: i32 = 0;

/// What a `PRINT` sends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Printed {
    /// The device: 0 is private to each program, 1 to 3 are shared.
    pub device: i32,
    /// The characters, with CR LF at the end unless the statement ends with a comma or a semicolon.
    pub bytes: Vec<u8>,
}

/// Formats the arguments of a `PRINT`.
///
/// A comma between items becomes a tab, a semicolon nothing; either of them at the end keeps the line open. After
/// `USING` every number of the statement is printed in the picture, strings as they are.
///
/// # Errors
/// [`FaultKind::TextExpected`] for a picture that is not a string, [`FaultKind::Argument`] for an argument that cannot
/// be printed.
pub fn print_line(arguments: &[Arg]) -> Result<Printed, FaultKind> {
    let mut printed = Printed { device: DEFAULT_DEVICE, bytes: Vec::new() };
    let mut picture = None;
    let mut picture_follows = false;
    let mut open = false;
    for argument in arguments {
        match argument {
            Arg::Device(device) => printed.device = *device,
            Arg::Word { keyword: Keyword::Using, .. } => picture_follows = true,
            Arg::Value(value, _) if picture_follows => {
                picture = Some(Picture::new(value.as_text()?.as_bytes()));
                picture_follows = false;
            }
            Arg::Value(value, mark) => {
                print_value(&mut printed.bytes, picture.as_ref(), value);
                open = *mark != Mark::None;
                if *mark == Mark::Comma {
                    printed.bytes.push(b'\t');
                }
            }
            _ => return Err(FaultKind::Argument("PRINT takes values only".into())),
        }
    }
    if !open {
        printed.bytes.extend_from_slice(b"\r\n");
    }
    Ok(printed)
}

fn print_value(line: &mut Vec<u8>, picture: Option<&Picture>, value: &Value) {
    match (picture, value) {
        (_, Value::Text(text)) => line.extend_from_slice(text.as_bytes()),
        (Some(picture), _) => line.extend(picture.apply(value)),
        (None, _) => line.extend(number(value).bytes()),
    }
}
