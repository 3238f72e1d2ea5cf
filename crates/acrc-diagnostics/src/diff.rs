//! The difference of two texts, in the unified format that `patch` and `git apply` take.

use std::borrow::Cow;
use std::fmt::Write as _;
use std::io::{self, Write};

use ariadne::{Color, Fmt as _};
use similar::udiff::UnifiedDiffHunk;
use similar::{ChangeTag, TextDiff};

use crate::path::repository_path;
use crate::plain::visible;

/// Number of unchanged lines around a change.
const CONTEXT: usize = 3;

/// Writes what turns `old` into `new`; nothing when they are equal.
///
/// Both headers have the plain `name` with forward slashes, so the result is taken by `patch -p0` and `git apply -p0`
/// where the names of the files lead to them. Lines are told apart by LF alone, as those tools do, and come out byte for
/// byte, a CR before the LF included.
///
/// With `color` the result is for a person's eyes: it has escape sequences, and characters that a terminal would obey are
/// replaced by visible ones.
pub fn unified_diff(name: &str, old: &str, new: &str, color: bool, out: &mut dyn Write) -> io::Result<()> {
    let lines = |text| str::split_inclusive(text, '\n').collect::<Vec<_>>();
    let (old_lines, new_lines) = (lines(old), lines(new));
    let diff = TextDiff::configure().newline_terminated(true).diff_slices(&old_lines, &new_lines);

    let painter = Painter { color };
    let name = header_name(name);
    let mut headers = [("---", Color::Red), ("+++", Color::Green)].into_iter();
    for hunk in diff.unified_diff().context_radius(CONTEXT).iter_hunks() {
        for (mark, color) in headers.by_ref() {
            painter.line(&format!("{mark} {name}"), "\n", Some(color), out)?;
        }
        write_hunk(&hunk, painter, out)?;
    }
    Ok(())
}

fn write_hunk(hunk: &UnifiedDiffHunk<'_, '_, '_, str>, painter: Painter, out: &mut dyn Write) -> io::Result<()> {
    painter.line(&hunk.header().to_string(), "\n", Some(Color::Cyan), out)?;
    for change in hunk.iter_changes() {
        let color = match change.tag() {
            ChangeTag::Delete => Some(Color::Red),
            ChangeTag::Insert => Some(Color::Green),
            ChangeTag::Equal => None,
        };
        let line: &str = change.value();
        let content = line.strip_suffix('\n').unwrap_or(line);
        let (content, end) = match content.strip_suffix('\r') {
            Some(content) if content.len() + 2 == line.len() => (content, "\r\n"),
            _ => (content, "\n"),
        };
        painter.line(&format!("{}{content}", change.tag()), end, color, out)?;
        if !line.ends_with('\n') {
            painter.line("\\ No newline at end of file", "\n", None, out)?;
        }
    }
    Ok(())
}

#[derive(Clone, Copy)]
struct Painter {
    color: bool,
}

impl Painter {
    fn line(self, text: &str, end: &str, color: Option<Color>, out: &mut dyn Write) -> io::Result<()> {
        if !self.color {
            return write!(out, "{text}{end}");
        }
        let plain: String = text.chars().map(|c| if c == '\t' { c } else { visible(c) }).collect();
        write!(out, "{}{end}", plain.fg(color))
    }
}

/// The name as both headers give it. One with a space is followed by a tab, after which `patch` expects a date; one that
/// would break the line or look quoted is quoted as in C.
fn header_name(name: &str) -> Cow<'_, str> {
    let path = repository_path(name);
    if path.contains(|c: char| c.is_ascii_control() || c == '"') {
        return Cow::Owned(quoted(&path));
    }
    if path.contains(' ') { Cow::Owned(format!("{path}\t")) } else { path }
}

fn quoted(path: &str) -> String {
    let mut text = String::from("\"");
    for c in path.chars() {
        match c {
            '"' => text.push_str("\\\""),
            // Writing to a string does not fail.
            c if c.is_ascii_control() => drop(write!(text, "\\{:03o}", c as u32)),
            c => text.push(c),
        }
    }
    text.push('"');
    text
}
