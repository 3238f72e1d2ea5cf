//! A tokio server that answers every four bytes with eight and knows nothing of controllers.

use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::{TcpListener, TcpStream};

use crate::serve::{announce, wait_for_end};

pub(crate) fn serve() {
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().expect("a runtime");
    let listener = runtime.block_on(TcpListener::bind(("127.0.0.1", 0))).expect("a free port");
    let port = listener.local_addr().expect("it is bound").port();
    announce(port, port, port);
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
