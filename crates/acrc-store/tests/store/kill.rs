//! A process that is killed while it saves.

use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use acrc_store::{Store, StoreError};

use crate::support::numbered;

/// Says to this program that it is the process to be killed, and where it saves.
const FOLDER: &str = "ACRC_STORE_TEST_FOLDER";

/// Not a test by itself: saves one state after another until it is killed.
#[test]
fn saver() {
    let Some(folder) = std::env::var_os(FOLDER).map(PathBuf::from) else { return };
    let mut store = Store::open(&folder).expect("nobody else has it");
    let first =
        store.load().expect("intact").map_or(0, |saved| saved.parameters.map_or(0.0, |saved| saved.period) as u32);
    for number in first + 1.. {
        store.save(&numbered(number)).expect("room");
    }
}

fn start(folder: &Path) -> Child {
    let mut command = Command::new(std::env::current_exe().expect("this program"));
    command.args(["--exact", "kill::saver"]).env(FOLDER, folder);
    command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("it starts")
}

#[test]
fn whoever_is_killed_leaves_a_whole_state_and_no_lock() {
    let bench = tempfile::tempdir().expect("a folder");
    let folder = bench.path().join("state");
    let mut last = 0;
    for round in 0..12 {
        let mut child = start(&folder);
        // It has the lock as soon as it has saved something.
        let saved = |name: String| {
            Path::new(&name).extension().is_some_and(|end| end == "acrs")
                && name.as_str() > format!("state-{last:08}.acrs").as_str()
        };
        let there = || {
            let names = std::fs::read_dir(&folder).into_iter().flatten().flatten();
            names.map(|entry| entry.file_name().to_string_lossy().into_owned()).any(saved)
        };
        while !there() {
            assert_eq!(child.try_wait().expect("a child"), None, "it saves until it is killed");
            std::thread::sleep(Duration::from_millis(1));
        }
        assert!(matches!(Store::open(&folder), Err(StoreError::InUse(_))));
        std::thread::sleep(Duration::from_micros(700 * round));
        child.kill().expect("it runs");
        child.wait().expect("it was killed");

        let found = Store::open(&folder).and_then(|mut store| store.load()).expect("a whole state").expect("a state");
        let number = found.parameters.as_ref().expect("there").period as u32;
        assert_eq!(found, numbered(number));
        assert!(number > last, "{number} after {last}");
        last = number;
    }
}
