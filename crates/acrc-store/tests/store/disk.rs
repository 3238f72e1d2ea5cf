//! A state on a real disk.

use acrc_controller::nonvolatile::Saved;
use acrc_store::{Store, StoreError};

use crate::support::{full, numbered};

#[test]
fn a_new_folder_has_no_state_and_what_is_saved_is_there_afterwards() {
    let bench = tempfile::tempdir().expect("a folder");
    let folder = bench.path().join("a/b");
    let mut store = Store::open(&folder).expect("a new folder");
    assert_eq!(store.load().expect("nothing wrong"), None);
    for saved in [numbered(1), full(), numbered(2), Saved::default()] {
        store.save(&saved).expect("room");
        assert_eq!(store.load().expect("saved"), Some(saved));
    }
    drop(store);
    let mut names: Vec<_> =
        std::fs::read_dir(&folder).expect("there").map(|entry| entry.expect("there").file_name()).collect();
    names.sort();
    assert_eq!(names, ["lock", "state-00000003.acrs", "state-00000004.acrs"]);
    let mut store = Store::open(&folder).expect("still there");
    assert_eq!(store.load().expect("saved"), Some(Saved::default()));
    store.reset().expect("removed");
    assert_eq!((store.load().expect("nothing"), store.newest()), (None, None));
}

#[test]
fn two_cannot_have_it_at_once() {
    let folder = tempfile::tempdir().expect("a folder");
    let store = Store::open(folder.path()).expect("free");
    assert!(matches!(Store::open(folder.path()), Err(StoreError::InUse(_))));
    drop(store);
    Store::open(folder.path()).expect("free again");
}

#[test]
fn the_folder_of_something_else_is_left_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("thesis.txt"), "1").expect("room");
    let refused = Store::open(folder.path()).expect_err("refused").to_string();
    assert!(
        refused.ends_with(
            "holds thesis.txt, so it is no folder of a controller's state: name an empty folder or a new one"
        ),
        "{refused}"
    );
    assert_eq!(std::fs::read_dir(folder.path()).expect("there").count(), 1);
    let refused = Store::open(&folder.path().join("thesis.txt")).expect_err("refused").to_string();
    assert!(refused.ends_with("thesis.txt: not a directory"), "{refused}");
}

#[test]
fn a_damaged_state_is_refused_and_names_the_one_before() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut store = Store::open(folder.path()).expect("free");
    store.save(&numbered(1)).expect("room");
    store.save(&numbered(2)).expect("room");
    let newest = store.newest().expect("there");
    std::fs::write(&newest, "acrc-state 1 crc32=00000000 bytes=3\nabc").expect("room");
    let refused = store.load().expect_err("refused").to_string();
    assert!(refused.contains("state-00000002.acrs cannot be used: it was altered"), "{refused}");
    assert!(refused.contains("state-00000001.acrs)"), "{refused}");
    drop(store);
    std::fs::remove_file(newest).expect("there");
    let mut store = Store::open(folder.path()).expect("free");
    assert_eq!(store.load().expect("intact"), Some(numbered(1)));
}
