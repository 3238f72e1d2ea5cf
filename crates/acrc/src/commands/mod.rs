//! The subcommands, one file each.

mod build;
mod diff;
mod download;
mod explain;
mod fmt;
mod get;
mod kinds;
mod link;
mod lint;
mod list;
mod lsp;
mod mem;
mod mov;
pub(crate) mod nonvolatile;
mod project;
mod repl;
mod reset_kamr;
mod serve;
mod set;
mod sim;
mod source_file;
mod state;
mod stdin;
mod targets;
mod term;
mod upload;
mod virtual_controller;
mod watch;

use crate::cli::{Arguments, Command};
use crate::exit::Exit;

/// Runs the subcommand that was given.
pub(crate) fn run(arguments: &Arguments) -> anyhow::Result<Exit> {
    match &arguments.command {
        Command::Lint(lint) => lint::run(lint, arguments.color),
        Command::Fmt(fmt) => fmt::run(fmt, arguments.color),
        Command::Build(build) => build::run(build, arguments.color),
        Command::List(list) => list::run(list),
        Command::Mem(mem) => mem::run(mem, arguments.color),
        Command::Sim(sim) => sim::run(sim, arguments.color),
        Command::Repl(repl) => repl::run(repl, arguments.color),
        Command::Serve(serve) => serve::run(serve, arguments.color),
        Command::State(state) => state::run(state),
        Command::Term(term) => term::run(term, arguments.color),
        Command::Download(download) => download::run(download, arguments.color),
        Command::Upload(upload) => upload::run(upload, arguments.color),
        Command::Diff(diff) => diff::run(diff, arguments.color),
        Command::Get(get) => get::run(get, arguments.color),
        Command::Set(set) => set::run(set, arguments.color),
        Command::Move(order) => mov::run(order, arguments.color),
        Command::Watch(watch) => watch::run(watch, arguments.color),
        Command::ResetKamr(reset) => reset_kamr::run(reset, arguments.color),
        Command::Lsp(lsp) => lsp::run(lsp),
        Command::Explain(explain) => explain::run(explain),
    }
}
