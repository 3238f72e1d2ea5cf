//! Opens pages in a headless Chromium.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use tempfile::TempDir;

/// Programs that are Chromium, by name.
const NAMES: [&str; 3] = ["chromium", "chromium-browser", "google-chrome"];

/// A headless Chromium.
pub(crate) struct Browser {
    program: PathBuf,
    profile: TempDir,
}

impl Browser {
    /// The browser that is installed: `CHROMIUM`, or one of the usual names. Where there is none, a test has to be left out, which it says; on a CI server
    /// (`CI=true`), that is a failure.
    pub(crate) fn find() -> Option<Self> {
        let path = std::env::var_os("PATH").unwrap_or_default();
        let installed = std::env::split_paths(&path).flat_map(|folder| NAMES.map(|name| folder.join(name)));
        let program = std::env::var_os("CHROMIUM")
            .map(PathBuf::from)
            .or_else(|| installed.into_iter().find(|file| file.is_file()));
        let Some(program) = program else {
            let on_server = std::env::var("CI").is_ok_and(|value| value == "true");
            assert!(!on_server, "no Chromium is installed, and on a CI server the page has to be tested in one");
            eprintln!("no Chromium is installed: the page is not tested here");
            return None;
        };
        Some(Self { program, profile: TempDir::new().expect("a temporary folder") })
    }

    /// The document of a page after its script has run. `address` is what follows the path: `#at=2`.
    pub(crate) fn dom(&self, page: &Path, address: &str) -> String {
        let url = format!("file://{}{address}", page.display());
        let flags = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run"];
        let mut command = Command::new(&self.program);
        command.args(flags).arg(format!("--user-data-dir={}", self.profile.path().display()));
        command.args(["--window-size=1400,1000", "--virtual-time-budget=5000", "--dump-dom"]).arg(url);
        let output = command.stdin(Stdio::null()).output().expect("Chromium starts");
        let dom = String::from_utf8(output.stdout).expect("a document in UTF-8");
        assert!(dom.contains("</html>"), "{}", String::from_utf8_lossy(&output.stderr));
        dom
    }
}
