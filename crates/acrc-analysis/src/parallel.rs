//! Work on the files of a project with several threads. Each thread reads a snapshot of the database; what one computes,
//! all of them, and the database itself, remember.

use std::num::NonZeroUsize;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use crate::query::{effects, exports};
use crate::{Database, Project, SourceFile};

/// Files that are not worth a thread of their own.
const FILES_A_THREAD: usize = 4;

/// Reads the files of a project, as many at a time as the machine has processors. Questions about the whole project ask
/// one file after another, so this comes first when there are many files that nobody has read yet.
pub fn read_all(db: &Database, project: Project) {
    for_each(db, project.files(db), |db, file| {
        exports(db, file);
        effects(db, file);
    });
}

/// Does `work` for each file, in any order and with several threads.
pub fn for_each(db: &Database, files: &[SourceFile], work: impl Fn(&Database, SourceFile) + Sync) {
    let processors = thread::available_parallelism().map_or(1, NonZeroUsize::get);
    let threads = processors.min(files.len() / FILES_A_THREAD);
    if threads < 2 {
        for file in files {
            work(db, *file);
        }
        return;
    }
    let next = AtomicUsize::new(0);
    thread::scope(|scope| {
        for _ in 0..threads {
            let snapshot = db.clone();
            scope.spawn(|| {
                let snapshot = snapshot;
                while let Some(file) = files.get(next.fetch_add(1, Ordering::Relaxed)) {
                    work(&snapshot, *file);
                }
            });
        }
    });
}
