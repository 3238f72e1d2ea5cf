//! The protocol itself: beginnings, ends, and messages that are not as they should be.

use serde_json::json;

use crate::session::{begin, connect};

const URI: &str = "untitled:program";

#[test]
fn nothing_is_answered_before_the_beginning() {
    let mut session = connect().0;
    let id = session.ask("textDocument/hover", json!({}));
    assert_eq!(session.answer(id)["error"]["code"], -32002);
}

#[test]
fn nothing_is_answered_after_the_end() {
    let (mut session, server) = connect();
    session.initialize(json!({}), None);
    session.request("shutdown", json!(null));
    let id = session.ask("textDocument/diagnostic", json!({ "textDocument": { "uri": URI } }));
    assert_eq!(session.answer(id)["error"]["code"], -32600);
    session.notify("exit", json!(null));
    assert!(server.join().expect("no panic"), "it ended as it was asked to");
}

#[test]
fn leaving_without_a_word_is_an_end_too() {
    let (mut session, server) = connect();
    session.initialize(json!({}), None);
    session.notify("exit", json!(null));
    assert!(!server.join().expect("no panic"), "nobody asked for the end");

    let (mut session, server) = connect();
    session.initialize(json!({}), None);
    drop(session);
    assert!(!server.join().expect("no panic"));
}

#[test]
fn what_is_no_message_does_no_harm() {
    let mut session = begin(None);
    session.send_raw(b"Content-Length: 9\r\n\r\n{\"broken\"");
    session.send_raw(b"Content-Length: 2\r\n\r\n[]");
    session.send_raw(b"Content-Length: nonsense\r\n\r\n");
    session.send_raw(b"Content-Length: 4\r\nContent-Type: application/vscode-jsonrpc; charset=utf-8\r\n\r\nnull");
    session.notify("textDocument/didChange", json!({ "nothing": "of it" }));
    session.notify("textDocument/didOpen", json!(null));
    session.notify("no/such/thing", json!({}));
    session.notify("$/setTrace", json!({ "value": "off" }));
    session.open(URI, "PROGRAM\nENDP\n");
    session.diagnostics(URI, 1);
}

#[test]
fn what_is_not_understood_is_answered_with_an_error() {
    let mut session = begin(None);
    for (method, params, code) in [
        ("no/such/thing", json!({}), -32601),
        ("$/no/such/thing", json!({}), -32601),
        ("textDocument/diagnostic", json!({ "textDocument": 7 }), -32602),
    ] {
        let id = session.ask(method, params);
        assert_eq!(session.answer(id)["error"]["code"], code, "{method}");
    }
}

#[test]
fn a_document_that_is_not_open_can_not_be_edited() {
    let mut session = begin(None);
    session.change(URI, 2, json!([{ "text": "PROGRAM\n" }]));
    let refusal = session.wait_for("window/logMessage", |params| params["type"] == 1);
    assert!(refusal["message"].as_str().expect("a text").contains("not open"), "{refusal}");
}
