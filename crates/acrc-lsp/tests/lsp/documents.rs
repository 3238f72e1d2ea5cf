//! Documents that are opened, edited and closed, and the findings in them.

use std::fs;

use serde_json::json;

use crate::session::{begin, codes, connect, edit};

const URI: &str = "untitled:program";

#[test]
fn findings_follow_edits() {
    let mut session = begin(None);
    session.open(URI, "PROGRAM\nGOTO Missing\nENDP\n");
    assert_eq!(codes(&session.diagnostics(URI, 1)), ["ACR101"]);
    session.change(URI, 2, json!([edit((1, 0), (1, 0), "_Missing\n")]));
    assert!(!codes(&session.diagnostics(URI, 2)).contains(&"ACR101".to_owned()));
}

#[test]
fn what_can_be_left_out_and_what_is_written_otherwise_have_tags() {
    let mut session = begin(None);
    session.open(URI, "PROGRAM\n_Nobody\nVEL = 5\nGOTO Missing\nENDP\n");
    let found = session.diagnostics(URI, 1);
    let items = found.as_array().expect("a list of findings").iter();
    let tags: Vec<_> =
        items.map(|item| (item["code"].as_str().unwrap_or_default(), item["tags"].to_string())).collect();
    for expected in [("ACR103", "[1]"), ("ACR010", "[2]"), ("ACR101", "null")] {
        assert!(tags.iter().any(|(code, tags)| (*code, tags.as_str()) == expected), "{expected:?} in {tags:?}");
    }
}

#[test]
fn several_changes_apply_one_after_the_other() {
    let mut session = begin(None);
    session.open(URI, "PROGRAM\nENDP\n");
    session.diagnostics(URI, 1);
    let changes =
        json!([edit((1, 0), (1, 0), "GOTO A\n"), edit((1, 5), (1, 6), "Missing"), edit((0, 7), (0, 7), "\n")]);
    session.change(URI, 2, changes);
    let found = session.diagnostics(URI, 2);
    assert_eq!(codes(&found), ["ACR101"]);
    assert_eq!(found[0]["range"]["start"], json!({ "line": 2, "character": 5 }));
}

#[test]
fn positions_count_what_was_agreed() {
    for (encoding, column) in [("utf-8", 14), ("utf-16", 10), ("utf-32", 9)] {
        let mut session = connect().0;
        let result = session.initialize(json!({ "general": { "positionEncodings": [encoding, "utf-16"] } }), None);
        assert_eq!(result["capabilities"]["positionEncoding"], encoding);
        session.open(URI, "PROGRAM\nENDP\n");
        session.diagnostics(URI, 1);
        session.change(URI, 2, json!([edit((1, 0), (1, 0), "P0 = \"\u{20ac}\u{1f600}\" : GOTO Missing\n")]));
        session.diagnostics(URI, 2);
        // Behind the two wide characters: what is replaced shows that the place was understood.
        session.change(URI, 3, json!([edit((1, 0), (1, column), "P0 = 1")]));
        let found = session.diagnostics(URI, 3);
        let goto = found.as_array().expect("findings").iter().find(|item| item["code"] == "ACR101");
        assert_eq!(goto.expect("the jump is refused")["range"]["start"]["character"], 14, "{encoding} {found}");
    }
}

#[test]
fn a_range_that_ends_before_it_begins_changes_nothing() {
    let mut session = begin(None);
    session.open(URI, "PROGRAM\nGOTO Missing\nENDP\n");
    session.diagnostics(URI, 1);
    session.change(URI, 2, json!([edit((2, 0), (1, 0), "x")]));
    let refusal = session.wait_for("window/logMessage", |params| params["type"] == 1);
    assert!(refusal["message"].as_str().expect("a text").contains("ends before it begins"), "{refusal}");
    session.change(URI, 3, json!([edit((0, 0), (0, 0), "\n")]));
    assert_eq!(codes(&session.diagnostics(URI, 3)), ["ACR101"]);
}

#[test]
fn an_edit_changes_what_is_found_in_other_files() {
    let folder = tempfile::tempdir().expect("a folder");
    let root = folder.path().canonicalize().expect("a path");
    let uri = |name: &str| format!("file://{}/{name}", root.display());
    fs::write(root.join("Setup.8K"), "SYS\n#DEFINE Lamp BIT32\n").expect("written");
    fs::write(root.join("Prog0.8K"), "PROGRAM\nSET Lamp\nENDP\n").expect("written");
    let mut session = begin(Some(&format!("file://{}", root.display())));
    session.open(&uri("Prog0.8K"), "PROGRAM\nSET Lamp\nENDP\n");
    let before = codes(&session.diagnostics(&uri("Prog0.8K"), 1));
    session.open(&uri("Setup.8K"), "SYS\n#DEFINE Lamp BIT32\n");
    session.diagnostics(&uri("Setup.8K"), 1);
    session.change(&uri("Setup.8K"), 2, json!([edit((1, 8), (1, 12), "Bulb")]));
    session.diagnostics(&uri("Setup.8K"), 2);
    let after = codes(&session.diagnostics(&uri("Prog0.8K"), 1));
    assert_ne!(before, after, "the alias that it uses is gone");
    assert!(after.len() > before.len(), "{before:?} {after:?}");
}

#[test]
fn a_closed_file_is_as_it_is_on_disk() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().canonicalize().expect("a path").join("Prog0.8K");
    fs::write(&path, "PROGRAM\nENDP\n").expect("written");
    let uri = format!("file://{}", path.display());
    let mut session = begin(Some(&format!("file://{}", path.parent().expect("a folder").display())));
    session.open(&uri, "PROGRAM\nGOTO Missing\nENDP\n");
    assert!(codes(&session.diagnostics(&uri, 1)).contains(&"ACR101".to_owned()));
    session.notify("textDocument/didClose", json!({ "textDocument": { "uri": uri } }));
    let closed = session.wait_for("textDocument/publishDiagnostics", |params| {
        params["uri"] == uri.as_str() && params.get("version").is_none_or(serde_json::Value::is_null)
    });
    assert!(!codes(&closed["diagnostics"]).contains(&"ACR101".to_owned()), "{closed}");
}

#[test]
fn a_description_that_cannot_be_read_is_told_where_it_is_wrong() {
    let folder = tempfile::tempdir().expect("a folder");
    let root = folder.path().canonicalize().expect("a path");
    fs::write(root.join("acrc.toml"), "[project]\nmodell = \"ACR9000\"\n").expect("written");
    fs::write(root.join("Prog0.8K"), "PROGRAM\nENDP\n").expect("written");
    let config = format!("file://{}/acrc.toml", root.display());
    let mut session = begin(Some(&format!("file://{}", root.display())));
    let wrong = session.wait_for("textDocument/publishDiagnostics", |params| params["uri"] == config.as_str());
    assert_eq!(wrong["diagnostics"][0]["range"]["start"]["line"], 1, "{wrong}");
    fs::write(root.join("acrc.toml"), "[project]\nmodel = \"ACR9000\"\n").expect("written");
    session.notify("workspace/didChangeWatchedFiles", json!({ "changes": [{ "uri": config, "type": 2 }] }));
    let right = session.wait_for("textDocument/publishDiagnostics", |params| params["uri"] == config.as_str());
    assert_eq!(right["diagnostics"], json!([]));
}

#[test]
fn findings_are_given_when_they_are_asked_for() {
    let mut session = connect().0;
    session.initialize(json!({ "textDocument": { "diagnostic": {} } }), None);
    session.open(URI, "PROGRAM\nGOTO Missing\nENDP\n");
    let ask = json!({ "textDocument": { "uri": URI } });
    let report = session.request("textDocument/diagnostic", ask);
    assert_eq!((report["kind"].as_str(), codes(&report["items"])), (Some("full"), vec!["ACR101".to_owned()]));
    let again = json!({ "textDocument": { "uri": URI }, "previousResultId": report["resultId"] });
    assert_eq!(session.request("textDocument/diagnostic", again)["kind"], "unchanged");

    let all = session.request("workspace/diagnostic", json!({ "previousResultIds": [] }));
    let known = json!({ "previousResultIds": [{ "uri": URI, "value": all["items"][0]["resultId"] }] });
    let waiting = session.ask("workspace/diagnostic", known);
    session.change(URI, 2, json!([edit((1, 0), (2, 0), "")]));
    let report = session.answer(waiting);
    assert_eq!(report["result"]["items"][0]["items"], json!([]), "it was answered by the change");
    assert!(session.notifications.iter().all(|message| message["method"] != "textDocument/publishDiagnostics"));
}
