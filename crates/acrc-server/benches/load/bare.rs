//! A tokio server that answers every four bytes with eight, and a thread that sends datagrams each millisecond. They know nothing of
//! controllers.

use std::net::{SocketAddr, UdpSocket};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use acrc_wire::ethernet::{FastStatus, Subscription};
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::{TcpListener, TcpStream};

use crate::serve::{announce, wait_for_end};

pub(crate) fn serve() {
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().expect("a runtime");
    let listener = runtime.block_on(TcpListener::bind(("127.0.0.1", 0))).expect("a free port");
    let port = listener.local_addr().expect("it is bound").port();
    announce(port, port, send_datagrams());
    std::thread::spawn(|| {
        wait_for_end();
        std::process::exit(0);
    });
    runtime.block_on(async {
        while let Ok((stream, _)) = listener.accept().await {
            tokio::spawn(answer(stream));
        }
    });
}

/// Sends to those who ask for it at fixed instants, as late as the machine makes it. Gives the port.
fn send_datagrams() -> u16 {
    let socket = Arc::new(UdpSocket::bind(("127.0.0.1", 0)).expect("a free port"));
    let port = socket.local_addr().expect("it is bound").port();
    let peers: Arc<Mutex<Vec<SocketAddr>>> = Arc::default();
    let (hears, listeners) = (Arc::clone(&socket), Arc::clone(&peers));
    std::thread::spawn(move || {
        let mut request = [0; Subscription::LEN];
        while let Ok((_, peer)) = hears.recv_from(&mut request) {
            let mut peers = listeners.lock().expect("nobody panics");
            peers.retain(|other| *other != peer);
            if Subscription::decode(&request).is_ok_and(|subscription| !subscription.is_end()) {
                peers.push(peer);
            }
        }
    });
    std::thread::spawn(move || {
        let mut due = Instant::now();
        loop {
            due += Duration::from_millis(1);
            std::thread::sleep(due.saturating_duration_since(Instant::now()));
            for peer in peers.lock().expect("nobody panics").iter() {
                let _ = socket.send_to(&[0; FastStatus::LEN], peer);
            }
        }
    });
    port
}

async fn answer(mut stream: TcpStream) {
    let _ = stream.set_nodelay(true);
    let (mut input, mut output) = (vec![0; 16384], Vec::new());
    let mut kept = 0;
    while let Ok(count @ 1..) = stream.read(&mut input[kept..]).await {
        let (whole, rest) = input[..kept + count].as_chunks::<4>();
        output.clear();
        for request in whole {
            output.extend_from_slice(request);
            output.extend_from_slice(&[0; 4]);
        }
        let (begin, length) = (4 * whole.len(), rest.len());
        if stream.write_all(&output).await.is_err() {
            return;
        }
        input.copy_within(begin..begin + length, 0);
        kept = length;
    }
}
