//! The file format: what is written is read, and everything else is refused for its own reason.

mod common;

use acrc_catalog::{OperandClass, command};
use acrc_image::{
    Alias, Image, ImageError, Instruction, Location, Node, Problem, Separator, Span, UnitBuilder, UnitName, VERSION,
    encode,
};
use common::instructions;
use proptest::prelude::*;

fn image(program: &[Instruction]) -> Image {
    let mut boot = UnitBuilder::new(UnitName::Boot);
    let address = boot.push(Separator::Line, command::PROGRAM, &[Node::Long(0).into()]).expect("valid");
    boot.locate(address, Location { file: 0, span: Span { start: 6, end: 13 }, line: 2 });
    let alias =
        |name: &str, number| Alias { name: name.to_owned(), target: Node::scalar(OperandClass::Parameter, number) };
    Image {
        model: "ACR9000".to_owned(),
        aliases: ["Count", "Limit", "Speed", "Mode"]
            .into_iter()
            .zip(0..)
            .map(|(name, number)| alias(name, number))
            .collect(),
        boot: boot.finish().expect("valid"),
        programs: vec![encode(UnitName::Program(0), program).expect("valid")],
        files: vec!["Prog0.8K".to_owned()],
        version: VERSION,
    }
}

fn sample() -> Image {
    let print = |separator, text: &str| Instruction {
        address: 0,
        separator,
        command: command::PRINT,
        items: vec![Node::string(text).into()],
    };
    image(&[print(Separator::Line, "ready"), print(Separator::Colon, "steady")])
}

/// Writes the right checksum into changed bytes.
fn seal(bytes: &mut [u8]) {
    let mut hasher = crc32fast::Hasher::new();
    hasher.update(&bytes[..12]);
    hasher.update(&bytes[16..]);
    bytes[12..16].copy_from_slice(&hasher.finalize().to_le_bytes());
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 64, ..ProptestConfig::default() })]

    #[test]
    fn what_is_written_is_read(instructions in instructions()) {
        let image = image(&instructions);
        let bytes = image.to_bytes().expect("small enough");
        prop_assert_eq!(&bytes, &image.to_bytes().expect("small enough"));
        prop_assert_eq!(Image::from_bytes(&bytes).expect("written a moment ago"), image);
    }

    #[test]
    fn a_changed_byte_is_always_noticed(place in any::<prop::sample::Index>(), change in 1..=255_u8) {
        let mut bytes = sample().to_bytes().expect("small enough");
        let place = place.index(bytes.len());
        bytes[place] ^= change;
        prop_assert!(Image::from_bytes(&bytes).is_err());
    }

    #[test]
    fn random_bytes_do_no_harm(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
        prop_assert!(Image::from_bytes(&bytes).is_err());
    }
}

#[test]
fn every_truncation_is_called_one() {
    let bytes = sample().to_bytes().expect("small enough");
    for length in 4..bytes.len() {
        let refused = Image::from_bytes(&bytes[..length]);
        assert!(matches!(refused, Err(ImageError::Truncated { .. })), "{length}: {refused:?}");
    }
    assert_eq!(Image::from_bytes(&bytes[..3]), Err(ImageError::NotAnImage));
}

#[test]
fn each_wrong_file_has_its_own_reason() {
    let good = sample().to_bytes().expect("small enough");
    let changed = |at: usize, value: u8| {
        let mut bytes = good.clone();
        bytes[at] = value;
        bytes
    };
    assert_eq!(Image::from_bytes(b"MZ\x90\0"), Err(ImageError::NotAnImage));
    assert_eq!(Image::from_bytes(&changed(4, 2)), Err(ImageError::NewerVersion { found: 2, newest: VERSION }));
    let mut longer = good.clone();
    longer.extend_from_slice(b"\r\n");
    assert_eq!(Image::from_bytes(&longer), Err(ImageError::TrailingBytes { extra: 2 }));
    let last = good.len() - 1;
    assert!(matches!(Image::from_bytes(&changed(last, good[last] ^ 1)), Err(ImageError::Altered { .. })));
    let mut flags = changed(6, 0x80);
    seal(&mut flags);
    assert_eq!(Image::from_bytes(&flags), Err(ImageError::UnknownHeader { what: "flags", value: 0x80 }));
    let mut budget = changed(16, 9);
    seal(&mut budget);
    assert!(matches!(Image::from_bytes(&budget), Err(ImageError::Malformed(_))));
}

#[test]
fn references_between_units_are_checked() {
    let mut missing_program = sample();
    missing_program.programs.clear();
    assert_eq!(
        missing_program.verify(),
        Err(ImageError::Word {
            unit: UnitName::Boot,
            address: 0,
            problem: Problem::NoSuchProgram { index: 0, programs: 0 }
        })
    );
    let print = Instruction {
        address: 0,
        separator: Separator::Line,
        command: command::PRINT,
        items: vec![Node::Alias { index: 4, parens: 0 }.into()],
    };
    assert_eq!(
        image(&[print]).verify(),
        Err(ImageError::Word {
            unit: UnitName::Program(0),
            address: 0,
            problem: Problem::NoSuchAlias { index: 4, aliases: 4 }
        })
    );
    let mut alias_of_alias = sample();
    alias_of_alias.aliases[0].target = Node::Alias { index: 1, parens: 0 };
    assert!(matches!(alias_of_alias.verify(), Err(ImageError::AliasTarget { .. })));
}

#[test]
fn a_stripped_image_does_not_lead_back_to_the_source() {
    let mut image = sample();
    let full = image.to_bytes().expect("small enough");
    image.strip();
    let stripped = image.to_bytes().expect("small enough");
    assert!(stripped.len() < full.len());
    assert!(!stripped.windows(8).any(|window| window == b"Prog0.8K"));
    assert_eq!(Image::from_bytes(&stripped).expect("valid"), image);
}

#[test]
fn a_word_leads_to_its_statement() {
    let image = sample();
    let map = image.boot.debug.expect("located");
    assert_eq!(map.locate(1).map(|location| location.line), Some(2));
    assert_eq!(map.locate(0).map(|location| (location.span.start, location.span.end)), Some((6, 13)));
}
