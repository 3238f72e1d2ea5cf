//! Storms of edits and questions: whatever was typed, in the end a server answers like one that was just started with
//! the same texts.

use std::fs;
use std::path::Path;

use proptest::prelude::*;
use serde_json::{Value, json};
use tempfile::TempDir;

use crate::session::{Session, able, connect, edit};

/// A project whose files hang on each other, with characters of every width.
const FILES: [(&str, &str); 3] = [
    (
        "Setup.8K",
        "SYS\nDIM PROG0(9000)\nDIM DEF(9)\n#DEFINE Lamp BIT32 ' Lämpchen\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\n",
    ),
    (
        "Prog0.8K",
        "PROGRAM\n' \u{1f600} caf\u{e9} \u{20ac}\n_Start\nSET Lamp : X10\nGOSUB Work\nGOTO Start\n_Work\nP0 = P0 + 1\r\nRETURN\nENDP\n",
    ),
    ("Prog1.8K", "PROGRAM\nDIM LV(2)\nIF (Lamp)\nLV0 = 3\nENDIF\nPRINT \"\u{e4}\u{1f600}\"; LV0\nENDP"),
];

/// Pieces that break, mend and move code.
const PIECES: [&str; 20] = [
    "",
    "\n",
    "\r\n",
    "\r",
    " ",
    "X",
    "\"",
    "'",
    "_Work\n",
    "GOTO Nowhere\n",
    "PROGRAM\n",
    "ENDP\n",
    "IF (",
    "ENDIF\n",
    "Lamp",
    "#DEFINE Other P5\n",
    "\u{1f600}",
    "\u{e9}\u{20ac}",
    "SYS\n",
    "(((",
];

/// What clients ask while somebody types.
const QUESTIONS: [&str; 8] = [
    "textDocument/hover",
    "textDocument/completion",
    "textDocument/documentSymbol",
    "textDocument/semanticTokens/full",
    "textDocument/diagnostic",
    "textDocument/references",
    "textDocument/foldingRange",
    "textDocument/signatureHelp",
];

#[derive(Clone, Debug)]
struct Change {
    start: (u32, u32),
    /// Lines and columns beyond the start.
    more: (u32, u32),
    text: &'static str,
}

#[derive(Clone, Debug)]
enum Deed {
    Edit(usize, Vec<Change>),
    Replace(usize, &'static str),
    Ask(usize, usize, (u32, u32), bool),
    Reopen(usize),
}

fn deed() -> impl Strategy<Value = Deed> {
    let file = 0..FILES.len();
    let place = || (0u32..12, 0u32..14);
    let change = (place(), (0u32..2, 0u32..6), prop::sample::select(&PIECES[..]))
        .prop_map(|(start, more, text)| Change { start, more, text });
    prop_oneof![
        6 => (file.clone(), prop::collection::vec(change, 1..4)).prop_map(|(file, changes)| Deed::Edit(file, changes)),
        1 => (file.clone(), prop::sample::select(&PIECES[..])).prop_map(|(file, text)| Deed::Replace(file, text)),
        4 => (file.clone(), 0..QUESTIONS.len(), place(), any::<bool>())
            .prop_map(|(file, question, at, cancel)| Deed::Ask(file, question, at, cancel)),
        1 => file.prop_map(Deed::Reopen),
    ]
}

/// A project on disk, and what an editor has of it.
struct Place {
    folder: TempDir,
    texts: Vec<String>,
    version: i32,
}

impl Place {
    fn new() -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        for (name, text) in FILES {
            fs::write(folder.path().join(name), text).expect("written");
        }
        Self { folder, texts: FILES.map(|(_, text)| text.to_owned()).to_vec(), version: 1 }
    }

    fn uri(&self, file: usize) -> String {
        let root: &Path = self.folder.path();
        format!("file://{}/{}", root.canonicalize().expect("the folder is there").display(), FILES[file].0)
    }

    /// A session that has these texts open.
    fn open(&self, pulls: bool) -> Session {
        let mut session = connect().0;
        let mut able = able();
        // Each session has pages of its own.
        able["textDocument"]["publishDiagnostics"]["codeDescriptionSupport"] = json!(false);
        if pulls {
            able["textDocument"]["diagnostic"] = json!({});
        }
        session.initialize(able, None);
        for (file, text) in self.texts.iter().enumerate() {
            session.open(&self.uri(file), text);
        }
        session
    }

    /// Does something; the identifier of a question.
    fn act(&mut self, session: &mut Session, deed: &Deed) -> Option<i64> {
        self.version += 1;
        match deed {
            Deed::Edit(file, changes) => {
                let mut list = Vec::new();
                for Change { start, more, text } in changes {
                    let end = if more.0 > 0 { (start.0 + more.0, more.1) } else { (start.0, start.1 + more.1) };
                    list.push(edit(*start, end, text));
                    let (from, to) = (offset(&self.texts[*file], *start), offset(&self.texts[*file], end));
                    self.texts[*file].replace_range(from..to, text);
                }
                session.change(&self.uri(*file), self.version, json!(list));
            }
            Deed::Replace(file, text) => {
                (*text).clone_into(&mut self.texts[*file]);
                session.change(&self.uri(*file), self.version, json!([{ "text": text }]));
            }
            Deed::Reopen(file) => {
                let uri = self.uri(*file);
                session.notify("textDocument/didClose", json!({ "textDocument": { "uri": uri } }));
                session.open(&uri, &self.texts[*file]);
            }
            Deed::Ask(file, question, at, cancel) => {
                let id = session.ask(QUESTIONS[*question], question_at(&self.uri(*file), *at));
                if *cancel {
                    session.notify("$/cancelRequest", json!({ "id": id }));
                }
                return Some(id);
            }
        }
        None
    }

    /// What a session says of the texts.
    fn answers(&self, session: &mut Session) -> Vec<Value> {
        let mut answers = Vec::new();
        for file in 0..FILES.len() {
            let uri = self.uri(file);
            let mut found = session.request("textDocument/diagnostic", question_at(&uri, (0, 0)));
            answers.push(found["items"].take());
            let mut tokens = session.request("textDocument/semanticTokens/full", question_at(&uri, (0, 0)));
            answers.push(tokens["data"].take());
            answers.push(session.request("textDocument/documentSymbol", question_at(&uri, (0, 0))));
            answers.push(session.request("textDocument/foldingRange", question_at(&uri, (0, 0))));
            for line in 0..8 {
                for column in [0, 4, 7] {
                    answers.push(session.request("textDocument/hover", question_at(&uri, (line, column))));
                }
                answers.push(session.request("textDocument/references", question_at(&uri, (line, 5))));
                answers.push(session.request("textDocument/completion", question_at(&uri, (line, 3))));
            }
        }
        answers
    }
}

fn question_at(uri: &str, (line, character): (u32, u32)) -> Value {
    json!({
        "textDocument": { "uri": uri }, "position": { "line": line, "character": character },
        "context": { "includeDeclaration": true, "triggerKind": 1, "isRetrigger": false }
    })
}

/// The offset of a position in UTF-16 units, worked out character by character.
fn offset(text: &str, (line, column): (u32, u32)) -> usize {
    let mut at = (0, 0);
    let mut characters = text.char_indices().peekable();
    while let Some((offset, character)) = characters.next() {
        let is_pair = character == '\r' && characters.peek().is_some_and(|(_, next)| *next == '\n');
        if at.0 == line && (at.1 >= column || matches!(character, '\r' | '\n')) {
            return offset;
        }
        let width = character.len_utf16() as u32;
        if at.0 == line && at.1 + width > column {
            return offset;
        }
        at = match character {
            '\n' | '\r' => {
                if is_pair {
                    characters.next();
                }
                (at.0 + 1, 0)
            }
            _ => (at.0, at.1 + width),
        };
    }
    text.len()
}

/// An answer, or an error that says why there is none.
fn is_answer(answer: &Value) -> bool {
    let given_up = [-32800, -32801, -32802].map(Value::from);
    answer.get("error").is_none_or(|error| given_up.contains(&error["code"]))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 32, ..ProptestConfig::default() })]

    #[test]
    fn after_a_storm_all_is_as_in_a_new_session(deeds in prop::collection::vec(deed(), 1..40)) {
        let mut place = Place::new();
        let mut session = place.open(true);
        let asked: Vec<i64> = deeds.iter().filter_map(|deed| place.act(&mut session, deed)).collect();
        for id in asked {
            let answer = session.answer(id);
            prop_assert!(is_answer(&answer), "{}", answer);
        }
        let weathered = place.answers(&mut session);
        let fresh = place.answers(&mut place.open(true));
        for (weathered, fresh) in weathered.iter().zip(&fresh) {
            prop_assert_eq!(weathered, fresh);
        }
    }

    #[test]
    fn what_is_told_after_a_storm_is_what_is_found(deeds in prop::collection::vec(deed(), 1..20)) {
        let mut place = Place::new();
        let mut session = place.open(false);
        for deed in &deeds {
            place.act(&mut session, deed);
        }
        // A last edit of each file, so that each is told of once more.
        for file in 0..FILES.len() {
            place.act(&mut session, &Deed::Edit(file, vec![Change { start: (0, 0), more: (0, 0), text: " " }]));
        }
        let mut fresh = place.open(true);
        let expected: Vec<Value> = (0..FILES.len())
            .map(|file| fresh.request("textDocument/diagnostic", question_at(&place.uri(file), (0, 0)))["items"].take())
            .collect();
        let mut told = vec![Value::Null; FILES.len()];
        // A test that never gets there is ended by its runner.
        while told != expected {
            let said = session.wait_for("textDocument/publishDiagnostics", |_| true);
            if let Some(file) = (0..FILES.len()).find(|file| said["uri"] == place.uri(*file)) {
                told[file] = said["diagnostics"].clone();
            }
        }
    }
}

#[test]
fn two_thousand_edits_arrive_in_order() {
    let mut place = Place::new();
    let mut session = place.open(true);
    let mut expected = String::new();
    session.change(&place.uri(1), 2, json!([{ "text": "" }]));
    for number in 0..2_000 {
        // Each edit is wrong in any other order.
        let line = format!("P{number} = {number}\n");
        session.change(&place.uri(1), number + 3, json!([edit((number as u32, 0), (number as u32, 0), &line)]));
        expected.push_str(&line);
        if number % 50 == 0 {
            session.ask("textDocument/hover", question_at(&place.uri(1), (number as u32, 1)));
        }
    }
    place.texts[1] = expected;
    assert_eq!(place.answers(&mut session), place.answers(&mut place.open(true)));
}
