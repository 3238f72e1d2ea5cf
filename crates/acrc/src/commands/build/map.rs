//! The map of an image: where its units lie, what their bytes go to, and where labels, lines and aliases are.

use std::fmt::Write as _;
use std::path::Path;

use acrc_image::list::{Line, ListOptions, lines, list_instructions};
use acrc_image::{Alias, Image, Instruction, Item, Node, Separator, TextCost, Unit, UnitName};
use serde::Serialize;

use crate::commands::kinds::Kinds;

/// The version of the JSON form. It grows when a field changes its meaning or goes.
const VERSION: u32 = 1;

/// What the bytes of each unit go to, and where its lines and labels stand in the source; worked out before these places are stripped.
pub(super) struct Places(Vec<UnitPlaces>);

struct UnitPlaces {
    cost: TextCost,
    lines: Vec<LinePlace>,
}

#[derive(Serialize)]
struct LinePlace {
    /// The number of the line, also where it is hidden; null in the setup code.
    number: Option<u32>,
    /// It is written in the source.
    written: bool,
    address: u32,
    labels: Vec<Label>,
    #[serde(flatten)]
    source: Option<Place>,
}

#[derive(Serialize)]
struct Place {
    file: String,
    line: u32,
}

#[derive(Serialize)]
struct Label {
    name: String,
    address: u32,
}

#[derive(Serialize)]
struct Document<'a> {
    version: u32,
    project: &'a str,
    model: &'a str,
    image_bytes: usize,
    units: Vec<UnitMap<'a>>,
    aliases: Vec<AliasMap<'a>>,
}

#[derive(Serialize)]
struct UnitMap<'a> {
    unit: String,
    /// Where its words begin in the image, in bytes.
    offset: usize,
    bytes: u32,
    words: usize,
    characters: usize,
    kinds: Kinds,
    lines: &'a [LinePlace],
}

#[derive(Serialize)]
struct AliasMap<'a> {
    name: &'a str,
    operand: String,
}

impl Places {
    /// The places of all units.
    pub(super) fn of(image: &Image) -> anyhow::Result<Self> {
        let units = image.units().map(|unit| {
            let instructions = unit.decode()?;
            let cost = instructions.iter().map(|statement| TextCost::of(statement.command, &statement.items)).sum();
            let labels = unit.labels()?;
            let place = |line: Line<'_>| {
                let behind = line.statements.last().map_or(line.address, |last| last.address);
                let labels = labels.iter().filter(|label| (line.address..=behind).contains(&label.address));
                let labels = labels.map(|label| Label { name: label.name.clone(), address: label.address }).collect();
                LinePlace {
                    number: (unit.name != UnitName::Boot).then_some(line.number),
                    written: line.numbered,
                    address: line.address,
                    labels,
                    source: source(image, unit, line.address),
                }
            };
            Ok(UnitPlaces { cost, lines: lines(&instructions).map(place).collect() })
        });
        units.collect::<anyhow::Result<Vec<_>>>().map(Self)
    }
}

fn source(image: &Image, unit: &Unit, address: u32) -> Option<Place> {
    let location = unit.debug.as_ref()?.locate(address)?;
    Some(Place { file: image.files.get(location.file as usize)?.clone(), line: location.line })
}

/// The map for a file: JSON when its name ends so, else text.
pub(super) fn write(
    project: &str,
    image: &Image,
    bytes: &[u8],
    places: &Places,
    path: &Path,
) -> anyhow::Result<String> {
    let document = document(project, image, bytes, places)?;
    if path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("json")) {
        return Ok(serde_json::to_string_pretty(&document)? + "\n");
    }
    Ok(text(&document))
}

fn document<'a>(
    project: &'a str,
    image: &'a Image,
    bytes: &[u8],
    Places(places): &'a Places,
) -> anyhow::Result<Document<'a>> {
    let units = image.units().zip(image.offsets()?).zip(places).map(|((unit, offset), places)| UnitMap {
        unit: unit.name.to_string(),
        offset,
        bytes: unit.memory(),
        words: unit.words.len(),
        characters: unit.strings.len(),
        kinds: Kinds(places.cost),
        lines: &places.lines,
    });
    let aliases = (0..).zip(&image.aliases).map(|(place, alias)| alias_map(place, alias, &image.aliases));
    Ok(Document {
        version: VERSION,
        project,
        model: &image.model,
        image_bytes: bytes.len(),
        units: units.collect(),
        aliases: aliases.collect::<anyhow::Result<_>>()?,
    })
}

/// The operand of an alias as the lister writes it behind `#DEFINE` and the name.
fn alias_map<'a>(place: u16, alias: &'a Alias, aliases: &[Alias]) -> anyhow::Result<AliasMap<'a>> {
    let define = Instruction {
        address: 0,
        separator: Separator::Line,
        command: acrc_catalog::command::DEFINE,
        items: vec![Item::from(Node::Alias { index: place, parens: 0 })],
    };
    let written = list_instructions(&[define], aliases, &ListOptions::default());
    let written = written.map_err(|(_, problem)| anyhow::Error::new(problem))?;
    let operand = written.trim_end().splitn(3, ' ').nth(2).unwrap_or_default();
    Ok(AliasMap { name: &alias.name, operand: operand.to_owned() })
}

fn text(map: &Document<'_>) -> String {
    let mut out = format!("{} for {}: an image of {} bytes\n\n", map.project, map.model, map.image_bytes);
    let heads = TextCost::default().kinds().map(|(name, _)| name.to_owned());
    row(&mut out, "unit", ["offset", "bytes"].map(str::to_owned).iter().chain(&heads));
    for unit in &map.units {
        let kinds = unit.kinds.0.kinds();
        let kinds = kinds.map(|(_, bytes)| if bytes == 0 { "-".to_owned() } else { bytes.to_string() });
        row(&mut out, &unit.unit, [format!("0x{:X}", unit.offset), unit.bytes.to_string()].iter().chain(&kinds));
    }
    if !map.aliases.is_empty() {
        let width = map.aliases.iter().map(|alias| alias.name.chars().count()).max().unwrap_or(0);
        out.push_str("\naliases\n");
        for AliasMap { name, operand } in &map.aliases {
            let _ = writeln!(out, "  {name:<width$}  {operand}");
        }
    }
    for unit in map.units.iter().filter(|unit| !unit.lines.is_empty()) {
        unit_text(&mut out, unit);
    }
    out
}

fn row<'a>(out: &mut String, name: &str, cells: impl Iterator<Item = &'a String>) {
    let cells: Vec<String> = cells.map(|cell| format!("{cell:>9}")).collect();
    let _ = writeln!(out, "{name:<6} {}", cells.join(" "));
}

/// A row for each line: its address and number, its place in the source, its labels. Numbers that are not written stand in parentheses.
fn unit_text(out: &mut String, unit: &UnitMap<'_>) {
    let place = |line: &LinePlace| {
        line.source.as_ref().map_or_else(String::new, |place| format!("{}:{}", place.file, place.line))
    };
    let width = unit.lines.iter().map(|line| place(line).chars().count()).max().unwrap_or(0);
    let _ = writeln!(out, "\n{}\n  {:>6}  {:>7}  {:<width$}  label", unit.unit, "word", "line", "source");
    for line in unit.lines {
        let number = match line.number {
            None => String::new(),
            Some(number) if line.written => format!("{number} "),
            Some(number) => format!("({number})"),
        };
        let labels: Vec<String> = line.labels.iter().map(|label| format!("_{}", label.name)).collect();
        let row = format!("  {:>6}  {number:>8} {:<width$}  {}", line.address, place(line), labels.join(" "));
        let _ = writeln!(out, "{}", row.trim_end());
    }
}
