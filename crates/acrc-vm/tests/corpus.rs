//! The guide's own programs: every one that compiles loads and runs. They are read where they lie, and skipped when
//! they are not there.

mod support;

use std::path::PathBuf;

use acrc_compile::{SourceUnit, compile};
use acrc_image::Image;
use acrc_syntax::units::Level;
use acrc_vm::{Budget, Code, Frame, Locals, Stop, Value, run};
use support::{Bench, MEMORY, Machine};

/// The folder of the guide's programs.
fn corpus() -> Option<PathBuf> {
    let default = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/corpus");
    let root = std::env::var_os("ACRC_CORPUS").map_or_else(|| PathBuf::from(default), PathBuf::from);
    let guide = root.join("guide");
    if guide.is_dir() {
        return Some(guide);
    }
    eprintln!("skipped: {} is not there", guide.display());
    None
}

/// A program of the guide, if it compiles.
fn image_of(text: &str) -> Option<Image> {
    let tree = acrc_syntax::parse(text);
    let file = SourceUnit { name: "guide", text, tree: &tree, start: Level::Program(0), implicit_program: false };
    compile(&[file], "ACR9000").ok()
}

/// The stored program of one listing.
fn stored(name: &str) -> Option<Code> {
    let text = std::fs::read_to_string(corpus()?.join(name)).expect("a listing of the corpus");
    let image = image_of(&text).expect("the listing compiles");
    let program = image.programs.last().expect("the listing has a stored program");
    Some(Code::load(program, &image.aliases).expect("the listing loads"))
}

#[test]
fn every_listing_that_compiles_loads_and_runs() {
    let Some(folder) = corpus() else { return };
    let mut names: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    names.sort();
    let mut loaded = 0;
    for path in names.iter().filter(|path| path.extension().is_some_and(|extension| extension == "8K")) {
        let text = String::from_utf8_lossy(&std::fs::read(path).unwrap()).into_owned();
        let Some(image) = image_of(&text) else { continue };
        for unit in image.units() {
            let code = Code::load(unit, &image.aliases).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
            let mut bench = Bench { keys: (b'A'..=b'Z').collect(), ..Bench::default() };
            let stopped =
                run(&code, &mut Frame::new(), &mut Locals::new(MEMORY), &mut bench, Budget::statements(20_000));
            assert!(stopped.statements <= 20_000);
            loaded += 1;
        }
    }
    assert!(loaded > 60, "only {loaded} units");
}

#[test]
fn the_random_loop_counts_its_draws() {
    let Some(code) = stored("27-random-loop.8K") else { return };
    let mut machine = Machine::with(code);
    assert_eq!(machine.finish(), Stop::Ended);
    let count = machine.bench.output.strip_prefix("Done in").and_then(|rest| rest.strip_suffix("tries\r\n"));
    assert!(count.is_some_and(|count| count.parse::<u32>().is_ok()), "{}", machine.bench.output);
}

#[test]
fn the_error_handler_tells_days_from_milliseconds() {
    let Some(code) = stored("65-error-handling.8K") else { return };
    let mut machine = Machine::with(code);
    // A fault of axis 0 and the clock at one of each unit.
    machine.bench.parameters.insert(6916, Value::Long(90_061_001));
    machine.bench.bits.extend([8467, 16132]);
    assert_eq!(machine.run(Budget::statements(2_000)).stop, Stop::Budget);
    let expected = "Approximate Time Running : 1 Days  1 Hours  1 Minutes  1. 1 Seconds \r\n";
    assert!(machine.bench.output.starts_with(expected), "{}", machine.bench.output);
    assert!(machine.bench.output.contains("Axis 0 Error "), "{}", machine.bench.output);
}
