//! Images of all versions that were ever written can be read, verified and listed, and give the text that they were made from.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use acrc_catalog::Shape;
use acrc_image::dump::dump;
use acrc_image::layout::LAYOUTS;
use acrc_image::list::{ListOptions, list};
use acrc_image::{Image, VERSION, encode};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden")
}

/// The images of a version.
fn images(version: u16) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder().join(format!("v{version}"))).expect("each version has its images");
    let paths = entries.map(|entry| entry.expect("readable").path());
    let mut images: Vec<_> =
        paths.filter(|path| path.extension().is_some_and(|extension| extension == "acrx")).collect();
    images.sort();
    images
}

#[test]
fn images_of_every_version_give_their_texts() {
    for version in 1..=VERSION {
        let images = images(version);
        assert!(images.len() >= 30, "version {version} has {} images", images.len());
        for path in images {
            let name = path.display();
            let bytes = fs::read(&path).expect("readable");
            assert_eq!(bytes.get(4..6), Some(&version.to_le_bytes()[..]), "{name}");
            let image = Image::from_bytes(&bytes).unwrap_or_else(|error| panic!("{name}: {error}"));
            let expected = fs::read_to_string(path.with_extension("list")).expect("its text stands beside it");
            let mut listed = String::new();
            for unit in image.units() {
                let text = list(unit, &image.aliases, &ListOptions::default());
                let text = text.unwrap_or_else(|error| panic!("{name}: {error}"));
                listed.extend(["== ", &unit.name.to_string(), "\n", &text]);
                let again = encode(unit.name, &unit.decode().expect("listed before")).expect("decoded before");
                assert_eq!((&again.words, &again.strings), (&unit.words, &unit.strings), "{name}");
                dump(unit).unwrap_or_else(|error| panic!("{name}: {error}"));
            }
            assert_eq!(listed, expected, "{name}");
        }
    }
}

#[test]
fn every_construct_has_an_image() {
    let (mut shapes, mut kinds) = (BTreeSet::new(), BTreeSet::new());
    for path in images(VERSION) {
        let image = Image::from_bytes(&fs::read(&path).expect("readable")).expect("read before");
        for unit in image.units() {
            shapes.extend(unit.decode().expect("verified").iter().map(|statement| statement.command.info().shape));
            let words = dump(unit).expect("verified");
            kinds.extend(LAYOUTS.iter().map(|layout| layout.name).filter(|name| names(&words, name)));
        }
    }
    // A word that needs a daughter is no statement without it.
    let absent: Vec<_> =
        Shape::ALL.iter().filter(|&&shape| shape != Shape::Parent && !shapes.contains(&shape)).collect();
    assert!(absent.is_empty(), "no image with {absent:?}");
    let absent: Vec<_> =
        LAYOUTS.iter().filter(|layout| !kinds.contains(layout.name)).map(|layout| layout.name).collect();
    assert!(absent.is_empty(), "no image with {absent:?}");
}

/// Does a line of a dump name this kind of word?
fn names(dump: &str, kind: &str) -> bool {
    dump.lines().any(|line| line.split_whitespace().nth(2) == Some(kind))
}

#[test]
fn the_newest_version_is_written_to_the_byte() {
    for path in images(VERSION) {
        let bytes = fs::read(&path).expect("readable");
        let image = Image::from_bytes(&bytes).expect("read before");
        assert_eq!(image.to_bytes().expect("small"), bytes, "{}", path.display());
    }
}

#[test]
fn the_images_hold_what_they_are_named_after() {
    let read = |name: &str| {
        let bytes = fs::read(folder().join(format!("v{VERSION}/{name}.acrx"))).expect("readable");
        Image::from_bytes(&bytes).expect("valid")
    };
    assert_eq!(read("password").password().expect("valid").as_deref(), Some("sesame"));
    assert_eq!(read("aliases").aliases.len(), 3);
    assert!(read("places").boot.debug.is_some());
    assert!(read("labels").boot.debug.is_none());
    assert_eq!(read("setup").programs.len(), 3);
}
