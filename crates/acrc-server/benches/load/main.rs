//! What the server stands on the loopback interface while eight axes move in real time, beside a server that does nothing.
//!
//! The servers run in processes of their own. This one is all of the clients, with blocking sockets, so that a client costs what a
//! client of this kind costs. Every figure stands beside the same figure of a bare tokio server that answers a request of
//! four bytes with eight and knows nothing of controllers: that is what machine and sockets give.
//!
//! `cargo bench --package acrc-server --bench load` prints a table. Seconds per measurement: `ACRC_LOAD_SECONDS` (5).

mod bare;
mod clients;
mod machine;
mod serve;
mod status;
mod summary;

use std::time::Duration;

use serve::Child;
use summary::Row;

fn main() {
    let mut arguments = std::env::args().skip(1);
    match arguments.next().as_deref() {
        Some(serve::CONTROLLER) => serve::controller(),
        Some(serve::BARE) => bare::serve(),
        _ => measure(),
    }
}

fn measure() {
    let seconds = std::env::var("ACRC_LOAD_SECONDS").ok().and_then(|text| text.parse().ok()).unwrap_or(5.0);
    let time = Duration::from_secs_f64(seconds);

    let bare = Child::start(serve::BARE);
    let bare_piped = clients::pipelined(bare.mixed(), time);
    let bare_strict = clients::strict(bare.mixed(), time);
    let bare_status = status::five_clients(bare.fast_status(), time);
    bare.end();

    let child = Child::start(serve::CONTROLLER);
    machine::start(child.ascii());
    let piped = clients::pipelined(child.mixed(), time);
    let strict = clients::strict(child.mixed(), time);
    let status = status::five_clients(child.fast_status(), time);
    // Everything at once: four clients ask, five get fast status.
    let (busy_strict, busy_status) = std::thread::scope(|scope| {
        let status = scope.spawn(|| status::five_clients(child.fast_status(), time));
        (clients::strict(child.mixed(), time), status.join().expect("a client"))
    });
    let finished = child.end();

    summary::print(&[
        Row::rate("pipelined reads on one connection", &piped, &bare_piped, Some(50_000.0)),
        Row::rate("strict reads over four connections", &strict, &bare_strict, Some(20_000.0)),
        Row::rate("the same, with fast status", &busy_strict, &bare_strict, None),
    ]);
    summary::print_status(&[
        ("fast status to five clients", &status),
        ("the same, with strict reads", &busy_status),
        ("    bare thread and sockets", &bare_status),
    ]);
    println!("{finished}");
}
