//! The TOML of working memory: programs as an image, texts with mistakes as they were typed.

use acrc_catalog::memory::SystemBlock;
use acrc_controller::nonvolatile::{Memory, TypedLine, TypedText};
use acrc_image::{EncodeError, Image, UnitName};
use acrc_vm::Text;
use serde::{Deserialize, Serialize};

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct WireMemory {
    /// Bytes of each block.
    blocks: Vec<(String, u32)>,
    user: Vec<f64>,
    hardware: Option<String>,
    /// `PASSWORD`, two digits a byte.
    password: Option<String>,
    /// The texts and their aliases: an `.acrx` file, two digits a byte.
    programs: String,
    /// The texts that have mistakes, as they were typed.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    typed: Vec<WireText>,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct WireText {
    /// `PROG0`, `PLC0`
    name: String,
    lines: Vec<WireLine>,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct WireLine {
    number: u32,
    /// The number was typed.
    written: bool,
    text: String,
}

impl WireMemory {
    pub(super) fn new(model: &str, memory: &Memory) -> Result<Self, EncodeError> {
        let image = Image { aliases: memory.aliases.clone(), programs: memory.programs.clone(), ..Image::empty(model) };
        Ok(Self {
            blocks: memory.blocks.iter().map(|(block, bytes)| (block.to_string(), *bytes)).collect(),
            user: memory.user.clone(),
            hardware: memory.hardware.clone(),
            password: memory.password.as_ref().map(|text| hex(text.as_bytes())),
            programs: hex(&image.to_bytes()?),
            typed: memory.typed.iter().map(WireText::new).collect(),
        })
    }

    pub(super) fn read(self) -> Result<Memory, String> {
        let bytes = unhex(&self.programs).ok_or("the programs are not written as pairs of hexadecimal digits")?;
        let image = Image::from_bytes(&bytes).map_err(|error| format!("the programs: {error}"))?;
        let password = self.password.map(|text| unhex(&text).ok_or("the password is not written as pairs of digits"));
        let block = |(name, bytes): (String, u32)| match name.parse() {
            Ok(block) => Ok((block, bytes)),
            Err(error) => Err(format!("{error}")),
        };
        Ok(Memory {
            blocks: self.blocks.into_iter().map(block).collect::<Result<_, _>>()?,
            aliases: image.aliases,
            programs: image.programs,
            typed: self.typed.into_iter().map(WireText::read).collect::<Result<_, _>>()?,
            user: self.user,
            hardware: self.hardware,
            password: password.transpose()?.map(|bytes| Text::from(&bytes[..])),
        })
    }
}

impl WireText {
    fn new(text: &TypedText) -> Self {
        let line = |line: &TypedLine| WireLine { number: line.number, written: line.written, text: line.text.clone() };
        Self { name: text.name.to_string(), lines: text.lines.iter().map(line).collect() }
    }

    fn read(self) -> Result<TypedText, String> {
        let name = match self.name.parse() {
            Ok(SystemBlock::Program(number)) => UnitName::Program(number),
            Ok(SystemBlock::Plc(number)) => UnitName::Plc(number),
            _ => return Err(format!("`{}` is no program", self.name)),
        };
        let line = |line: WireLine| TypedLine { number: line.number, written: line.written, text: line.text };
        Ok(TypedText { name, lines: self.lines.into_iter().map(line).collect() })
    }
}

fn hex(bytes: &[u8]) -> String {
    let digits = bytes.iter().flat_map(|byte| [byte >> 4, byte & 15]);
    digits.filter_map(|digit| char::from_digit(u32::from(digit), 16)).collect()
}

fn unhex(text: &str) -> Option<Vec<u8>> {
    let (pairs, rest) = text.as_bytes().as_chunks::<2>();
    let digit = |digit: u8| char::from(digit).to_digit(16);
    let bytes = pairs.iter().map(|[high, low]| Some((digit(*high)? * 16 + digit(*low)?) as u8));
    if rest.is_empty() { bytes.collect() } else { None }
}
