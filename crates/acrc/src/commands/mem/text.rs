//! The account for a person: bars and aligned numbers.

use std::fmt::Write as _;

use acrc_analysis::memory::{
    Allocation, Calls, Exact, IssueKind, Part, ProgramReport, Report, Space, SystemBlock, SystemLine, grouped, space_of,
};

use super::Account;
use super::bar::{bar, percent};
use crate::output::Terminal;

/// Columns before a row.
const INDENT: &str = "  ";
/// Columns of the name of a row.
const NAME: usize = 14;
/// Columns of a number with its thousands set off.
const NUMBER: usize = 11;
/// The largest parts of a text that are shown.
const PARTS: usize = 5;

/// Where the account is shown.
pub(super) struct Page {
    pub(super) terminal: Terminal,
    pub(super) columns: usize,
}

impl Page {
    /// The account, ending in a line break.
    pub(super) fn render(&self, account: &Account<'_>) -> String {
        let mut text = String::new();
        self.system(&mut text, account);
        for program in &account.report.programs {
            self.program(&mut text, account, program);
        }
        self.refused(&mut text, account);
        self.exact(&mut text, account.report);
        text
    }

    /// A heading, with a remark at the right end of the line.
    fn heading(&self, text: &mut String, left: &str, right: &str, over: bool) {
        let line = if right.is_empty() {
            left.to_owned()
        } else {
            let gap = self.columns.saturating_sub(left.chars().count() + right.chars().count()).max(2);
            format!("{left}{}{right}", " ".repeat(gap))
        };
        let line = if over { self.terminal.error_word(&line) } else { self.terminal.heading(&line) };
        let _ = writeln!(text, "{line}");
    }

    /// A bar over the whole width, with the share behind it.
    fn bar(&self, text: &mut String, used: u64, total: u64) {
        let share = format!(" {:>7}", percent(used, total));
        let cells = self.columns.saturating_sub(INDENT.len() + share.len());
        let (full, empty) = bar(used, total, cells);
        let full = if used > total {
            self.terminal.error_word(&full)
        } else if used.saturating_mul(10) > total.saturating_mul(9) {
            self.terminal.warning_word(&full)
        } else {
            full
        };
        let empty = if empty.is_empty() { empty } else { self.terminal.faint(&empty) };
        let _ = writeln!(text, "{}", format!("{INDENT}{full}{empty}{share}").trim_end());
    }

    /// A name, a number, and what is to be said of it.
    fn row(text: &mut String, name: &str, bytes: &str, remark: &str) {
        let line = format!("{INDENT}{name:<NAME$}{bytes:>NUMBER$}  {remark}");
        let _ = writeln!(text, "{}", line.trim_end());
    }

    fn system(&self, text: &mut String, account: &Account<'_>) {
        let report = account.report;
        let total = format!("{} bytes", grouped(report.total));
        let left = format!("{}: system memory of an {}", account.title, report.model.name);
        self.heading(text, &left, &total, false);
        self.bar(text, report.used(), report.total);
        let has_text =
            |block: SystemBlock| report.programs.iter().any(|program| space_of(program.level) == Some(block));
        let (programs, others): (Vec<_>, Vec<_>) =
            report.system.iter().partition(|line| matches!(line.block, SystemBlock::Program(_) | SystemBlock::Plc(_)));
        let (stored, empty): (Vec<_>, Vec<_>) =
            programs.into_iter().partition(|line: &&SystemLine| has_text(line.block));
        self.spaces(text, "programs", &stored);
        self.spaces(text, "without text", &empty);
        for line in others {
            Self::row(text, &system_name(line), &unknown_or(line.bytes), &system_remark(report, line));
        }
        let remark = if report.is_open() { "at most; sizes are computed" } else { "" };
        Self::row(text, "free", &grouped(report.free()), remark);
    }

    /// Programs with what they have together, and their names.
    fn spaces(&self, text: &mut String, name: &str, lines: &[&SystemLine]) {
        if lines.is_empty() {
            return;
        }
        let known: u64 = lines.iter().filter_map(|line| line.bytes).sum();
        let is_open = lines.iter().any(|line| line.bytes.is_none());
        let mut names = ranges(lines);
        if lines.iter().all(|line| line.factory) {
            names.push_str(", factory settings");
        }
        if is_open && known > 0 {
            names.insert_str(0, &format!("at least {}: ", grouped(known)));
        }
        let room = self.columns.saturating_sub(INDENT.len() + NAME + NUMBER + 2);
        Self::row(text, name, &unknown_or((!is_open).then_some(known)), &shortened(&names, room));
    }

    fn program(&self, text: &mut String, account: &Account<'_>, program: &ProgramReport) {
        let needed = format!("{}{}", if program.is_open() { "at least " } else { "" }, grouped(program.needed()));
        let excess = program.excess();
        let (left, right) = match program.space {
            None => (format!("{}   {needed} bytes", program.level), "its space is computed".to_owned()),
            Some(Space::None) => (format!("{}   {needed} of 0 bytes", program.level), "it has no memory".to_owned()),
            Some(space) => {
                let right = if excess > 0 {
                    format!("{} bytes too many", grouped(excess))
                } else {
                    format!("{} free", grouped(space.bytes() - program.needed()))
                };
                (format!("{}   {needed} of {} bytes", program.level, grouped(space.bytes())), right)
            }
        };
        text.push('\n');
        self.heading(text, &left, &right, excess > 0);
        if let Some(space) = program.space {
            self.bar(text, program.needed(), space.bytes());
        }
        Self::text_rows(text, program);
        for allocation in &program.variables {
            Self::row(text, &allocation.name(), &unknown_or(allocation.bytes), allocation_remark(allocation));
        }
        match program.calls {
            Calls::Depth(0) => {}
            Calls::Depth(depth) => {
                let levels =
                    if depth == 1 { "1 level".to_owned() } else { format!("{} levels", grouped(depth.into())) };
                Self::row(text, "calls", &grouped(program.calls.bytes()), &levels);
            }
            Calls::Recursive => {
                Self::row(text, "calls", &grouped(program.calls.bytes()), "each level; a subroutine calls itself");
            }
        }
        self.parts(text, account, &program.parts);
    }

    fn text_rows(text: &mut String, program: &ProgramReport) {
        for (name, bytes) in program.text.kinds().into_iter().filter(|(_, bytes)| *bytes > 0) {
            Self::row(text, name, &grouped(bytes), "");
        }
    }

    /// The largest parts of a text, when it has several.
    fn parts(&self, text: &mut String, account: &Account<'_>, parts: &[Part]) {
        if parts.len() < 2 {
            return;
        }
        let _ = writeln!(text, "{INDENT}{}", self.terminal.faint("largest parts"));
        for part in parts.iter().take(PARTS) {
            let label = part.label.as_ref().map_or_else(|| "(beginning)".to_owned(), |label| format!("_{label}"));
            let place = part.place.map(|place| account.place(place)).unwrap_or_default();
            let name = format!("{INDENT}{}", shortened(&label, NAME - INDENT.len() - 1));
            Self::row(text, &name, &grouped(part.bytes), &self.terminal.faint(&place));
        }
    }

    fn refused(&self, text: &mut String, account: &Account<'_>) {
        let refused = &account.report.refused;
        if refused.is_empty() && account.errors.is_empty() {
            return;
        }
        text.push('\n');
        self.heading(text, "Refused by the controller", "", true);
        for (file, line, kind) in refused {
            let _ = writeln!(text, "{INDENT}{}: {}", account.place((*file, *line)), refusal(*kind));
        }
        for error in &account.errors {
            let _ = writeln!(text, "{INDENT}{}: {}", account.place((error.file, error.line)), error.message);
        }
    }

    fn exact(&self, text: &mut String, report: &Report) {
        let exact = report.exact();
        if exact.is_empty() {
            return;
        }
        text.push('\n');
        let total = exact.iter().map(Exact::bytes).sum();
        self.heading(text, "DIM statements that fit exactly", &format!("{} bytes", grouped(total)), false);
        for dim in &exact {
            let statement = format!("DIM {}({})", dim.block, dim.count);
            let remark = dim.open.map_or_else(String::new, |open| self.terminal.faint(&format!("'{open}")));
            let _ = writeln!(text, "{}", format!("{INDENT}{statement:<22}{remark}").trim_end());
        }
    }
}

fn system_name(line: &SystemLine) -> String {
    match line.count {
        Some(count) => format!("{}({count})", line.block),
        None => line.block.to_string(),
    }
}

fn system_remark(report: &Report, line: &SystemLine) -> String {
    let used = match line.block {
        SystemBlock::Aliases => report.aliases,
        SystemBlock::Parameters => report.parameters.count,
        _ => return String::new(),
    };
    let what = match (line.block, used) {
        (SystemBlock::Aliases, 0) => "none defined".to_owned(),
        (SystemBlock::Aliases, used) => format!("{} defined", grouped(used)),
        _ if report.parameters.computed => "numbers are computed".to_owned(),
        (_, 0) => "none used".to_owned(),
        (_, used) => format!("{} needed", grouped(used)),
    };
    match line.bytes {
        Some(_) => what,
        None => format!("{what}, its size is computed"),
    }
}

fn allocation_remark(allocation: &Allocation) -> &'static str {
    match (allocation.bytes, allocation.conditional) {
        (None, _) => "its size is computed",
        (Some(_), true) => "when its DIM is reached",
        (Some(_), false) => "",
    }
}

fn unknown_or(bytes: Option<u64>) -> String {
    bytes.map_or_else(|| "?".to_owned(), grouped)
}

/// Why a statement of the setup is refused.
fn refusal(kind: IssueKind) -> String {
    match kind {
        IssueKind::SystemExceeded { block, needed, free } => {
            format!("{block} wants {} bytes, {} are free", grouped(needed), grouped(free))
        }
        IssueKind::Redimensioned { block, .. } => format!("{block} has memory already; CLEAR comes first"),
        IssueKind::NoReference { class, array, .. } => {
            format!("{class}{array} has no reference; DIM {class}(n) comes first")
        }
        IssueKind::TooManyAliases { aliases, room } => {
            let noun = if aliases == 1 { "alias" } else { "aliases" };
            format!("{} {noun}, DEF has room for {}", grouped(aliases), grouped(room.unwrap_or(0)))
        }
        IssueKind::TooLarge { .. } | IssueKind::NotCleared(_) => String::new(),
    }
}

/// `PROG0, PROG2-PROG7`
fn ranges(lines: &[&SystemLine]) -> String {
    let number = |block: SystemBlock| match block {
        SystemBlock::Program(number) => Some(("PROG", number)),
        SystemBlock::Plc(number) => Some(("PLC", number)),
        _ => None,
    };
    let mut runs: Vec<(&str, u8, u8)> = Vec::new();
    for (word, number) in lines.iter().filter_map(|line| number(line.block)) {
        match runs.last_mut() {
            Some((other, _, last)) if *other == word && *last + 1 == number => *last = number,
            _ => runs.push((word, number, number)),
        }
    }
    let run = |(word, first, last): &(&str, u8, u8)| match last - first {
        0 => format!("{word}{first}"),
        1 => format!("{word}{first}, {word}{last}"),
        _ => format!("{word}{first} to {word}{last}"),
    };
    runs.iter().map(run).collect::<Vec<_>>().join(", ")
}

/// A text that is cut to so many columns.
fn shortened(text: &str, columns: usize) -> String {
    if text.chars().count() <= columns {
        return text.to_owned();
    }
    let kept: String = text.chars().take(columns.saturating_sub(1)).collect();
    format!("{kept}…")
}
