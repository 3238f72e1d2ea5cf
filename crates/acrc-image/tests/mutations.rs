//! Images that were changed so that their checksum and their header are right again: whatever the verifier lets through can be used, and nothing
//! makes it panic.

mod common;

use std::fs;
use std::path::{Path, PathBuf};

use acrc_catalog::OperandClass;
use acrc_image::dump::dump;
use acrc_image::list::{ListOptions, lines, list, list_annotated};
use acrc_image::{Alias, Image, Node, UnitName, VERSION, encode};
use common::instructions;
use proptest::prelude::*;
use proptest::sample::Index;

/// The golden images: one for each construct.
fn golden() -> Vec<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/golden/v{VERSION}"));
    let mut paths: Vec<PathBuf> =
        fs::read_dir(folder).expect("readable").map(|entry| entry.expect("readable").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "acrx"));
    paths.sort();
    paths.iter().map(|path| fs::read(path).expect("readable")).collect()
}

/// Writes the right length and checksum into a changed file.
fn seal(bytes: &mut [u8]) {
    let length = (bytes.len() as u32).to_le_bytes();
    bytes[8..12].copy_from_slice(&length);
    let mut hasher = crc32fast::Hasher::new();
    hasher.update(&bytes[..12]);
    hasher.update(&bytes[16..]);
    bytes[12..16].copy_from_slice(&hasher.finalize().to_le_bytes());
}

/// Uses everything of an image that the verifier let through.
fn use_all(image: &Image) {
    image.password().expect("verified");
    assert_eq!(image.offsets().expect("read from a file").len(), 1 + image.programs.len());
    for unit in image.units() {
        for line_numbers in [false, true] {
            let options = ListOptions { line_numbers };
            list(unit, &image.aliases, &options).expect("verified");
            list_annotated(unit, &image.aliases, &options).expect("verified");
        }
        dump(unit).expect("verified");
        let instructions = unit.decode().expect("verified");
        assert!(lines(&instructions).all(|line| (line.address as usize) < unit.words.len()));
        assert!(unit.labels().expect("verified").iter().all(|label| (label.address as usize) < unit.words.len()));
        let again = encode(unit.name, &instructions).expect("verified");
        assert_eq!((&again.words, &again.strings), (&unit.words, &unit.strings));
    }
}

/// A change of the words or the pool of a unit, whose places are taken modulo their number.
#[derive(Clone, Debug)]
enum Change {
    Flip(Index, u32),
    Set(Index, u32),
    Copy(Index, Index),
    Insert(Index, u32),
    Remove(Index),
    Cut(Index),
    Character(Index, u8),
    Pool(Vec<u8>),
    NoPool,
}

fn change() -> impl Strategy<Value = Change> {
    let place = any::<Index>;
    prop_oneof![
        6 => (place(), 0..32_u32).prop_map(|(place, bit)| Change::Flip(place, bit)),
        2 => (place(), any::<u32>()).prop_map(|(place, word)| Change::Set(place, word)),
        2 => (place(), place()).prop_map(|(from, to)| Change::Copy(from, to)),
        1 => (place(), 0..64_u32).prop_map(|(place, word)| Change::Insert(place, word)),
        1 => place().prop_map(Change::Remove),
        1 => place().prop_map(Change::Cut),
        1 => (place(), any::<u8>()).prop_map(|(place, byte)| Change::Character(place, byte)),
        1 => proptest::collection::vec(any::<u8>(), 0..8).prop_map(Change::Pool),
        1 => Just(Change::NoPool),
    ]
}

fn apply(change: &Change, words: &mut Vec<u32>, pool: &mut Vec<u8>) {
    if words.is_empty() {
        return;
    }
    let count = words.len();
    match change {
        Change::Flip(place, bit) => words[place.index(count)] ^= 1 << bit,
        Change::Set(place, word) => words[place.index(count)] = *word,
        Change::Copy(from, to) => words[to.index(count)] = words[from.index(count)],
        Change::Insert(place, word) => words.insert(place.index(count), *word),
        Change::Remove(place) => {
            words.remove(place.index(count));
        }
        Change::Cut(place) => words.truncate(place.index(count)),
        Change::Character(place, byte) => {
            if !pool.is_empty() {
                let place = place.index(pool.len());
                pool[place] = *byte;
            }
        }
        Change::Pool(bytes) => pool.extend_from_slice(bytes),
        Change::NoPool => pool.clear(),
    }
}

fn with_unit(unit: acrc_image::Unit) -> Image {
    let alias = |number| Alias { name: format!("Alias{number}"), target: Node::scalar(OperandClass::Bit, number) };
    let boot = encode(UnitName::Boot, &[]).expect("an empty unit");
    Image {
        model: "ACR9000".to_owned(),
        aliases: (0..4).map(alias).collect(),
        boot,
        programs: vec![unit],
        files: Vec::new(),
        version: VERSION,
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 512, ..ProptestConfig::default() })]

    #[test]
    fn changed_units_are_refused_or_can_be_used(instructions in instructions(), changes in proptest::collection::vec(change(), 1..4)) {
        let mut unit = encode(UnitName::Program(0), &instructions).expect("generated statements are valid");
        for change in &changes {
            apply(change, &mut unit.words, &mut unit.strings);
        }
        let bytes = with_unit(unit).to_bytes().expect("small");
        if let Ok(image) = Image::from_bytes(&bytes) {
            use_all(&image);
        }
    }

    #[test]
    fn changed_units_of_all_constructs_are_refused_or_can_be_used(which in any::<Index>(), unit in any::<Index>(), changes in proptest::collection::vec(change(), 1..3)) {
        let files = golden();
        let mut image = Image::from_bytes(&files[which.index(files.len())]).expect("golden images are valid");
        let place = unit.index(1 + image.programs.len());
        let unit = if place == 0 { &mut image.boot } else { &mut image.programs[place - 1] };
        for change in &changes {
            apply(change, &mut unit.words, &mut unit.strings);
        }
        if let Ok(image) = Image::from_bytes(&image.to_bytes().expect("small")) {
            use_all(&image);
        }
    }

    #[test]
    fn changed_files_under_a_right_checksum_are_refused_or_can_be_used(which in any::<Index>(), changes in proptest::collection::vec((any::<Index>(), any::<u8>()), 1..4), cut in proptest::option::of(any::<Index>())) {
        let files = golden();
        let mut bytes = files[which.index(files.len())].clone();
        for (place, value) in changes {
            let place = 16 + place.index(bytes.len() - 16);
            bytes[place] = value;
        }
        if let Some(cut) = cut {
            bytes.truncate(16 + cut.index(bytes.len() - 16));
        }
        seal(&mut bytes);
        if let Ok(image) = Image::from_bytes(&bytes) {
            use_all(&image);
        }
    }
}
