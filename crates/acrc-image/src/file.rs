//! The file format `.acrx`: a header with budgets, so that a reader can refuse early, then the sections. All numbers are little-endian; the
//! same image gives the same bytes. `docs/image-format.md` specifies it.

use crate::debug::{DebugEntry, DebugMap, Location, Span};
use crate::decode::Decoder;
use crate::encode::Encoder;
use crate::error::{EncodeError, ImageError, Problem};
use crate::field::Kind;
use crate::image::{Alias, Image, VERSION};
use crate::node::Role;
use crate::unit::{Unit, UnitName};

/// The bytes that every image begins with.
pub const MAGIC: &[u8; 4] = b"ACRX";
/// Where the checksum stands; it covers every other byte.
const CHECKSUM: std::ops::Range<usize> = 12..16;
/// Length of the header.
const HEADER: usize = 36;
/// Bytes before the words of a unit: which unit it is, its number, and the numbers of its words and of its pool bytes.
const UNIT_HEADER: usize = 10;
/// The image has a debug section.
const FLAG_DEBUG: u16 = 1;
/// Bytes of one entry of a debug map.
const DEBUG_ENTRY: u64 = 20;

/// What the sections hold in all, as the header says.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Budgets {
    programs: u32,
    aliases: u32,
    files: u32,
    words: u32,
    strings: u32,
}

impl Image {
    /// The bytes of an `.acrx` file.
    ///
    /// # Errors
    /// [`EncodeError`] when a name, a text or a table is too large for its length field, or the target of an alias cannot be encoded.
    pub fn to_bytes(&self) -> Result<Vec<u8>, EncodeError> {
        self.write().map(|(bytes, _)| bytes)
    }

    /// Where the words of each unit begin in [`Image::to_bytes`], in bytes and in the order of [`Image::units`].
    ///
    /// # Errors
    /// As for [`Image::to_bytes`].
    pub fn offsets(&self) -> Result<Vec<usize>, EncodeError> {
        self.write().map(|(_, offsets)| offsets)
    }

    fn write(&self) -> Result<(Vec<u8>, Vec<usize>), EncodeError> {
        let has_debug = self.units().any(|unit| unit.debug.is_some()) || !self.files.is_empty();
        let mut out = Writer::default();
        out.bytes.extend_from_slice(MAGIC);
        out.u16(VERSION);
        out.u16(if has_debug { FLAG_DEBUG } else { 0 });
        out.bytes.resize(CHECKSUM.end, 0);
        let budgets = self.budgets()?;
        for budget in [budgets.programs, budgets.aliases, budgets.files, budgets.words, budgets.strings] {
            out.u32(budget);
        }
        out.name("the name of the model", &self.model)?;
        for alias in &self.aliases {
            out.alias(alias)?;
        }
        let mut offsets = Vec::new();
        for unit in self.units() {
            offsets.push(out.bytes.len() + UNIT_HEADER);
            out.unit(unit)?;
        }
        if has_debug {
            out.debug(self)?;
        }
        let length = length("the image", out.bytes.len())?;
        out.patch(8..12, length);
        let checksum = checksum(&out.bytes);
        out.patch(CHECKSUM, checksum);
        Ok((out.bytes, offsets))
    }

    /// Reads an `.acrx` file and verifies it.
    ///
    /// # Errors
    /// [`ImageError`], a reason of its own for each way a file can be wrong. No bytes make it panic or use memory out of proportion to them.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, ImageError> {
        let (flags, budgets) = header(bytes)?;
        let mut input = Reader { rest: bytes.get(HEADER..).unwrap_or_default() };
        let model = input.name()?;
        let aliases = input.repeat(budgets.aliases, Reader::alias)?;
        let mut boot = input.unit()?;
        let mut programs = input.repeat(budgets.programs, Reader::unit)?;
        let mut files = Vec::new();
        if flags & FLAG_DEBUG != 0 {
            files = input.repeat(budgets.files, Reader::name)?;
            for unit in std::iter::once(&mut boot).chain(&mut programs) {
                unit.debug = input.debug_map()?;
            }
        }
        if !input.rest.is_empty() {
            return Err(ImageError::Malformed("bytes follow the last section"));
        }
        let image = Self { model, aliases, boot, programs, files, version: VERSION };
        image.check(budgets)?;
        image.verify()?;
        Ok(image)
    }

    fn budgets(&self) -> Result<Budgets, EncodeError> {
        Ok(Budgets {
            programs: length("the number of programs", self.programs.len())?,
            aliases: length("the number of aliases", self.aliases.len())?,
            files: length("the number of files", self.files.len())?,
            words: length("the number of words", self.units().map(|unit| unit.words.len()).sum())?,
            strings: length("the length of all texts", self.units().map(|unit| unit.strings.len()).sum())?,
        })
    }

    fn check(&self, budgets: Budgets) -> Result<(), ImageError> {
        if self.boot.name != UnitName::Boot || self.programs.iter().any(|unit| unit.name == UnitName::Boot) {
            return Err(ImageError::Malformed("the first unit, and no other, is the boot unit"));
        }
        if self.budgets() != Ok(budgets) {
            return Err(ImageError::Malformed("the sections do not hold what the header says"));
        }
        Ok(())
    }
}

/// Checks the header and gives its flags and budgets.
fn header(bytes: &[u8]) -> Result<(u16, Budgets), ImageError> {
    let found = bytes.len() as u64;
    if !bytes.starts_with(MAGIC) {
        return Err(ImageError::NotAnImage);
    }
    let mut input = Reader { rest: bytes.get(MAGIC.len()..).unwrap_or_default() };
    let short = |_| ImageError::Truncated { expected: HEADER as u64, found };
    let (version, flags) = (input.u16().map_err(short)?, input.u16().map_err(short)?);
    if version > VERSION {
        return Err(ImageError::NewerVersion { found: version, newest: VERSION });
    }
    let expected = u64::from(input.u32().map_err(short)?);
    if found < expected.max(HEADER as u64) {
        return Err(ImageError::Truncated { expected: expected.max(HEADER as u64), found });
    }
    if found > expected {
        return Err(ImageError::TrailingBytes { extra: found - expected });
    }
    let (stored, computed) = (input.u32().map_err(short)?, checksum(bytes));
    if stored != computed {
        return Err(ImageError::Altered { stored, computed });
    }
    if version == 0 {
        return Err(ImageError::UnknownHeader { what: "version", value: version });
    }
    if flags & !FLAG_DEBUG != 0 {
        return Err(ImageError::UnknownHeader { what: "flags", value: flags });
    }
    let mut next = || input.u32().map_err(short);
    let budgets = Budgets { programs: next()?, aliases: next()?, files: next()?, words: next()?, strings: next()? };
    Ok((flags, budgets))
}

/// The checksum over everything but its own place.
fn checksum(bytes: &[u8]) -> u32 {
    let mut hasher = crc32fast::Hasher::new();
    hasher.update(bytes.get(..CHECKSUM.start).unwrap_or(bytes));
    hasher.update(bytes.get(CHECKSUM.end..).unwrap_or_default());
    hasher.finalize()
}

fn length(what: &'static str, length: usize) -> Result<u32, EncodeError> {
    crate::field::fit(what, length as u64, u64::from(u32::MAX))
}

#[derive(Default)]
struct Writer {
    bytes: Vec<u8>,
}

impl Writer {
    fn u16(&mut self, value: u16) {
        self.bytes.extend_from_slice(&value.to_le_bytes());
    }

    fn u32(&mut self, value: u32) {
        self.bytes.extend_from_slice(&value.to_le_bytes());
    }

    fn patch(&mut self, at: std::ops::Range<usize>, value: u32) {
        if let Some(place) = self.bytes.get_mut(at) {
            place.copy_from_slice(&value.to_le_bytes());
        }
    }

    fn name(&mut self, what: &'static str, name: &str) -> Result<(), EncodeError> {
        self.u16(crate::field::fit(what, name.len() as u64, u64::from(u16::MAX))? as u16);
        self.bytes.extend_from_slice(name.as_bytes());
        Ok(())
    }

    fn words(&mut self, words: &[u32], strings: &[u8]) -> Result<(), EncodeError> {
        self.u32(length("the number of words", words.len())?);
        self.u32(length("the length of all texts", strings.len())?);
        for &word in words {
            self.u32(word);
        }
        self.bytes.extend_from_slice(strings);
        Ok(())
    }

    fn alias(&mut self, alias: &Alias) -> Result<(), EncodeError> {
        self.name("the name of an alias", &alias.name)?;
        let (kind, words, strings) = Encoder::single(&alias.target)?;
        self.bytes.push(kind);
        self.words(&words, &strings)
    }

    fn unit(&mut self, unit: &Unit) -> Result<(), EncodeError> {
        let (kind, number) = match unit.name {
            UnitName::Boot => (0, 0),
            UnitName::Program(number) => (1, number),
            UnitName::Plc(number) => (2, number),
        };
        self.bytes.extend_from_slice(&[kind, number]);
        self.words(&unit.words, &unit.strings)
    }

    /// File names, then for each unit whether it has a map, and the map.
    fn debug(&mut self, image: &Image) -> Result<(), EncodeError> {
        for file in &image.files {
            self.name("the name of a file", file)?;
        }
        for unit in image.units() {
            self.bytes.push(u8::from(unit.debug.is_some()));
            let Some(map) = &unit.debug else { continue };
            self.u32(length("the number of statements", map.entries().len())?);
            for DebugEntry { address, location: Location { file, span, line } } in map.entries() {
                for value in [*address, *file, span.start, span.end, *line] {
                    self.u32(value);
                }
            }
        }
        Ok(())
    }
}

struct Reader<'a> {
    rest: &'a [u8],
}

impl<'a> Reader<'a> {
    fn take(&mut self, count: usize) -> Result<&'a [u8], ImageError> {
        let (taken, rest) =
            self.rest.split_at_checked(count).ok_or(ImageError::Malformed("a section ends too early"))?;
        self.rest = rest;
        Ok(taken)
    }

    fn array<const N: usize>(&mut self) -> Result<[u8; N], ImageError> {
        let mut array = [0; N];
        array.copy_from_slice(self.take(N)?);
        Ok(array)
    }

    fn u16(&mut self) -> Result<u16, ImageError> {
        self.array().map(u16::from_le_bytes)
    }

    fn u32(&mut self) -> Result<u32, ImageError> {
        self.array().map(u32::from_le_bytes)
    }

    /// `count` elements; memory grows only with what is really there.
    fn repeat<T>(&mut self, count: u32, element: fn(&mut Self) -> Result<T, ImageError>) -> Result<Vec<T>, ImageError> {
        let mut elements = Vec::new();
        for _ in 0..count {
            elements.push(element(self)?);
        }
        Ok(elements)
    }

    fn name(&mut self) -> Result<String, ImageError> {
        let length = self.u16()?;
        let bytes = self.take(usize::from(length))?;
        str::from_utf8(bytes).map(str::to_owned).map_err(|_| ImageError::Malformed("a name is not UTF-8"))
    }

    fn words(&mut self) -> Result<(Vec<u32>, Vec<u8>), ImageError> {
        let (words, strings) = (self.u32()?, self.u32()?);
        let bytes = self.take((words as usize).saturating_mul(4))?;
        let (words, _) = bytes.as_chunks::<4>();
        Ok((words.iter().map(|&word| u32::from_le_bytes(word)).collect(), self.take(strings as usize)?.to_vec()))
    }

    fn alias(&mut self) -> Result<Alias, ImageError> {
        let name = self.name()?;
        let [kind] = self.array()?;
        let (words, strings) = self.words()?;
        let mut decoder = Decoder::new(&words, &strings);
        let target = decoder.operand(Kind::from_bits(u32::from(kind)), Role::Expression).and_then(|target| {
            decoder.finish()?;
            let whole = decoder.at_end() && kind <= 3;
            if whole { Ok(target) } else { Err(Problem::NotCanonical(u32::from(kind))) }
        });
        match target {
            Ok(target) => Ok(Alias { name, target }),
            Err(problem) => Err(ImageError::AliasTarget { name, problem }),
        }
    }

    fn unit(&mut self) -> Result<Unit, ImageError> {
        let name = match self.array()? {
            [0, 0] => UnitName::Boot,
            [1, number] => UnitName::Program(number),
            [2, number] => UnitName::Plc(number),
            _ => return Err(ImageError::Malformed("a unit is neither boot, PROG nor PLC")),
        };
        let (words, strings) = self.words()?;
        Ok(Unit { name, words, strings, debug: None })
    }

    fn debug_map(&mut self) -> Result<Option<DebugMap>, ImageError> {
        match self.array()? {
            [0] => return Ok(None),
            [1] => {}
            _ => return Err(ImageError::Malformed("a unit has neither one debug map nor none")),
        }
        let count = self.u32()?;
        if u64::from(count) * DEBUG_ENTRY > self.rest.len() as u64 {
            return Err(ImageError::Malformed("a section ends too early"));
        }
        let entries = self.repeat(count, |input| {
            let address = input.u32()?;
            let file = input.u32()?;
            let span = Span { start: input.u32()?, end: input.u32()? };
            Ok(DebugEntry { address, location: Location { file, span, line: input.u32()? } })
        })?;
        DebugMap::from_entries(entries)
            .map(Some)
            .ok_or(ImageError::Malformed("the addresses of a debug map do not rise"))
    }
}
