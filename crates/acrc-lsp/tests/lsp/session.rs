//! Sessions in memory: the server in a thread, the client here.

use std::io::{self, BufReader, Read, Write};
use std::rc::Rc;
use std::thread;

use serde_json::{Value, json};
use tokio::io::{AsyncReadExt, AsyncWriteExt, DuplexStream, ReadHalf, WriteHalf};
use tokio::runtime::{Builder, Runtime};

use crate::client::Client;

/// Nobody waits for the other side to read.
const BUFFER: usize = 64 << 20;

/// A client of a server in this process.
pub(crate) type Session = Client<BufReader<Reader>, Writer>;

pub(crate) struct Reader(Rc<Runtime>, ReadHalf<DuplexStream>);
pub(crate) struct Writer(Rc<Runtime>, WriteHalf<DuplexStream>);

impl Read for Reader {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.0.block_on(self.1.read(buffer))
    }
}

impl Write for Writer {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.block_on(self.1.write(bytes))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.block_on(self.1.flush())
    }
}

/// Begins a session, before `initialize`. The server's verdict on how it ended comes from the thread.
pub(crate) fn connect() -> (Session, thread::JoinHandle<bool>) {
    let (here, there) = tokio::io::duplex(BUFFER);
    let server = thread::spawn(|| {
        let runtime = Builder::new_current_thread().enable_all().build().expect("a runtime");
        let (input, output) = tokio::io::split(there);
        runtime.block_on(acrc_lsp::serve(input, output)).expect("the server starts")
    });
    let runtime = Rc::new(Builder::new_current_thread().enable_all().build().expect("a runtime"));
    let (input, output) = tokio::io::split(here);
    let client = Client::new(BufReader::new(Reader(Rc::clone(&runtime), input)), Writer(runtime, output));
    (client, server)
}

/// A session of a client that can do everything that matters here, but is told findings.
pub(crate) fn begin(folder: Option<&str>) -> Session {
    let mut session = connect().0;
    session.initialize(able(), folder);
    session
}

/// The capabilities of a modern client that does not ask for findings.
pub(crate) fn able() -> Value {
    json!({
        "window": { "workDoneProgress": true },
        "workspace": { "workspaceEdit": { "documentChanges": true } },
        "textDocument": {
            "publishDiagnostics": {
                "relatedInformation": true, "codeDescriptionSupport": true, "dataSupport": true,
                "tagSupport": { "valueSet": [1, 2] }
            },
            "hover": { "contentFormat": ["markdown", "plaintext"] },
            "completion": { "completionItem": { "snippetSupport": true, "documentationFormat": ["markdown"] } },
            "documentSymbol": { "hierarchicalDocumentSymbolSupport": true },
            "codeAction": { "codeActionLiteralSupport": { "codeActionKind": { "valueSet": [] } } },
            "rename": { "prepareSupport": true }
        }
    })
}

/// A change of a range.
pub(crate) fn edit(start: (u32, u32), end: (u32, u32), text: &str) -> Value {
    let position = |(line, character): (u32, u32)| json!({ "line": line, "character": character });
    json!({ "range": { "start": position(start), "end": position(end) }, "text": text })
}

/// The codes of findings, in their order.
pub(crate) fn codes(diagnostics: &Value) -> Vec<String> {
    let items = diagnostics.as_array().expect("a list of findings").iter();
    items.filter_map(|item| item["code"].as_str().map(str::to_owned)).collect()
}
