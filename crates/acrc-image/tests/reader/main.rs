//! Somebody else's reader: it knows `docs/image-format.md` and nothing of the crate, and reads the golden images as the crate does.

mod file;
mod page;

use std::fs;
use std::path::{Path, PathBuf};

use acrc_image::list::{ListOptions, list};
use acrc_image::{DebugEntry, Image, Instruction, Mark, Node, Separator, Unit, VERSION};
use file::File;
use page::Page;

/// The statements of a unit in the notation of the reader.
fn statements(unit: &Unit) -> Vec<String> {
    unit.decode().expect("verified").iter().map(statement).collect()
}

fn statement(instruction: &Instruction) -> String {
    let separator = match instruction.separator {
        Separator::Blank => "blank",
        Separator::Colon => "colon",
        Separator::Line => "line",
        Separator::Then => "then",
    };
    let items = instruction.items.iter().map(|item| {
        let mark = match item.mark {
            Mark::None => "",
            Mark::Comma => ",",
            Mark::Semicolon => ";",
        };
        operand(&item.node) + mark
    });
    let items: Vec<String> = items.collect();
    format!("{} {separator} {}: {}", instruction.address, instruction.command.info().name, items.join(" "))
}

fn operand(node: &Node) -> String {
    let number = |index: &Option<u16>| index.map_or("-".to_owned(), |index| index.to_string());
    let value = |value: &Option<Box<Node>>| value.as_deref().map_or("-".to_owned(), operand);
    let all = |nodes: &[Node]| format!("[{}]", nodes.iter().map(operand).collect::<Vec<_>>().join(" "));
    match node {
        Node::Long(value) => value.to_string(),
        Node::Single(value) => format!("{value:?}f"),
        Node::Double(value) => format!("{value:?}"),
        Node::String { bytes, parens } => format!("String({parens} {:?})", acrc_image::text::decode(bytes)),
        Node::Scalar { class, index, parens } => format!("Scalar({parens} {class} {})", operand(index)),
        Node::Array { class, array, element, parens } => {
            format!("Array({parens} {class} {} {})", operand(array), operand(element))
        }
        Node::Alias { index, parens } => format!("Alias({parens} {index})"),
        Node::LabelRef(ordinal) => format!("LabelRef({ordinal})"),
        Node::Unary { op, operand: inner, parens } => format!("Unary({parens} {op} {})", operand(inner)),
        Node::Binary { op, left, right, parens } => {
            format!("Binary({parens} {op} {} {})", operand(left), operand(right))
        }
        Node::Call { function, arguments, parens } => {
            format!("Call({parens} {} {})", function.info().name, all(arguments))
        }
        Node::Axis { name, slash, value: target } => format!("Axis({name} {} {})", u8::from(*slash), value(target)),
        Node::Object { kind, index, slash, prefix, value: target } => {
            let (slash, prefix) = (u8::from(*slash), u8::from(*prefix));
            format!("Object({kind} {} {slash} {prefix} {})", number(index), value(target))
        }
        Node::Tuple(values) => format!("Tuple({})", all(values)),
        Node::Word { keyword, index } => format!("Word({keyword} {})", number(index)),
        Node::Interpolation(command) => format!("Interpolation({})", command.info().name),
        Node::Device(number) => format!("Device({})", operand(number)),
    }
}

fn golden() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/golden/v{VERSION}"));
    let entries = fs::read_dir(folder).expect("each version has its images");
    let paths = entries.map(|entry| entry.expect("readable").path());
    paths.filter(|path| path.extension().is_some_and(|extension| extension == "acrx")).collect()
}

#[test]
fn the_page_is_enough_to_read_every_image() {
    let (page, images) = (Page::read(), golden());
    assert!(images.len() >= 30, "{} images", images.len());
    for path in images {
        let name = path.display();
        let bytes = fs::read(&path).expect("readable");
        let (image, read) = (Image::from_bytes(&bytes).expect("valid"), file::read(&bytes, &page));
        assert_eq!((read.version, &read.model, &read.sources), (VERSION, &image.model, &image.files), "{name}");
        let aliases = image.aliases.iter().map(|alias| (alias.name.clone(), operand(&alias.target)));
        assert_eq!(read.aliases, aliases.collect::<Vec<_>>(), "{name}");
        assert_eq!(read.units.len(), image.units().count(), "{name}");
        for (read_unit, unit) in read.units.iter().zip(image.units()) {
            assert_eq!(read_unit.name, unit.name.to_string(), "{name}");
            assert_eq!(read_unit.statements, statements(unit), "{name}");
            let place = |entry: &DebugEntry| {
                let location = entry.location;
                [entry.address, location.file, location.span.start, location.span.end, location.line]
            };
            let places = unit.debug.as_ref().map(|map| map.entries().iter().map(place).collect::<Vec<_>>());
            assert_eq!(read_unit.places, places, "{name}");
        }
        assert_listed(&read, &image);
    }
}

/// What the reader found stands in the listing too: the words of the commands, the lines, the aliases, the texts.
fn assert_listed(read: &File, image: &Image) {
    for (read_unit, unit) in read.units.iter().zip(image.units()) {
        let listed = list(unit, &image.aliases, &ListOptions::default()).expect("valid");
        let lines = read_unit.statements.iter().filter(|statement| statement.contains(" line ")).count();
        assert_eq!(listed.lines().count(), lines, "{listed}");
        for statement in &read_unit.statements {
            let (head, items) = statement.split_once(": ").expect("a command and its items");
            let command = head.splitn(3, ' ').nth(2).expect("a command");
            let is_word = command.starts_with(|first: char| first.is_ascii_uppercase());
            for word in command.split(' ').filter(|_| is_word) {
                assert!(listed.contains(word), "{statement}\n{listed}");
            }
            for text in items.split('"').skip(1).step_by(2) {
                assert!(listed.contains(text), "{statement}\n{listed}");
            }
        }
    }
}
