//! A reader of image files, written from the page alone.

use crate::page::Page;

/// What is in a file.
pub(crate) struct File {
    pub(crate) version: u16,
    pub(crate) model: String,
    /// Names and operands.
    pub(crate) aliases: Vec<(String, String)>,
    pub(crate) units: Vec<Unit>,
    /// Names of the source files.
    pub(crate) sources: Vec<String>,
}

/// A unit.
pub(crate) struct Unit {
    pub(crate) name: String,
    pub(crate) statements: Vec<String>,
    /// Address, file, first byte, end and line of each statement.
    pub(crate) places: Option<Vec<[u32; 5]>>,
}

/// Reads a file.
pub(crate) fn read(bytes: &[u8], page: &Page) -> File {
    let header: Vec<u32> = bytes[..36].chunks(4).map(|word| u32::from_le_bytes(word.try_into().unwrap())).collect();
    assert_eq!(&bytes[..4], b"ACRX");
    let (version, flags) = (header[1] as u16, header[1] >> 16);
    assert_eq!(header[2] as usize, bytes.len());
    assert_eq!(header[3], crc32(bytes[..12].iter().chain(&bytes[16..])));
    let (programs, aliases, files) = (header[4], header[5], header[6]);
    let mut input = Input { rest: &bytes[36..] };
    let model = input.name();
    let aliases = (0..aliases).map(|_| {
        let name = input.name();
        let kind = u32::from(input.byte());
        let mut stream = input.stream();
        (name, stream.operand(kind, page))
    });
    let aliases = aliases.collect();
    let mut totals = [0, 0];
    let units = (0..=programs).map(|_| {
        let name = match (input.byte(), input.byte()) {
            (0, 0) => "boot".to_owned(),
            (1, number) => format!("PROG{number}"),
            (2, number) => format!("PLC{number}"),
            other => panic!("unit {other:?}"),
        };
        let mut stream = input.stream();
        totals = [totals[0] + stream.words.len() as u32, totals[1] + stream.pool.len() as u32];
        let mut statements = Vec::new();
        while stream.at < stream.words.len() {
            statements.push(stream.statement(page));
        }
        assert!(stream.pool.is_empty());
        Unit { name, statements, places: None }
    });
    let mut units: Vec<Unit> = units.collect();
    assert_eq!(totals, [header[7], header[8]]);
    let mut sources = Vec::new();
    if flags & 1 != 0 {
        sources.extend((0..files).map(|_| input.name()));
        for unit in &mut units {
            if input.byte() == 1 {
                let count = input.number();
                unit.places = Some((0..count).map(|_| std::array::from_fn(|_| input.number())).collect());
            }
        }
    }
    assert!(input.rest.is_empty());
    File { version, model, aliases, units, sources }
}

/// The checksum of zip and gzip.
fn crc32<'a>(bytes: impl Iterator<Item = &'a u8>) -> u32 {
    let step = |crc: u32, &byte: &u8| {
        (0..8).fold(crc ^ u32::from(byte), |crc, _| if crc & 1 == 1 { crc >> 1 ^ 0xEDB8_8320 } else { crc >> 1 })
    };
    !bytes.fold(u32::MAX, step)
}

struct Input<'a> {
    rest: &'a [u8],
}

impl<'a> Input<'a> {
    fn take(&mut self, count: usize) -> &'a [u8] {
        let (taken, rest) = self.rest.split_at(count);
        self.rest = rest;
        taken
    }

    fn byte(&mut self) -> u8 {
        self.take(1)[0]
    }

    fn number(&mut self) -> u32 {
        u32::from_le_bytes(self.take(4).try_into().unwrap())
    }

    fn name(&mut self) -> String {
        let length = u16::from_le_bytes(self.take(2).try_into().unwrap());
        String::from_utf8(self.take(length.into()).to_vec()).unwrap()
    }

    fn stream(&mut self) -> Stream<'a> {
        let (words, pool) = (self.number() as usize, self.number() as usize);
        let words = self.take(4 * words).chunks(4).map(|word| u32::from_le_bytes(word.try_into().unwrap()));
        Stream { words: words.collect(), at: 0, pool: self.take(pool) }
    }
}

/// Words and the texts that belong to them.
struct Stream<'a> {
    words: Vec<u32>,
    at: usize,
    pool: &'a [u8],
}

/// Takes bits from the lowest upwards.
fn bits(word: &mut u32, width: u32) -> u32 {
    let taken = *word & ((1 << width) - 1);
    *word >>= width;
    taken
}

impl Stream<'_> {
    fn word(&mut self) -> u32 {
        self.at += 1;
        self.words[self.at - 1]
    }

    fn statement(&mut self, page: &Page) -> String {
        let address = self.at;
        let mut head = self.word();
        let separator = ["blank", "colon", "line", "then"][bits(&mut head, 2) as usize];
        let command = page.command(bits(&mut head, 10));
        let count = bits(&mut head, 4);
        let mut items = Vec::new();
        while count == 15 || items.len() < count as usize {
            let (item, mark) = if items.len() < 4 {
                let (kind, mark) = (bits(&mut head, 2), bits(&mut head, 2));
                (self.operand(kind, page), mark)
            } else {
                let word = self.word();
                match page.layouts[&(word & 31)].name.as_str() {
                    "End" => break,
                    "Const" => (self.operand(word >> 7, page), word >> 5 & 3),
                    _ => (self.node(word, page), word >> 5 & 3),
                }
            };
            items.push(item + ["", ",", ";"][mark as usize]);
        }
        format!("{address} {separator} {command}: {}", items.join(" "))
    }

    fn operand(&mut self, kind: u32, page: &Page) -> String {
        match kind {
            0 => {
                let word = self.word();
                self.node(word, page)
            }
            1 => self.word().cast_signed().to_string(),
            2 => format!("{:?}f", f32::from_bits(self.word())),
            _ => {
                let (low, high) = (u64::from(self.word()), u64::from(self.word()));
                format!("{:?}", f64::from_bits(high << 32 | low))
            }
        }
    }

    fn node(&mut self, word: u32, page: &Page) -> String {
        let layout = &page.layouts[&(word & 31)];
        let mut rest = word >> 7;
        // All the fields of the word come before the operands that they announce.
        let fields: Vec<(&str, u32)> =
            layout.fields.iter().map(|(name, width)| (name.as_str(), bits(&mut rest, *width))).collect();
        let fields: Vec<String> =
            fields.into_iter().map(|(name, value)| self.field(&layout.name, name, value, page)).collect();
        format!("{}({})", layout.name, fields.join(" "))
    }

    fn field(&mut self, node: &str, field: &str, bits: u32, page: &Page) -> String {
        match (node, field) {
            ("Object" | "Word", "index") => {
                if bits == 1023 {
                    "-".to_owned()
                } else {
                    bits.to_string()
                }
            }
            (_, "parens" | "slash" | "prefix" | "ordinal") | ("Alias", "index") => bits.to_string(),
            ("String", "bytes") => {
                let (text, rest) = self.pool.split_at(bits as usize);
                self.pool = rest;
                format!("{:?}", text.iter().copied().map(char::from).collect::<String>())
            }
            (_, "class") => page.code(1, bits),
            ("Unary", "op") => page.code(2, bits),
            (_, "op") => page.code(3, bits),
            ("Object", "kind") => page.code(4, bits),
            (_, "keyword") => page.code(5, bits),
            (_, "function") => page.function(bits),
            (_, "command") => page.command(bits),
            (_, "name") => {
                let letters = (0..4).map(|place| bits >> (5 * place) & 31).take_while(|&letter| letter > 0);
                letters.map(|letter| char::from(b'@' + letter as u8)).collect()
            }
            (_, "value") => {
                if bits & 1 == 0 {
                    "-".to_owned()
                } else {
                    self.operand(bits >> 1, page)
                }
            }
            (_, "arguments" | "values") => {
                let operands = (0..bits & 7).map(|place| self.operand(bits >> (3 + 2 * place) & 3, page));
                format!("[{}]", operands.collect::<Vec<_>>().join(" "))
            }
            _ => self.operand(bits, page),
        }
    }
}
