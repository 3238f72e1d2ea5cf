//! Messages in and out.
//!
//! The server's transport of `tower-lsp-server` is not used, for three reasons: it polls the futures of messages
//! together, so that nothing promises that the handler of the first message begins first; with as many questions under
//! way as it allows, edits and cancellations wait; and it ends the session at the first message that is not JSON. Here
//! each handler runs up to its first await when its message arrives, which is where it queues its work for the writer:
//! arrival order holds whatever happens to the futures later.

use std::io;

use futures_util::{FutureExt as _, SinkExt as _, StreamExt as _};
use serde::{Deserialize, Serialize};
use tokio::io::{
    AsyncBufRead, AsyncBufReadExt as _, AsyncRead, AsyncReadExt as _, AsyncWrite, AsyncWriteExt as _, BufReader,
};
use tokio::sync::mpsc::{UnboundedReceiver, UnboundedSender, unbounded_channel};
use tower_lsp_server::jsonrpc::{Error, Id, Request, Response};
use tower_lsp_server::{ClientSocket, LanguageServer, LspService};
use tower_service::Service as _;

/// The longest message that is read: larger than any file that can be opened.
const MOST_BYTES: usize = 512 << 20;
/// The longest line of a header.
const MOST_HEADER_BYTES: u64 = 8 << 10;

/// Serves until the client says `exit` or goes away.
pub(crate) async fn serve<S: LanguageServer>(
    input: impl AsyncRead + Unpin,
    output: impl AsyncWrite + Unpin,
    service: LspService<S>,
    socket: ClientSocket,
) {
    let (sender, receiver) = unbounded_channel();
    let (mut requests, replies) = socket.split();
    let own_requests = sender.clone();
    let say = async move {
        while let Some(request) = requests.next().await {
            send(&own_requests, &request);
        }
    };
    let listen = listen(BufReader::new(input), service, replies, sender);
    tokio::pin!(listen);
    tokio::select! {
        () = &mut listen => {}
        // Who can't be written to has gone.
        () = async { tokio::join!(say, write(output, receiver)); } => {}
    }
}

/// Takes messages.
async fn listen<S: LanguageServer>(
    mut input: impl AsyncBufRead + Unpin,
    mut service: LspService<S>,
    mut replies: impl futures_util::Sink<Response> + Unpin,
    sender: UnboundedSender<Vec<u8>>,
) {
    loop {
        match read(&mut input).await {
            Ok(Some(Message::Request(request))) => {
                if let Some(answer) = refusal(&request) {
                    send(&sender, &answer);
                    continue;
                }
                let is_end = request.method() == "exit";
                if std::future::poll_fn(|cx| service.poll_ready(cx)).await.is_err() {
                    return;
                }
                handle(service.call(request), &sender);
                if is_end {
                    return;
                }
            }
            // A reply that nobody waits for is no harm.
            Ok(Some(Message::Response(reply))) => drop(replies.send(reply).await),
            Err(Malformed::Message(error)) => send(&sender, &Response::from_error(Id::Null, error)),
            Ok(None) | Err(Malformed::Gone) => return,
        }
    }
}

/// The answer to a question whose name begins as those of notifications that may be ignored do: it may not be ignored,
/// and the service would.
fn refusal(request: &Request) -> Option<Response> {
    let id = request.id().filter(|_| request.method().starts_with("$/"))?;
    Some(Response::from_error(id.clone(), Error::method_not_found()))
}

/// Runs a handler up to its first await now, and the rest beside everything else.
fn handle<E>(
    handler: impl Future<Output = Result<Option<Response>, E>> + Send + Unpin + 'static,
    sender: &UnboundedSender<Vec<u8>>,
) {
    let mut handler = handler;
    let sender = sender.clone();
    if let Some(answer) = (&mut handler).now_or_never() {
        tell(answer, &sender);
    } else {
        tokio::spawn(async move { tell(handler.await, &sender) });
    }
}

fn tell<E>(answer: Result<Option<Response>, E>, sender: &UnboundedSender<Vec<u8>>) {
    if let Ok(Some(response)) = answer {
        send(sender, &response);
    }
}

fn send(sender: &UnboundedSender<Vec<u8>>, message: &impl Serialize) {
    if let Ok(body) = serde_json::to_vec(message) {
        // The client may have gone.
        let _ = sender.send(body);
    }
}

/// Writes messages until there are none to come.
async fn write(mut output: impl AsyncWrite + Unpin, mut bodies: UnboundedReceiver<Vec<u8>>) {
    let mut bytes = Vec::new();
    while let Some(body) = bodies.recv().await {
        frame(&body, &mut bytes);
        while let Ok(body) = bodies.try_recv() {
            frame(&body, &mut bytes);
        }
        if output.write_all(&bytes).await.is_err() || output.flush().await.is_err() {
            return;
        }
        bytes.clear();
    }
}

fn frame(body: &[u8], bytes: &mut Vec<u8>) {
    bytes.extend_from_slice(format!("Content-Length: {}\r\n\r\n", body.len()).as_bytes());
    bytes.extend_from_slice(body);
}

/// A message from the client.
#[derive(Deserialize)]
#[serde(untagged)]
enum Message {
    Response(Response),
    Request(Request),
}

/// Why there is no message.
enum Malformed {
    /// It is answered with this error, and the next one is taken.
    Message(Error),
    /// There will be none.
    Gone,
}

impl From<io::Error> for Malformed {
    fn from(_: io::Error) -> Self {
        Self::Gone
    }
}

/// The next message; `None` at the end.
async fn read(input: &mut (impl AsyncBufRead + Unpin)) -> Result<Option<Message>, Malformed> {
    let Some(length) = read_header(input).await? else { return Ok(None) };
    let mut body = vec![0; length];
    input.read_exact(&mut body).await?;
    let is_json = || serde_json::from_slice::<serde::de::IgnoredAny>(&body).is_ok();
    serde_json::from_slice(&body)
        .map(Some)
        .map_err(|_| Malformed::Message(if is_json() { Error::invalid_request() } else { Error::parse_error() }))
}

/// The length of the next message. Headers without one are passed over.
async fn read_header(input: &mut (impl AsyncBufRead + Unpin)) -> Result<Option<usize>, Malformed> {
    let mut length = None;
    let mut line = Vec::new();
    loop {
        line.clear();
        let count = (&mut *input).take(MOST_HEADER_BYTES).read_until(b'\n', &mut line).await?;
        if count == 0 {
            return Ok(None);
        }
        let text = String::from_utf8_lossy(&line);
        match text.trim_end().split_once(':') {
            Some((name, value)) if name.eq_ignore_ascii_case("Content-Length") => {
                length = value.trim().parse::<usize>().ok().filter(|length| *length <= MOST_BYTES);
            }
            None if text.trim_end().is_empty() => match length {
                Some(_) => return Ok(length),
                None => return Err(Malformed::Message(Error::parse_error())),
            },
            _ => {}
        }
    }
}
