//! Cutting what a controller sends into answers.
//!
//! The end of an answer is the prompt, which nothing follows. Where the controller echoes, an answer begins behind the
//! echo of its line, so that a prompt or text from before is never taken for it.

use acrc_syntax::units::Level;

use crate::parse_prompt;

/// The longest prompt: `PLC10>`.
const LONGEST_PROMPT: usize = 6;

/// How far an answer has come.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Progress {
    /// There is more to come.
    Partial,
    /// A prompt stands behind text that does not end its line. Only that nothing follows shows that it is one.
    MaybeWhole(Vec<String>, Level),
    /// The prompt is there.
    Whole(Vec<String>, Level),
}

/// Looks at what has come since a line was sent.
///
/// With `echo` the answer begins behind the echo of the line, wherever that is.
pub(crate) fn progress(text: &str, line: &str, echo: bool) -> Progress {
    let body = if echo { behind_echo(text, line) } else { Some(text) };
    let Some(body) = body else { return Progress::Partial };
    let last = body.rfind('\n').map_or(0, |place| place + 1);
    let (lines, tail) = body.split_at(last);
    // Only now, since a long answer is looked at often before its prompt is there.
    let lines = || lines.lines().map(|line| line.trim_end_matches('\r').to_owned());
    if let Some(level) = parse_prompt(tail) {
        return Progress::Whole(lines().collect(), level);
    }
    match split_prompt(tail) {
        Some((open, level)) => Progress::MaybeWhole(lines().chain([open.to_owned()]).collect(), level),
        None => Progress::Partial,
    }
}

/// Whether the last line of a text is a prompt.
pub(crate) fn is_at_prompt(text: &str) -> bool {
    parse_prompt(text.rsplit('\n').next().unwrap_or_default()).is_some()
}

/// What stands in front of a prompt at the end of a text, and the level of the prompt. Text may look like one: `(P12>`.
pub fn split_prompt(text: &str) -> Option<(&str, Level)> {
    let from = text.len().saturating_sub(LONGEST_PROMPT);
    let mut places = text.char_indices().map(|(place, _)| place).filter(|place| *place >= from);
    places.find_map(|place| {
        let (open, prompt) = text.split_at_checked(place)?;
        Some((open, parse_prompt(prompt)?))
    })
}

/// What follows the echo of a line and its end.
fn behind_echo<'a>(text: &'a str, line: &str) -> Option<&'a str> {
    let mut from = 0;
    loop {
        let rest = text.get(from..)?;
        let place = from + rest.find(line)?;
        let before = text.get(..place)?;
        let after = text.get(place + line.len()..)?;
        let begins = before.is_empty() || before.ends_with(['\n', '\r', '>']);
        let behind = after.strip_prefix("\r\n").or_else(|| after.strip_prefix('\n'));
        match behind {
            Some(behind) if begins => return Some(behind),
            _ => from = place + rest_step(text, place)?,
        }
    }
}

/// Length of the character at a place.
fn rest_step(text: &str, place: usize) -> Option<usize> {
    text.get(place..)?.chars().next().map(char::len_utf8)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn whole(lines: &[&str], level: Level) -> Progress {
        Progress::Whole(lines.iter().map(ToString::to_string).collect(), level)
    }

    #[test]
    fn an_answer_lies_between_echo_and_prompt() {
        let text = "AXIS0 PPU\r\n4000\r\nP00>";
        assert_eq!(progress(text, "AXIS0 PPU", true), whole(&["4000"], Level::Program(0)));
        for end in 0..text.len() {
            assert_eq!(progress(&text[..end], "AXIS0 PPU", true), Progress::Partial, "{end}");
        }
        assert_eq!(progress("VEL 5\r\nSYS>", "VEL 5", true), whole(&[], Level::System));
        assert_eq!(progress("\r\nSYS>", "", true), whole(&[], Level::System));
    }

    #[test]
    fn what_came_before_the_echo_is_dropped() {
        assert_eq!(progress("\r\nSYS>SYS>?P1\r\n7\r\nSYS>", "?P1", true), whole(&["7"], Level::System));
        assert_eq!(progress("late?P1 text\r\nSYS>", "?P1", true), Progress::Partial);
    }

    #[test]
    fn without_an_echo_the_prompt_alone_ends_an_answer() {
        assert_eq!(progress("7\r\nSYS>", "?P1", false), whole(&["7"], Level::System));
        assert_eq!(progress("7\r\n", "?P1", false), Progress::Partial);
    }

    #[test]
    fn a_prompt_behind_an_open_line_is_doubtful() {
        let open = Progress::MaybeWhole(vec!["ab".to_owned()], Level::Program(0));
        assert_eq!(progress("? \"ab\";\r\nabP00>", "? \"ab\";", true), open);
        assert_eq!(progress("LIST\r\n10 IF (P12>", "LIST", true).clone(), {
            Progress::MaybeWhole(vec!["10 IF (".to_owned()], Level::Program(12))
        });
        assert_eq!(progress("LIST\r\n10 IF (P12>5)", "LIST", true), Progress::Partial);
    }
}
