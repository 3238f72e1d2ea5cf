//! Closing a connection so that its client reads everything and sees its end.

use std::time::Duration;

use tokio::io::{AsyncReadExt as _, AsyncWriteExt as _};
use tokio::net::TcpStream;
use tokio::time::timeout;

/// How long a client has to take its last bytes, and to close its side.
const PATIENCE: Duration = Duration::from_secs(1);

/// Sends the last bytes, ends the stream, and reads until the client ends it too: closing a socket with bytes in it resets the connection,
/// and what was sent could be lost (Ethernet specification, "Closing Connections").
pub(crate) async fn part(mut socket: TcpStream, last: &[u8]) {
    let ended = timeout(PATIENCE, async {
        socket.write_all(last).await?;
        socket.shutdown().await
    });
    if matches!(ended.await, Ok(Ok(()))) {
        let mut ignored = [0; 1024];
        let _ = timeout(PATIENCE, async { while matches!(socket.read(&mut ignored).await, Ok(1..)) {} }).await;
    }
}
