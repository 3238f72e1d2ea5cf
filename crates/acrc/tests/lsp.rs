//! `acrc lsp` as an editor starts it: a process with pipes.

#[path = "../../acrc-lsp/tests/lsp/client.rs"]
mod client;
#[path = "common/server.rs"]
mod server;

use std::io::BufReader;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use client::Client;
use serde_json::{Value, json};
use server::Server;

type Session = Client<BufReader<ChildStdout>, ChildStdin>;

fn start() -> (Child, Session) {
    let mut child = Command::new(env!("CARGO_BIN_EXE_acrc"))
        .args(["lsp", "--stdio"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the server starts");
    let input = BufReader::new(child.stdout.take().expect("it has an output"));
    let session = Client::new(input, child.stdin.take().expect("it has an input"));
    (child, session)
}

#[test]
fn a_session_from_beginning_to_end() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().canonicalize().expect("a path").join("Prog0.8K");
    let text = "PROGRAM\nP0 = 3\nPRINT \"done\"\nENDP\n";
    std::fs::write(&path, text).expect("written");
    std::fs::write(path.with_file_name("Setup.8K"), "SYS\nDIM P(10)\n").expect("written");
    let uri = format!("file://{}", path.display());
    let (mut child, mut session) = start();
    session.initialize(json!({}), Some(&format!("file://{}", path.parent().expect("a folder").display())));
    session.open(&uri, text);
    session.diagnostics(&uri, 1);

    let run = json!({ "command": "acrc.sim", "arguments": [{ "uri": uri, "program": "PROG0" }] });
    let done = session.request("workspace/executeCommand", run);
    assert_eq!(done["status"], 0, "{done}");
    let lenses = session.request("textDocument/codeLens", json!({ "textDocument": { "uri": uri } }));
    let titles: Vec<&str> =
        lenses.as_array().expect("lenses").iter().filter_map(|lens| lens["command"]["title"].as_str()).collect();
    assert!(titles.iter().any(|title| title.starts_with("Last run: ")), "{titles:?}");
    let range = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 9, "character": 0 } });
    let params = json!({ "textDocument": { "uri": uri }, "range": range,
        "context": { "frameId": 0, "stoppedLocation": range } });
    let values = session.request("textDocument/inlineValue", params);
    assert_eq!(values[0]["text"], "P0 = 3", "{values}");
    let memory = json!({ "command": "acrc.mem", "arguments": [{ "uri": uri }] });
    assert_eq!(session.request("workspace/executeCommand", memory)["status"], 0);

    session.request("shutdown", Value::Null);
    session.notify("exit", Value::Null);
    assert_eq!(child.wait().expect("it ends").code(), Some(0));
}

#[test]
fn nothing_is_sent_to_a_controller_that_nobody_named() {
    let (mut child, mut session) = start();
    session.initialize(json!({}), None);
    session.open("untitled:a", "PROGRAM\nENDP\n");
    let send = json!({ "command": "acrc.download", "arguments": [{ "uri": "untitled:a", "to": "127.0.0.1" }] });
    let id = session.ask("workspace/executeCommand", send);
    assert!(session.answer(id)["error"]["message"].as_str().is_some_and(|why| why.contains("never saved")));
    // The client goes away without a word.
    drop(session);
    assert_eq!(child.wait().expect("it ends").code(), Some(1));
}

#[test]
fn only_what_was_shown_and_confirmed_is_sent() {
    let (folder, controller) = (tempfile::tempdir().expect("a folder"), Server::start());
    let path = folder.path().canonicalize().expect("a path").join("Prog0.8K");
    let text = "PROGRAM\nPRINT \"one\"\nENDP\n";
    std::fs::write(&path, text).expect("written");
    let uri = format!("file://{}", path.display());
    let (mut child, mut session) = start();
    session.initialize(json!({}), None);
    session.open(&uri, text);
    let send = json!({ "command": "acrc.download", "arguments": [{ "uri": uri, "to": controller.address() }] });

    assert!(session.request("workspace/executeCommand", send.clone()).is_null(), "nobody confirmed it");
    let question = session.requests.pop().expect("a question");
    let shown = question["params"]["message"].as_str().expect("a text");
    assert!(shown.contains("sent     5 lines") && !shown.contains("PRINT"), "{shown}");

    let id = session.ask("workspace/executeCommand", send.clone());
    let question =
        std::iter::from_fn(|| session.read()).find(|message| message["method"] == "window/showMessageRequest");
    let edited = text.replace("one", "two");
    session.change(&uri, 2, json!([{ "text": edited }]));
    std::fs::write(&path, edited).expect("written");
    session
        .send(&json!({ "jsonrpc": "2.0", "id": question.expect("a question")["id"], "result": { "title": "Send" } }));
    let answer = session.answer(id);
    assert!(answer["error"]["message"].as_str().is_some_and(|why| why.starts_with("nothing was sent")), "{answer}");

    session.replies.insert("window/showMessageRequest".to_owned(), json!({ "title": "Send" }));
    let done = session.request("workspace/executeCommand", send);
    assert!(done["output"].as_str().is_some_and(|output| output.contains("1 program verified")), "{done}");
    drop(session);
    child.wait().expect("it ends");
}
