//! A session as a person has it: with wide characters before every place that is asked about.

use serde_json::{Value, json};

use crate::session::{Session, able, connect, edit};

const URI: &str = "untitled:program";

/// Wide characters in texts and remarks; a name stands behind them in the same line.
const PROGRAM: &str = "#DEFINE Lamp BIT32\nPROGRAM\nDIM LV(2)\n_Start\nPRINT \"é€😀\" : GOSUB Work : ' größer 😀\nGOTO Start\n_Work\nLV0 = LV0 + 1\nRETURN\nENDP\n";

/// A session in one encoding, with the program open.
fn begin(encoding: &str) -> Session {
    let mut session = connect().0;
    let mut able = able();
    able["general"] = json!({ "positionEncodings": [encoding] });
    session.initialize(able, None);
    session.open(URI, PROGRAM);
    session
}

/// Where a word begins, counted by hand in each encoding.
fn place_of(word: &str, encoding: &str) -> Value {
    let (line, text) = (0..).zip(PROGRAM.lines()).find(|(_, line)| line.contains(word)).expect("the word is there");
    let before = &text[..text.find(word).expect("the word is there")];
    let character = match encoding {
        "utf-8" => before.len(),
        "utf-16" => before.encode_utf16().count(),
        _ => before.chars().count(),
    };
    json!({ "line": line, "character": character })
}

fn at(word: &str, encoding: &str) -> Value {
    json!({ "textDocument": { "uri": URI }, "position": place_of(word, encoding), "context": { "includeDeclaration": true } })
}

/// Applies edits of one document by hand, from the last to the first.
fn applied(edits: &Value, encoding: &str) -> String {
    let offset = |position: &Value| {
        let line = position["line"].as_u64().expect("a line") as usize;
        let mut left = position["character"].as_u64().expect("a column") as usize;
        let start: usize = PROGRAM.split_inclusive('\n').take(line).map(str::len).sum();
        let mut offset = start;
        for character in PROGRAM[start..].chars() {
            if left == 0 {
                break;
            }
            left -= match encoding {
                "utf-8" => character.len_utf8(),
                "utf-16" => character.len_utf16(),
                _ => 1,
            };
            offset += character.len_utf8();
        }
        offset
    };
    let mut list: Vec<(usize, usize, String)> = edits
        .as_array()
        .expect("a list")
        .iter()
        .map(|edit| {
            let text = edit["newText"].as_str().expect("a text").to_owned();
            (offset(&edit["range"]["start"]), offset(&edit["range"]["end"]), text)
        })
        .collect();
    list.sort();
    let mut text = PROGRAM.to_owned();
    for (start, end, new) in list.into_iter().rev() {
        text.replace_range(start..end, &new);
    }
    text
}

const ENCODINGS: [&str; 3] = ["utf-8", "utf-16", "utf-32"];

#[test]
fn places_behind_wide_characters_are_found() {
    for encoding in ENCODINGS {
        let mut session = begin(encoding);
        let hover = session.request("textDocument/hover", at("Work", encoding));
        assert_eq!(hover["range"]["start"], place_of("Work", encoding), "{encoding} {hover}");
        let definition = session.request("textDocument/definition", at("Work", encoding));
        assert_eq!(definition[0]["range"]["start"]["line"], 6, "{encoding} {definition}");
        let found = session.request("textDocument/references", at("Work", encoding));
        assert!(found.as_array().is_some_and(|found| found.len() == 2), "{encoding} {found}");
    }
}

#[test]
fn a_name_is_changed_wherever_it_is_used() {
    for encoding in ENCODINGS {
        let mut session = begin(encoding);
        let mut params = at("Work", encoding);
        let prepared = session.request("textDocument/prepareRename", params.clone());
        assert_eq!(prepared["placeholder"], "Work", "{encoding}");
        params["newName"] = json!("Labor");
        let renamed = session.request("textDocument/rename", params.clone());
        let edits = &renamed["documentChanges"][0]["edits"];
        assert_eq!(applied(edits, encoding), PROGRAM.replace("Work", "Labor"), "{encoding} {renamed}");
        params["newName"] = json!("1 2");
        let id = session.ask("textDocument/rename", params);
        assert_eq!(session.answer(id)["error"]["code"], -32803, "a name that is refused is answered with the reason");
    }
}

#[test]
fn an_item_gets_its_page_when_it_is_shown() {
    let mut session = begin("utf-16");
    session.change(URI, 2, json!([edit((7, 0), (7, 0), "P")]));
    let params = json!({ "textDocument": { "uri": URI }, "position": { "line": 7, "character": 1 } });
    let list = session.request("textDocument/completion", params);
    let items = list["items"].as_array().expect("a list of items");
    let item = items.iter().find(|item| item["label"] == "PRINT").expect("PRINT begins with P").clone();
    assert!(item.get("documentation").is_none());
    assert_eq!(item["textEdit"]["range"]["start"]["character"], 0);
    let resolved = session.request("completionItem/resolve", item);
    assert_eq!(resolved["documentation"]["kind"], "markdown", "{resolved}");
}

#[test]
fn repairs_belong_to_their_findings() {
    let mut session = begin("utf-16");
    session.change(URI, 2, json!([edit((4, 0), (4, 0), "GOSUB Nowhere\n")]));
    let diagnostics = session.diagnostics(URI, 2);
    let finding = diagnostics.as_array().expect("findings").iter().find(|finding| finding["code"] == "ACR101");
    let finding = finding.expect("the label is missing").clone();
    assert!(finding["codeDescription"]["href"].as_str().is_some_and(|href| href.contains("ACR101")), "{finding}");
    let context = json!({ "diagnostics": [finding], "only": ["quickfix"] });
    let params = json!({ "textDocument": { "uri": URI }, "range": finding["range"], "context": context });
    let actions = session.request("textDocument/codeAction", params);
    let actions = actions.as_array().expect("actions");
    assert!(actions.iter().any(|action| action["diagnostics"][0]["code"] == "ACR101"), "{actions:?}");
    assert!(actions.iter().all(|action| action["kind"] == "quickfix" && action["edit"].is_object()));
}

#[test]
fn colours_are_told_as_differences() {
    let mut session = begin("utf-16");
    let document = json!({ "uri": URI });
    let full = session.request("textDocument/semanticTokens/full", json!({ "textDocument": document }));
    session.change(URI, 2, json!([edit((7, 0), (7, 0), "LV1 = 3\n")]));
    let params = json!({ "textDocument": document, "previousResultId": full["resultId"] });
    let delta = session.request("textDocument/semanticTokens/full/delta", params);
    let edits = delta["edits"].as_array().expect("a difference").clone();
    let mut data: Vec<u64> = serde_json::from_value(full["data"].clone()).expect("numbers");
    for edit in edits {
        let start = edit["start"].as_u64().expect("a place") as usize;
        let end = start + edit["deleteCount"].as_u64().expect("a count") as usize;
        let new: Vec<u64> = serde_json::from_value(edit["data"].clone()).unwrap_or_default();
        data.splice(start..end, new);
    }
    let again = session.request("textDocument/semanticTokens/full", json!({ "textDocument": document }));
    assert_eq!(json!(data), again["data"]);
}

#[test]
fn every_feature_that_is_offered_answers() {
    let mut session = begin("utf-16");
    let document = json!({ "uri": URI });
    let whole = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 99, "character": 0 } });
    for (method, params) in [
        ("textDocument/documentSymbol", json!({ "textDocument": document })),
        ("textDocument/foldingRange", json!({ "textDocument": document })),
        ("textDocument/codeLens", json!({ "textDocument": document })),
        ("textDocument/inlayHint", json!({ "textDocument": document, "range": whole })),
        ("textDocument/semanticTokens/range", json!({ "textDocument": document, "range": whole })),
        (
            "textDocument/selectionRange",
            json!({ "textDocument": document, "positions": [{ "line": 7, "character": 2 }] }),
        ),
        ("textDocument/documentHighlight", at("Work", "utf-16")),
        ("textDocument/prepareCallHierarchy", at("Work", "utf-16")),
        ("workspace/symbol", json!({ "query": "work" })),
    ] {
        let answer = session.request(method, params);
        let list = answer.as_array().or_else(|| answer["data"].as_array());
        assert!(list.is_some_and(|list| !list.is_empty()), "{method}: {answer}");
    }
    let called = session.request("textDocument/prepareCallHierarchy", at("Work", "utf-16"));
    let callers = session.request("callHierarchy/incomingCalls", json!({ "item": called[0] }));
    assert!(callers.as_array().is_some_and(|callers| callers.len() == 1), "{callers}");
}
