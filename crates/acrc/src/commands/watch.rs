//! `acrc watch`: values of a controller while they change.

use std::io::{self, IsTerminal as _};
use std::time::{Duration, Instant};

use acrc_link::fast_status::{Layout, Subscriber, groups_for, read_groups, set_groups};
use acrc_link::values::{Named, Register, Value, read};
use acrc_link::{Connection, LinkError, Protocol, Tcp};
use anyhow::{Context as _, bail};
use serde_json::{Value as Json, json};

use super::get::as_json;
use super::link::{connect, failed, interrupted, names, watch_interrupt};
use crate::cli::{ColorChoice, WatchArguments};
use crate::exit::Exit;
use crate::output::{Terminal, nobody_reads, print};

/// A person sees no more than so many tables in a second.
const REDRAW: Duration = Duration::from_millis(100);
/// Ctrl-C is looked for so often while nothing is due.
const BEAT: Duration = Duration::from_millis(50);

pub(super) fn run(arguments: &WatchArguments, color: ColorChoice) -> anyhow::Result<Exit> {
    let terminal = Terminal::error(color);
    let Some(names) = names(&arguments.naming, terminal)? else { return Ok(Exit::Failure) };
    let mut named = Vec::new();
    for name in &arguments.names {
        named.extend(names.find(name)?);
    }
    watch_interrupt()?;
    // Fast status needs no packets, only the text of the settings.
    let usual = if arguments.fast.fast_status { Protocol::Text } else { Protocol::Mixed };
    let mut connection = match connect(&arguments.to, usual) {
        Ok(connection) => connection,
        Err(error) => return Ok(failed(error, terminal)),
    };
    let mut sheet = Sheet::new(arguments, &named, Terminal::output(color));
    let mut account = Account::default();
    sheet.head()?;
    let result = if arguments.fast.fast_status {
        subscribe(arguments, &mut connection, &named, &mut sheet, &mut account)
    } else {
        sample(arguments, &mut connection, &named, &mut sheet, &mut account)
    };
    sheet.end()?;
    if account.samples > 0 {
        crate::exit::note(&account.to_string(), terminal);
    }
    match result? {
        Ok(exit) => Ok(exit),
        Err(error) => Ok(failed(error, terminal)),
    }
}

/// Samples until the time is over. The outer error is that of the output, the inner one of the connection.
fn sample(
    arguments: &WatchArguments,
    connection: &mut Connection<Tcp>,
    named: &[Named],
    sheet: &mut Sheet<'_>,
    account: &mut Account,
) -> anyhow::Result<Result<Exit, LinkError>> {
    let registers: Vec<Register> = named.iter().map(|named| named.register).collect();
    let begun = Instant::now();
    let mut due = begun;
    loop {
        let asked = Instant::now();
        let values = match read(connection, &registers) {
            Ok(values) => values,
            Err(LinkError::Interrupted) => return Ok(Ok(ended(arguments))),
            Err(error) => return Ok(Err(error)),
        };
        let since = asked.duration_since(begun);
        account.add(since, asked.elapsed());
        sheet.add(since, &values)?;
        if nobody_reads() {
            return Ok(Ok(Exit::Clean));
        }
        due += arguments.every;
        let late = Instant::now().saturating_duration_since(due);
        // What is past cannot be sampled any more; the others keep their times.
        let missed = (late.as_nanos() / arguments.every.as_nanos()) as u32;
        account.missed += u64::from(missed);
        due += arguments.every * missed;
        if arguments.span.is_some_and(|span| due.duration_since(begun) > span) {
            return Ok(Ok(Exit::Clean));
        }
        if !wait_until(due) {
            return Ok(Ok(ended(arguments)));
        }
    }
}

/// Shows what the controller sends by itself. The inner error is that of the connection.
fn subscribe(
    arguments: &WatchArguments,
    connection: &mut Connection<Tcp>,
    named: &[Named],
    sheet: &mut Sheet<'_>,
    account: &mut Account,
) -> anyhow::Result<Result<Exit, LinkError>> {
    let registers: Vec<Register> = named.iter().map(|named| named.register).collect();
    let groups = if arguments.fast.set_groups {
        let groups = groups_for(&registers)?;
        set_groups(connection, &groups).map(|()| groups)
    } else {
        read_groups(connection)
    };
    let groups = match groups {
        Ok(groups) => groups,
        Err(error) => return Ok(Err(error)),
    };
    let layout = Layout::find(&registers, &groups).context("--set-groups would set the groups")?;
    let milliseconds = u32::try_from(arguments.every.as_millis()).ok().filter(|every| *every > 0);
    let milliseconds = milliseconds.context("--every: fast status comes every 1 ms or slower")?;
    let host = &arguments.to.to;
    let subscriber = Subscriber::new(host, arguments.fast.fast_port, milliseconds).context("fast status")?;
    let (mut begun, mut last): (Option<Instant>, Option<Instant>) = (None, None);
    loop {
        if interrupted() {
            return Ok(Ok(ended(arguments)));
        }
        let status = subscriber.receive(BEAT).context("fast status")?;
        let now = Instant::now();
        let waited = now.duration_since(*last.get_or_insert(now));
        let Some(status) = status else {
            if waited > arguments.to.timeout.max(2 * arguments.every) {
                bail!(
                    "no fast status came for {} s: the controller has five clients, or a firewall is between",
                    waited.as_secs()
                );
            }
            continue;
        };
        last = Some(now);
        let since = now.duration_since(*begun.get_or_insert(now));
        if account.samples > 0 {
            // One that comes a little late is none that is missing.
            let intervals = (waited.as_secs_f64() / arguments.every.as_secs_f64()).round() as u64;
            account.missed += intervals.saturating_sub(1);
        }
        account.add(since, waited);
        sheet.add(since, &layout.values(&status))?;
        if nobody_reads() || arguments.span.is_some_and(|span| since >= span) {
            return Ok(Ok(Exit::Clean));
        }
    }
}

/// How Ctrl-C ends it: without `--for` there is no other way.
fn ended(arguments: &WatchArguments) -> Exit {
    if arguments.span.is_none() { Exit::Clean } else { Exit::Interrupted }
}

/// Waits for a time. False when the user gave up.
fn wait_until(due: Instant) -> bool {
    loop {
        if interrupted() {
            return false;
        }
        let left = due.saturating_duration_since(Instant::now());
        if left.is_zero() {
            return true;
        }
        std::thread::sleep(left.min(BEAT));
    }
}

/// How the sampling went.
#[derive(Debug, Default)]
struct Account {
    samples: u64,
    missed: u64,
    last: Duration,
    slowest: Duration,
}

impl Account {
    fn add(&mut self, since: Duration, took: Duration) {
        self.samples += 1;
        self.last = since;
        self.slowest = self.slowest.max(took);
    }
}

impl std::fmt::Display for Account {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let plural = if self.samples == 1 { "" } else { "s" };
        write!(f, "{} sample{plural} in {:.3} s", self.samples, self.last.as_secs_f64())?;
        if self.samples > 1 && !self.last.is_zero() {
            write!(f, ", {:.1} a second", (self.samples - 1) as f64 / self.last.as_secs_f64())?;
        }
        write!(f, ", {} missed, the longest wait {:.1} ms", self.missed, self.slowest.as_secs_f64() * 1e3)
    }
}

/// How samples are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    Table,
    Csv,
    Json,
}

/// Where samples are shown.
struct Sheet<'a> {
    form: Form,
    named: &'a [Named],
    terminal: Terminal,
    /// The table has been drawn, so that the next one goes over it.
    drawn: Option<Instant>,
    last: Vec<Value>,
}

impl<'a> Sheet<'a> {
    fn new(arguments: &WatchArguments, named: &'a [Named], terminal: Terminal) -> Self {
        let form = match (arguments.json, arguments.csv || !io::stdout().is_terminal()) {
            (true, _) => Form::Json,
            (_, true) => Form::Csv,
            (_, false) => Form::Table,
        };
        Self { form, named, terminal, drawn: None, last: Vec::new() }
    }

    fn head(&self) -> anyhow::Result<()> {
        if self.form != Form::Csv {
            return Ok(());
        }
        let names: Vec<&str> = self.named.iter().map(|named| named.name.as_str()).collect();
        print(|out| writeln!(out, "seconds,{}", names.join(",")))
    }

    fn add(&mut self, since: Duration, values: &[Value]) -> anyhow::Result<()> {
        let seconds = since.as_secs_f64();
        match self.form {
            Form::Csv => {
                let values: Vec<String> = values.iter().map(ToString::to_string).collect();
                print(|out| writeln!(out, "{seconds:.6},{}", values.join(",")))
            }
            Form::Json => {
                let values = self.named.iter().zip(values).filter_map(|(named, value)| {
                    Some((named.name.clone(), as_json(named, *value).get("value")?.clone()))
                });
                let values: serde_json::Map<String, Json> = values.collect();
                let seconds = (seconds * 1e6).round() / 1e6;
                print(|out| writeln!(out, "{}", json!({ "seconds": seconds, "values": values })))
            }
            Form::Table => {
                values.clone_into(&mut self.last);
                if self.drawn.is_none_or(|drawn| drawn.elapsed() >= REDRAW) { self.draw() } else { Ok(()) }
            }
        }
    }

    /// Draws the table over the last one.
    fn draw(&mut self) -> anyhow::Result<()> {
        let up = if self.drawn.is_some() { format!("\u{1b}[{}A", self.named.len()) } else { String::new() };
        self.drawn = Some(Instant::now());
        let width = self.named.iter().map(|named| named.name.len()).max().unwrap_or_default();
        print(|out| {
            write!(out, "{up}")?;
            self.named.iter().zip(&self.last).try_for_each(|(named, value)| {
                let title = self.terminal.faint(&named.register.title());
                // The rest of a longer line from before is wiped away.
                writeln!(out, "{:width$}  {:>15}  {title}\u{1b}[K", named.name, value.to_string())
            })?;
            out.flush()
        })
    }

    /// Shows what came after the last table.
    fn end(&mut self) -> anyhow::Result<()> {
        if self.drawn.is_some() { self.draw() } else { Ok(()) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_account_says_how_it_went() {
        let mut account = Account::default();
        account.add(Duration::ZERO, Duration::from_millis(2));
        assert_eq!(account.to_string(), "1 sample in 0.000 s, 0 missed, the longest wait 2.0 ms");
        account.add(Duration::from_millis(500), Duration::from_micros(500));
        account.missed = 3;
        assert_eq!(account.to_string(), "2 samples in 0.500 s, 2.0 a second, 3 missed, the longest wait 2.0 ms");
    }
}
