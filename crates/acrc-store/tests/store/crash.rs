//! A disk that fails and loses power at every step of a save.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use acrc_controller::nonvolatile::Saved;
use acrc_store::{Files, Store};

use crate::support::numbered;

const FOLDER: &str = "/state";

/// Contents of a file: what is surely on the disk, and what was written since.
#[derive(Clone, Debug, Default)]
struct Contents {
    flushed: Vec<u8>,
    written: Vec<u8>,
}

/// A change of names that may or may not have reached the disk.
#[derive(Clone, Debug)]
enum Change {
    Link(PathBuf, usize),
    Rename(PathBuf, PathBuf, usize),
    Unlink(PathBuf),
}

#[derive(Clone, Debug, Default)]
struct Model {
    files: Vec<Contents>,
    /// Names that are surely on the disk.
    names: BTreeMap<PathBuf, usize>,
    pending: Vec<Change>,
    /// Steps until one fails.
    until_failure: Option<usize>,
    /// The failing step is carried out, or half of it, and only then fails.
    late: bool,
    /// After a failure nothing works any more.
    dies: bool,
    dead: bool,
}

#[derive(Clone, Debug, Default)]
struct FailingDisk(Rc<RefCell<Model>>);

fn failure() -> io::Error {
    io::Error::other("failure of the disk")
}

impl Model {
    fn current(&self) -> BTreeMap<PathBuf, usize> {
        let mut names = self.names.clone();
        self.pending.iter().for_each(|change| apply(&mut names, change));
        names
    }

    fn find(&self, path: &Path) -> io::Result<usize> {
        self.current().get(path).copied().ok_or_else(|| io::ErrorKind::NotFound.into())
    }

    /// Carries out a step, unless it is the one that fails. `half` is what a failing step may leave.
    fn step(&mut self, whole: impl FnOnce(&mut Self), half: impl FnOnce(&mut Self)) -> io::Result<()> {
        if self.dead {
            return Err(failure());
        }
        match &mut self.until_failure {
            Some(0) => {
                self.until_failure = None;
                self.dead = self.dies;
                if self.late {
                    half(self);
                }
                return Err(failure());
            }
            Some(steps) => *steps -= 1,
            None => {}
        }
        whole(self);
        Ok(())
    }

    /// Every disk that a loss of power now may leave.
    fn after_power_loss(&self) -> Vec<Self> {
        let mut left = Vec::new();
        for survivors in 0..1_u32 << self.pending.len() {
            let mut names = self.names.clone();
            let kept = self.pending.iter().enumerate().filter(|(place, _)| survivors >> place & 1 == 1);
            kept.for_each(|(_, change)| apply(&mut names, change));
            // Of what was written and not flushed, nothing, half or all is left.
            for share in 0..3 {
                let contents = |file: &Contents| {
                    let flushed = file.written == file.flushed;
                    let bytes = if flushed {
                        file.flushed.clone()
                    } else {
                        file.written[..file.written.len() * share / 2].to_vec()
                    };
                    Contents { flushed: bytes.clone(), written: bytes }
                };
                left.push(Self {
                    files: self.files.iter().map(contents).collect(),
                    names: names.clone(),
                    ..Self::default()
                });
            }
        }
        left
    }
}

fn apply(names: &mut BTreeMap<PathBuf, usize>, change: &Change) {
    match change {
        Change::Link(path, file) => drop(names.insert(path.clone(), *file)),
        Change::Unlink(path) => drop(names.remove(path)),
        Change::Rename(from, to, file) => {
            names.remove(from);
            names.insert(to.clone(), *file);
        }
    }
}

impl Files for FailingDisk {
    fn create_folder(&mut self, _: &Path) -> io::Result<()> {
        Ok(())
    }

    fn names(&mut self, _: &Path) -> io::Result<Vec<String>> {
        let names = self.0.borrow().current();
        Ok(names.keys().filter_map(|path| Some(path.file_name()?.to_str()?.to_owned())).collect())
    }

    fn read(&mut self, path: &Path) -> io::Result<Vec<u8>> {
        let model = self.0.borrow();
        model.find(path).map(|file| model.files[file].written.clone())
    }

    fn write(&mut self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        let put = |model: &mut Model, bytes: &[u8]| {
            let file = model.find(path).unwrap_or_else(|_| {
                model.files.push(Contents::default());
                model.pending.push(Change::Link(path.to_path_buf(), model.files.len() - 1));
                model.files.len() - 1
            });
            model.files[file].written = bytes.to_vec();
        };
        self.0.borrow_mut().step(|model| put(model, bytes), |model| put(model, &bytes[..bytes.len() / 2]))
    }

    fn flush(&mut self, path: &Path) -> io::Result<()> {
        let file = self.0.borrow().find(path)?;
        let flush = |model: &mut Model| model.files[file].flushed = model.files[file].written.clone();
        self.0.borrow_mut().step(flush, flush)
    }

    fn rename(&mut self, from: &Path, to: &Path) -> io::Result<()> {
        let file = self.0.borrow().find(from)?;
        let rename = |model: &mut Model| model.pending.push(Change::Rename(from.to_path_buf(), to.to_path_buf(), file));
        self.0.borrow_mut().step(rename, rename)
    }

    fn flush_folder(&mut self, _: &Path) -> io::Result<()> {
        let flush = |model: &mut Model| {
            model.names = model.current();
            model.pending.clear();
        };
        self.0.borrow_mut().step(flush, flush)
    }

    fn remove(&mut self, path: &Path) -> io::Result<()> {
        let remove = |model: &mut Model| model.pending.push(Change::Unlink(path.to_path_buf()));
        self.0.borrow_mut().step(remove, remove)
    }
}

/// A disk on which the states `1..=count` were saved without failure.
fn disk(count: u32) -> FailingDisk {
    let disk = FailingDisk::default();
    let mut store = Store::with_files(Path::new(FOLDER), disk.clone()).expect("no failure");
    (1..=count).for_each(|number| store.save(&numbered(number)).expect("no failure"));
    disk
}

fn load(disk: &FailingDisk) -> Option<Saved> {
    Store::with_files(Path::new(FOLDER), disk.clone())
        .and_then(|mut store| store.load())
        .expect("what is there can be read")
}

fn state(number: u32) -> Option<Saved> {
    (number > 0).then(|| numbered(number))
}

/// Saves state `count + 1` with a failure at each step in turn, and shows what every failure leaves.
fn at_every_step(count: u32, dies: bool, look: impl Fn(&FailingDisk, bool)) -> usize {
    for steps in 0.. {
        let mut failed = false;
        for late in [false, true] {
            let disk = disk(count);
            {
                let mut model = disk.0.borrow_mut();
                (model.until_failure, model.late, model.dies) = (Some(steps), late, dies);
            }
            let store = Store::with_files(Path::new(FOLDER), disk.clone());
            let saved = store.and_then(|mut store| store.save(&numbered(count + 1))).is_ok();
            failed |= disk.0.borrow().until_failure.is_none();
            disk.0.borrow_mut().until_failure = None;
            look(&disk, saved);
        }
        if !failed {
            return steps;
        }
    }
    unreachable!("a save has an end");
}

#[test]
fn a_loss_of_power_leaves_the_old_state_or_the_new_one() {
    for count in 0..4 {
        let steps = at_every_step(count, true, |disk, saved| {
            for left in disk.0.borrow().after_power_loss() {
                let found = load(&FailingDisk(Rc::new(RefCell::new(left.clone()))));
                let (old, new) = (state(count), state(count + 1));
                assert!(found == new || !saved && found == old, "{saved} {found:?}\n{left:#?}");
            }
        });
        assert_eq!(steps, if count < 2 { 4 } else { 5 }, "write, flush, rename, flush the folder, remove the oldest");
    }
}

#[test]
fn a_loss_of_power_while_the_one_after_it_is_recovered_leaves_one_of_them_too() {
    at_every_step(2, true, |disk, _| {
        for left in disk.0.borrow().after_power_loss() {
            let disk = FailingDisk(Rc::new(RefCell::new(left)));
            let before = load(&disk);
            let mut store = Store::with_files(Path::new(FOLDER), disk.clone()).expect("no failure");
            store.save(&numbered(9)).expect("no failure");
            for left in disk.0.borrow().after_power_loss() {
                let found = load(&FailingDisk(Rc::new(RefCell::new(left))));
                assert!(found == state(9) || found == before, "{found:?}");
            }
        }
    });
}

#[test]
fn a_failure_without_loss_of_power_leaves_one_of_them_and_the_next_save_succeeds() {
    for count in 0..4 {
        at_every_step(count, false, |disk, _| {
            let found = load(disk);
            assert!([state(count), state(count + 1)].contains(&found), "{found:?}");
            let mut store = Store::with_files(Path::new(FOLDER), disk.clone()).expect("the failure is over");
            store.save(&numbered(9)).expect("the failure is over");
            assert_eq!(load(disk), state(9));
        });
    }
}

#[test]
fn a_store_goes_on_after_a_failure() {
    for steps in 0..5 {
        for late in [false, true] {
            let disk = disk(2);
            let mut store = Store::with_files(Path::new(FOLDER), disk.clone()).expect("no failure");
            {
                let mut model = disk.0.borrow_mut();
                (model.until_failure, model.late) = (Some(steps), late);
            }
            let _ = store.save(&numbered(3));
            store.save(&numbered(4)).expect("the failure is over");
            assert_eq!(store.load().expect("saved"), state(4));
            assert_eq!(load(&disk), state(4));
        }
    }
}
