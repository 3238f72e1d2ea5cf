//! The documents' own sessions, in place, when their folder is there.

use std::path::{Path, PathBuf};

use crate::support::{Desk, TWO_AXES};

/// A session, what is typed before it at the prompt of program 0, and the first statement that is not simulated.
const SESSIONS: [(&str, &[&str], Option<&str>); 5] = [
    ("02-report-acc", &["ACC 10000"], None),
    ("03-report-fbvel", &["FBVEL X 0.0001 Y 0.0002"], None),
    ("04-kill-all-motion", &[], Some("JOG FWD")),
    ("05-numbered-line", &["PROGRAM", "VEL 1", "VEL 2", "ENDP", "SET 5651"], None),
    ("06-feedrate-override", &["X1000"], None),
];

fn folder() -> Option<PathBuf> {
    let beside = || Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/corpus");
    let corpus = std::env::var_os("ACRC_CORPUS").map_or_else(beside, PathBuf::from);
    let folder = corpus.join("terminal");
    folder.is_dir().then_some(folder)
}

#[test]
fn sessions_of_the_guide() {
    let Some(folder) = folder() else {
        println!("the corpus is not there: nothing is compared");
        return;
    };
    for (name, before, end) in SESSIONS {
        let text = std::fs::read_to_string(folder.join(name).with_extension("txt")).expect("a session of the corpus");
        let mut desk = Desk::with(TWO_AXES);
        desk.send("PROG0\r");
        for line in before {
            assert_eq!(desk.ask(line), "", "{name}: {line}");
        }
        let mut lines = text.lines().filter(|line| line.starts_with(['>', '<'])).peekable();
        while let Some(sent) = lines.next().and_then(|line| line.strip_prefix("> ")) {
            if end.is_some_and(|end| sent.starts_with(end)) {
                break;
            }
            let mut expected = String::new();
            while let Some(line) = lines.next_if(|line| line.starts_with('<')) {
                expected.push_str(line.trim_start_matches("< "));
                expected.push_str("\r\n");
            }
            let answer = desk.ask(sent);
            // The sessions leave some answers out.
            assert!(answer == expected || expected.is_empty(), "{name}: {sent}: {answer:?}, not {expected:?}");
        }
    }
}
