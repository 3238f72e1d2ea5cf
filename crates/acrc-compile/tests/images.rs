//! The golden images of `acrc-image`: their sources still compile to them.
//!
//! `ACRC_GOLDEN=new cargo test -p acrc-compile --test images` writes the images that are missing. One that is there is never written again:
//! it stands for all the images of its version that are in use.

mod common;

use std::fmt::Write as _;
use std::fs::{self, File};
use std::io::Write as _;
use std::path::{Path, PathBuf};

use acrc_image::{Image, VERSION};
use acrc_syntax::units::Level;
use common::{compile_file, listing};

/// The image whose places in the source are kept.
const WITH_PLACES: &str = "places";

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../acrc-image/tests/golden")
}

fn sources() -> Vec<PathBuf> {
    let entries = fs::read_dir(folder()).expect("the folder is part of the project");
    let paths = entries.map(|entry| entry.expect("readable").path());
    let mut sources: Vec<_> =
        paths.filter(|path| path.extension().is_some_and(|extension| extension == "8K")).collect();
    sources.sort();
    sources
}

fn image(name: &str, source: &Path) -> Image {
    let text = fs::read_to_string(source).expect("readable");
    let mut image = compile_file(&text, Level::System, false).unwrap_or_else(|errors| panic!("{name}: {errors:#?}"));
    if name != WITH_PLACES {
        image.strip();
    }
    image
}

/// The listings of all units, as they stand beside the image.
fn listings(image: &Image) -> String {
    let mut out = String::new();
    for unit in image.units() {
        let _ = write!(out, "== {}\n{}", unit.name, listing(unit, image));
    }
    out
}

#[test]
fn every_source_has_its_image() {
    let (mut missing, make) = (Vec::new(), std::env::var_os("ACRC_GOLDEN").is_some_and(|value| value == "new"));
    let versions = folder().join(format!("v{VERSION}"));
    for source in sources() {
        let name = source.file_stem().expect("a name").to_string_lossy().into_owned();
        let image = image(&name, &source);
        let bytes = image.to_bytes().expect("small");
        let path = versions.join(format!("{name}.acrx"));
        if let Ok(stored) = fs::read(&path) {
            assert!(
                stored == bytes,
                "{name} compiles to another image; what is stored must not change within a version"
            );
        } else if make {
            let write = |path: &Path, bytes: &[u8]| File::create_new(path).and_then(|mut file| file.write_all(bytes));
            write(&path, &bytes).expect("writable");
            write(&path.with_extension("list"), listings(&image).as_bytes()).expect("writable");
        } else {
            missing.push(name);
        }
    }
    assert!(missing.is_empty(), "no image of {missing:?} in {}: ACRC_GOLDEN=new makes it", versions.display());
}
