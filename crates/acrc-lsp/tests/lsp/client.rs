//! A tiny client: messages as JSON over any pair of streams.
#![expect(clippy::needless_pass_by_value, reason = "`json!` is written in place")]

use std::collections::{BTreeMap, VecDeque};
use std::io::{BufRead, Write};

use serde_json::{Value, json};

/// A client of a session.
pub(crate) struct Client<R, W> {
    input: R,
    output: W,
    next_id: i64,
    /// Answers that came before somebody waited for them.
    answers: BTreeMap<i64, Value>,
    /// Notifications that nobody has looked at.
    pub(crate) notifications: VecDeque<Value>,
    /// What to answer when the server asks for something, by method; `null` for the rest.
    pub(crate) replies: BTreeMap<String, Value>,
    /// Requests of the server, which were answered.
    pub(crate) requests: Vec<Value>,
}

impl<R: BufRead, W: Write> Client<R, W> {
    pub(crate) fn new(input: R, output: W) -> Self {
        Self {
            input,
            output,
            next_id: 0,
            answers: BTreeMap::new(),
            notifications: VecDeque::new(),
            replies: BTreeMap::new(),
            requests: Vec::new(),
        }
    }

    /// Sends bytes as they are.
    pub(crate) fn send_raw(&mut self, bytes: &[u8]) {
        self.output.write_all(bytes).expect("the server reads");
        self.output.flush().expect("the server reads");
    }

    pub(crate) fn send(&mut self, message: &Value) {
        let body = message.to_string();
        self.send_raw(format!("Content-Length: {}\r\n\r\n{body}", body.len()).as_bytes());
    }

    pub(crate) fn notify(&mut self, method: &str, params: Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    /// Sends a request without waiting for its answer.
    pub(crate) fn ask(&mut self, method: &str, params: Value) -> i64 {
        self.next_id += 1;
        let mut message = json!({ "jsonrpc": "2.0", "id": self.next_id, "method": method });
        if !params.is_null() {
            message["params"] = params;
        }
        self.send(&message);
        self.next_id
    }

    /// The whole answer to a request.
    pub(crate) fn answer(&mut self, id: i64) -> Value {
        loop {
            if let Some(answer) = self.answers.remove(&id) {
                return answer;
            }
            self.receive();
        }
    }

    /// Sends a request and waits for its result; an error fails the test.
    pub(crate) fn request(&mut self, method: &str, params: Value) -> Value {
        let id = self.ask(method, params);
        let mut answer = self.answer(id);
        assert!(answer.get("error").is_none(), "{method}: {answer}");
        answer["result"].take()
    }

    /// Waits for a notification that fits, and drops those of its kind before it.
    pub(crate) fn wait_for(&mut self, method: &str, fits: impl Fn(&Value) -> bool) -> Value {
        loop {
            while let Some(message) = self.notifications.pop_front() {
                if message["method"] == method && fits(&message["params"]) {
                    return message["params"].clone();
                }
            }
            self.receive();
        }
    }

    /// Takes one message from the server.
    pub(crate) fn receive(&mut self) {
        let message = self.read().expect("the server goes on");
        match (message.get("method").and_then(Value::as_str), message.get("id")) {
            (Some(method), Some(id)) => {
                let result = self.replies.get(method).cloned().unwrap_or_default();
                let reply = json!({ "jsonrpc": "2.0", "id": id, "result": result });
                self.requests.push(message);
                self.send(&reply);
            }
            (Some(_), None) => self.notifications.push_back(message),
            (None, id) => {
                let id = id.and_then(Value::as_i64).unwrap_or(-1);
                self.answers.insert(id, message);
            }
        }
    }

    /// The next message; `None` when the server has ended.
    pub(crate) fn read(&mut self) -> Option<Value> {
        let mut length = None;
        loop {
            let mut line = String::new();
            if self.input.read_line(&mut line).expect("the server writes") == 0 {
                return None;
            }
            match line.trim_end().split_once(": ") {
                Some(("Content-Length", value)) => length = value.parse::<usize>().ok(),
                Some(_) => {}
                None => break,
            }
        }
        let mut body = vec![0; length.expect("a message has a length")];
        self.input.read_exact(&mut body).expect("a message is whole");
        Some(serde_json::from_slice(&body).expect("a message is JSON"))
    }

    /// Begins a session with these capabilities of the client in this folder.
    pub(crate) fn initialize(&mut self, capabilities: Value, folder: Option<&str>) -> Value {
        let folders = folder.map(|uri| json!([{ "uri": uri, "name": "work" }]));
        let params =
            json!({ "processId": null, "rootUri": null, "capabilities": capabilities, "workspaceFolders": folders });
        let result = self.request("initialize", params);
        self.notify("initialized", json!({}));
        result
    }

    pub(crate) fn open(&mut self, uri: &str, text: &str) {
        let document = json!({ "uri": uri, "languageId": "acrobasic", "version": 1, "text": text });
        self.notify("textDocument/didOpen", json!({ "textDocument": document }));
    }

    pub(crate) fn change(&mut self, uri: &str, version: i32, changes: Value) {
        let document = json!({ "uri": uri, "version": version });
        self.notify("textDocument/didChange", json!({ "textDocument": document, "contentChanges": changes }));
    }

    /// The findings of this version of a document.
    pub(crate) fn diagnostics(&mut self, uri: &str, version: i32) -> Value {
        let fits = |params: &Value| params["uri"] == uri && params["version"] == version;
        self.wait_for("textDocument/publishDiagnostics", fits)["diagnostics"].take()
    }
}
