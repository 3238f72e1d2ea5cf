//! What the last dry run of each project came to.

use std::collections::BTreeMap;
use std::hash::{Hash as _, Hasher as _};
use std::io;
use std::sync::Arc;

use acrc_syntax::units::Level;
use camino::{Utf8Path, Utf8PathBuf};
use parking_lot::Mutex;
use rustc_hash::FxHasher;
use serde_json::Value;

use crate::scratch::Scratch;

/// The last dry runs of the session, by project.
#[derive(Clone)]
pub(crate) struct Outcomes {
    runs: Arc<Mutex<BTreeMap<Utf8PathBuf, Arc<Run>>>>,
    scratch: Scratch,
}

impl Outcomes {
    /// None yet; their pages go to `scratch`.
    pub(crate) fn new(scratch: Scratch) -> Self {
        Self { runs: Arc::default(), scratch }
    }

    /// The last dry run of a project.
    pub(crate) fn of(&self, project: &Utf8Path) -> Option<Arc<Run>> {
        self.runs.lock().get(project).cloned()
    }

    pub(super) fn remember(&self, project: &Utf8Path, run: Run) {
        self.runs.lock().insert(project.to_owned(), Arc::new(run));
    }

    /// Where the page of a project goes.
    pub(super) fn page(&self, project: &Utf8Path) -> io::Result<Utf8PathBuf> {
        // Projects of different folders may have one name.
        let mut hasher = FxHasher::default();
        project.hash(&mut hasher);
        let name = format!("run-{}-{:08x}.html", project.file_stem().unwrap_or("project"), hasher.finish() as u32);
        let path = Utf8PathBuf::from_path_buf(self.scratch.folder()?.join(name));
        path.map_err(|path| io::Error::new(io::ErrorKind::InvalidData, format!("{} is not UTF-8", path.display())))
    }
}

/// The report of a dry run.
pub(crate) struct Run {
    report: Value,
    page: Utf8PathBuf,
}

impl Run {
    pub(super) fn new(report: Value, page: Utf8PathBuf) -> Self {
        Self { report, page }
    }

    pub(super) fn page(&self) -> &Utf8Path {
        &self.page
    }

    /// How a program ended; `None` when the run knew nothing of it.
    pub(crate) fn outcome(&self, level: Level) -> Option<String> {
        let name = level.to_string();
        let of_program = |list: &str| {
            let all = self.report.get(list)?.as_array()?;
            all.iter().find(|item| item["program"] == name.as_str())
        };
        if let Some(fault) = of_program("faults") {
            let line = fault["line"].as_u64().map(|line| format!(" in line {line}")).unwrap_or_default();
            return Some(format!("Last run: {}{line}", fault["message"].as_str()?));
        }
        let program = of_program("programs")?;
        let state = program["state"].as_str()?;
        Some(format!("Last run: {state} after {} statements", program["statements"]))
    }

    /// What a parameter or flag was at the end.
    pub(crate) fn value(&self, name: &str) -> Option<String> {
        match self.report.get("values")?.get(name)? {
            Value::Null => None,
            Value::Number(number) => number.as_f64().map(|number| number.to_string()),
            Value::String(text) => Some(text.clone()),
            other => Some(other.to_string()),
        }
    }

    /// The run in a line.
    pub(super) fn summary(&self) -> String {
        let faults = self.report["faults"].as_array().map_or(0, Vec::len);
        let seconds = self.report["virtual_seconds"].as_f64().unwrap_or_default();
        let stopped = self.report["stopped"].as_str().unwrap_or_default();
        match faults {
            0 => format!("{seconds:.3} s of virtual time, {stopped}"),
            1 => format!("{seconds:.3} s of virtual time, {stopped}, a run-time error"),
            _ => format!("{seconds:.3} s of virtual time, {stopped}, {faults} run-time errors"),
        }
    }
}
