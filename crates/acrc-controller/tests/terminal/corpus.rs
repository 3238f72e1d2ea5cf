//! The documents' own sessions, in place, when their folder is there.

use std::path::{Path, PathBuf};

use acrc_controller::State;

use crate::support::{Desk, TWO_AXES};

/// A session, what is typed before it at the prompt of program 0, and the first statement that is not simulated.
const SESSIONS: [(&str, &[&str], Option<&str>); 8] = [
    ("01-run-application", &["PROGRAM", "DWL 5", "ENDP", "PROG1", "PROGRAM", "DWL 5", "ENDP", "SYS"], None),
    ("02-report-acc", &["ACC 10000"], None),
    ("03-report-fbvel", &["FBVEL X 0.0001 Y 0.0002"], None),
    ("04-kill-all-motion", &[], Some("JOG FWD")),
    ("05-numbered-line", &["PROGRAM", "VEL 1", "VEL 2", "ENDP", "SET 5651"], None),
    ("06-feedrate-override", &["X1000"], None),
    ("08-pass-through", &[], Some("DTALK X")),
    ("09-troubleshooting-queries", &["VEL 10", "JOG VEL X25 Y50"], None),
];

/// The folder of a kind of files.
fn folder(kind: &str) -> Option<PathBuf> {
    let beside = || Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/corpus");
    let corpus = std::env::var_os("ACRC_CORPUS").map_or_else(beside, PathBuf::from);
    let folder = corpus.join(kind);
    if folder.is_dir() {
        return Some(folder);
    }
    println!("the corpus is not there: nothing is compared");
    None
}

/// What a session sends, one line each.
fn sent(name: &str) -> Option<Vec<String>> {
    let text = std::fs::read_to_string(folder("terminal")?.join(name)).expect("a session of the corpus");
    Some(text.lines().filter_map(|line| line.strip_prefix("> ")).map(str::to_owned).collect())
}

#[test]
fn sessions_of_the_guide() {
    let Some(folder) = folder("terminal") else { return };
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

#[test]
fn both_programs_of_the_application_run() {
    let Some(lines) = sent("01-run-application.txt") else { return };
    let mut desk = Desk::with("PROG0\nPROGRAM\nDWL 5\nENDP\nPROG1\nPROGRAM\nDWL 5\nENDP\n");
    for line in lines {
        assert_eq!(desk.ask(&line), "", "{line}");
    }
    desk.wait(0.1);
    assert_eq!(desk.controller.programs().iter().filter(|program| program.state == State::Waiting).count(), 2);
}

/// The square, its positions read while the feed is held, as the text around the session has it.
#[test]
fn a_square_is_held_and_goes_on() {
    let (Some(lines), Some(guide)) = (sent("07-square-session.txt"), folder("guide")) else { return };
    let square = std::fs::read_to_string(guide.join("25-square.8K")).expect("a program of the corpus");
    let mut desk = Desk::with(&format!("{TWO_AXES}PROGRAM\n{square}"));
    desk.send("PROG0\r");
    let [listen, hold, start, queries @ ..] = &lines[..] else { panic!("{lines:?}") };
    assert_eq!(desk.send(&format!("{listen}\r")), format!("{listen}\r\n"));
    // Within the first side, which takes 1.1 seconds.
    desk.wait(0.5);
    assert!(desk.send("\u{1b}").ends_with("P00>"));
    assert_eq!(desk.ask(hold), "");
    desk.wait(0.5);
    let held: Vec<String> = queries.iter().map(|line| desk.ask(line)).collect();
    desk.wait(1.0);
    assert_eq!(queries.iter().map(|line| desk.ask(line)).collect::<Vec<_>>(), held);
    assert!(["2\r\n", "3\r\n"].contains(&held[0].as_str()) && held[1] == "0\r\n", "{held:?}");
    assert_eq!(desk.ask(start), "");
    desk.wait(2.0);
    assert_ne!(queries.iter().map(|line| desk.ask(line)).collect::<Vec<_>>(), held);
}
