//! Sessions: over standard input and output, or over a connection.

use std::io;
use std::net::Ipv4Addr;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;

use tokio::io::{AsyncRead, AsyncWrite};
use tokio::net::TcpListener;
use tokio::runtime::{Builder, Runtime};
use tower_lsp_server::LspService;

use crate::commands::Outcomes;
use crate::outgoing::Outgoing;
use crate::pool::Pool;
use crate::queue::{Queue, Task};
use crate::scratch::Scratch;
use crate::server::Server;
use crate::transport;
use crate::writer::Writer;

/// Serves the client at standard input and output. Whether the session ended as the protocol wants it: with `shutdown`
/// before `exit`, or before the client went away.
pub fn run_stdio() -> io::Result<bool> {
    let runtime = runtime()?;
    let ended_well = runtime.block_on(serve(tokio::io::stdin(), tokio::io::stdout()));
    // A thread still reads standard input, which the client need not close.
    runtime.shutdown_background();
    ended_well
}

/// Waits for one client at a port of this computer and serves it; 0 is any free port. `ready` is told the port.
pub fn run_tcp(port: u16, ready: impl FnOnce(u16)) -> io::Result<bool> {
    let runtime = runtime()?;
    let session = async {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port)).await?;
        ready(listener.local_addr()?.port());
        let (connection, _) = listener.accept().await?;
        connection.set_nodelay(true)?;
        let (input, output) = connection.into_split();
        serve(input, output).await
    };
    let ended_well = runtime.block_on(session);
    runtime.shutdown_background();
    ended_well
}

/// Serves one client until it says `exit` or goes away. Has to be called in a runtime of tokio.
pub async fn serve(input: impl AsyncRead + Unpin, output: impl AsyncWrite + Unpin) -> io::Result<bool> {
    let scratch = Scratch::default();
    let (queue, tasks) = Queue::new();
    let (outgoing, incoming) = Outgoing::new();
    let writer = Writer::new(queue.clone(), tasks, outgoing.clone(), Pool::new()?, scratch.clone());
    thread::Builder::new().name("acrc-writer".to_owned()).stack_size(8 << 20).spawn(|| writer.run())?;
    let asked_to_end = Arc::new(AtomicBool::new(false));
    let (for_server, asked) = (queue.clone(), Arc::clone(&asked_to_end));
    let (service, socket) = LspService::new(|client| {
        tokio::spawn(incoming.say_to(client.clone()));
        Server::new(client, for_server, outgoing, Outcomes::new(scratch), asked)
    });
    transport::serve(input, output, service, socket).await;
    queue.send(Task::Stop);
    Ok(asked_to_end.load(Ordering::SeqCst))
}

fn runtime() -> io::Result<Runtime> {
    Builder::new_current_thread().enable_all().build()
}
