//! The folder: generations of the state, and the lock.

use std::fs::{File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};

use acrc_controller::nonvolatile::Saved;

use crate::error::StoreError;
use crate::files::{Disk, Files};
use crate::form::{decode, encode};

/// The version of the file that this crate writes.
pub const VERSION: u32 = 1;

/// File that processes lock; it stays empty.
const LOCK: &str = "lock";
const PREFIX: &str = "state-";
const SUFFIX: &str = ".acrs";
/// Suffix of a state that is being written.
const UNFINISHED: &str = ".new";

/// A folder with the state of a controller, which nobody else can use at the same time.
#[derive(Debug)]
pub struct Store<F = Disk> {
    folder: PathBuf,
    files: F,
    /// Generations there are, by rising number.
    generations: Vec<u64>,
    /// Held until the store is dropped.
    lock: Option<File>,
}

impl Store {
    /// Opens a folder, which is made if there is none.
    ///
    /// # Errors
    /// When the folder cannot be used, another process has it, or it holds anything else.
    pub fn open(folder: &Path) -> Result<Self, StoreError> {
        let mut files = Disk;
        if folder.is_file() {
            return Err(at(folder)(io::ErrorKind::NotADirectory.into()));
        }
        files.create_folder(folder).map_err(at(folder))?;
        // Nothing is put into the folder of something else, not even the lock.
        contents(&mut files, folder)?;
        let path = folder.join(LOCK);
        let lock = File::options().create(true).truncate(false).write(true).open(&path).map_err(at(&path))?;
        match lock.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => return Err(StoreError::InUse(folder.to_path_buf())),
            Err(TryLockError::Error(problem)) => return Err(StoreError::Io { path, problem }),
        }
        let mut store = Self::with_files(folder, files)?;
        store.lock = Some(lock);
        Ok(store)
    }
}

impl<F: Files> Store<F> {
    /// A folder on other files than those of the disk, without a lock.
    ///
    /// # Errors
    /// As for [`Store::open`].
    pub fn with_files(folder: &Path, mut files: F) -> Result<Self, StoreError> {
        files.create_folder(folder).map_err(at(folder))?;
        let Contents { generations, unfinished } = contents(&mut files, folder)?;
        for path in unfinished {
            files.remove(&path).map_err(at(&path))?;
        }
        Ok(Self { folder: folder.to_path_buf(), files, generations, lock: None })
    }

    /// The state; `None` when nothing was saved yet.
    ///
    /// # Errors
    /// When the newest state cannot be read or is not as it was written.
    pub fn load(&mut self) -> Result<Option<Saved>, StoreError> {
        let Some((newest, older)) = self.generations.split_last() else { return Ok(None) };
        let path = self.path(*newest);
        let bytes = self.files.read(&path).map_err(at(&path))?;
        let older = older.last().map(|generation| self.path(*generation));
        decode(&bytes).map(Some).map_err(|problem| StoreError::Damaged { path, problem, older })
    }

    /// Makes a state the newest. When this fails, the state before it is the newest; when only flushing the folder failed, which of the
    /// two a crash leaves is open.
    ///
    /// # Errors
    /// When a file operation fails.
    pub fn save(&mut self, saved: &Saved) -> Result<(), StoreError> {
        let bytes = encode(saved)?;
        let generation = self.generations.last().map_or(Some(1), |newest| newest.checked_add(1));
        let generation = generation.ok_or_else(|| StoreError::Unwritable("the generations are used up".to_owned()))?;
        let path = self.path(generation);
        let unfinished = self.folder.join(file_name(generation, UNFINISHED));
        self.files.write(&unfinished, &bytes).map_err(at(&unfinished))?;
        self.files.flush(&unfinished).map_err(at(&unfinished))?;
        self.files.rename(&unfinished, &path).map_err(at(&path))?;
        self.generations.push(generation);
        self.files.flush_folder(&self.folder).map_err(at(&self.folder))?;
        // The state before this one stays, in case the disk damages this one. What cannot be removed now is tried again by the next save.
        while let [oldest, _, _, ..] = self.generations[..] {
            if self.files.remove(&self.path(oldest)).is_err() {
                break;
            }
            self.generations.remove(0);
        }
        Ok(())
    }

    /// Forgets everything, as a controller that has just been made.
    ///
    /// # Errors
    /// When a file cannot be removed.
    pub fn reset(&mut self) -> Result<(), StoreError> {
        // The oldest first, so that whatever is left when this is interrupted is the newest.
        while let Some(oldest) = self.generations.first() {
            let path = self.path(*oldest);
            self.files.remove(&path).map_err(at(&path))?;
            self.generations.remove(0);
        }
        self.files.flush_folder(&self.folder).map_err(at(&self.folder))
    }

    /// The file of the newest state.
    pub fn newest(&self) -> Option<PathBuf> {
        self.generations.last().map(|generation| self.path(*generation))
    }

    /// The files, to look at them.
    pub fn into_files(self) -> F {
        self.files
    }

    fn path(&self, generation: u64) -> PathBuf {
        self.folder.join(file_name(generation, SUFFIX))
    }
}

/// What a folder holds.
#[derive(Debug, Default)]
struct Contents {
    /// Generations, by rising number.
    generations: Vec<u64>,
    /// What interrupted saves have left.
    unfinished: Vec<PathBuf>,
}

/// Looks into a folder, which may hold nothing but a state.
fn contents<F: Files>(files: &mut F, folder: &Path) -> Result<Contents, StoreError> {
    let mut contents = Contents::default();
    for name in files.names(folder).map_err(at(folder))? {
        if let Some(generation) = generation(&name, SUFFIX) {
            contents.generations.push(generation);
        } else if generation(&name, UNFINISHED).is_some() {
            contents.unfinished.push(folder.join(&name));
        } else if name != LOCK {
            return Err(StoreError::Foreign { folder: folder.to_path_buf(), name });
        }
    }
    contents.generations.sort_unstable();
    Ok(contents)
}

/// The name of a generation's file.
fn file_name(generation: u64, suffix: &str) -> String {
    format!("{PREFIX}{generation:08}{suffix}")
}

/// The generation that a file is.
fn generation(name: &str, suffix: &str) -> Option<u64> {
    let generation = name.strip_prefix(PREFIX)?.strip_suffix(suffix)?.parse().ok()?;
    (file_name(generation, suffix) == name).then_some(generation)
}

fn at(path: &Path) -> impl FnOnce(io::Error) -> StoreError {
    let path = path.to_path_buf();
    move |problem| StoreError::Io { path, problem }
}
