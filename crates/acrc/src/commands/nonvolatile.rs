//! What a controller keeps without power (`--state`).

use std::path::{Path, PathBuf};

use acrc_controller::nonvolatile::Saved;
use acrc_store::Store;
use anyhow::Context as _;

/// The folder of `--state`, which is this process' alone until it ends.
pub(crate) struct State {
    folder: PathBuf,
    store: Store,
    /// What was in it when the run began; `None` when nothing was saved yet.
    pub(crate) saved: Option<Saved>,
}

impl State {
    /// Opens the folder and reads what is in it.
    pub(crate) fn open(folder: &Path) -> anyhow::Result<Self> {
        let mut store = Store::open(folder).context("the state cannot be used")?;
        let saved = store.load().context("the state cannot be used")?;
        Ok(Self { folder: folder.to_path_buf(), store, saved })
    }

    /// Saves what the controller keeps from now on.
    pub(crate) fn save(&mut self, saved: &Saved) -> anyhow::Result<()> {
        self.store.save(saved).context("the state was not saved")
    }

    /// Why a controller does not come up.
    pub(crate) fn cannot_power_up(state: Option<&Self>) -> String {
        match state.filter(|state| state.saved.is_some()) {
            Some(state) => format!("the controller cannot be powered up with {}", state.folder.display()),
            None => "the compiled program does not load".to_owned(),
        }
    }
}
