//! What a controller answers to a line.

use acrc_catalog::all_messages;
use acrc_syntax::units::Level;

use crate::LinkError;

/// What a controller answers to a line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Answer {
    /// The line that was sent, without its end.
    pub command: String,
    /// The lines between echo and prompt, without their ends.
    pub lines: Vec<String>,
    /// The level that the prompt names.
    pub prompt: Level,
}

impl Answer {
    /// The line that is known to be an error text: it begins with a message of the catalogue, in any case.
    ///
    /// No document lists the error texts of a controller, so a line that is not found here can be one as well: where
    /// nothing is to be answered ask [`Answer::silence`], where a number is, [`Answer::number`].
    pub fn refusal(&self) -> Option<&str> {
        self.lines.iter().map(String::as_str).find(|line| is_error_text(line))
    }

    /// Expects no lines, as of a command that reports nothing.
    ///
    /// # Errors
    /// [`LinkError::Refused`] with the first line, which is the error text of the controller.
    pub fn silence(&self) -> Result<(), LinkError> {
        match self.lines.iter().find(|line| !line.trim().is_empty()) {
            None => Ok(()),
            Some(text) => Err(self.refused(text)),
        }
    }

    /// Expects lines that are no known error texts.
    ///
    /// # Errors
    /// [`LinkError::Refused`] with the error text.
    pub fn report(&self) -> Result<&[String], LinkError> {
        match self.refusal() {
            None => Ok(&self.lines),
            Some(text) => Err(self.refused(text)),
        }
    }

    /// Expects one number.
    ///
    /// # Errors
    /// [`LinkError::Refused`] when a text stands in its place, [`LinkError::NotUnderstood`] when nothing does.
    pub fn number(&self) -> Result<f64, LinkError> {
        let mut texts = self.lines.iter().map(|line| line.trim()).filter(|line| !line.is_empty());
        match (texts.next(), texts.next()) {
            (Some(text), None) => parse_number(text).ok_or_else(|| self.refused(text)),
            (Some(text), Some(_)) if is_error_text(text) => Err(self.refused(text)),
            (None, _) => Err(self.not_understood("nothing".to_owned())),
            (Some(_), Some(_)) => Err(self.not_understood(format!("{} lines", self.lines.len()))),
        }
    }

    fn refused(&self, text: &str) -> LinkError {
        LinkError::Refused { line: self.command.clone(), text: text.trim().to_owned() }
    }

    fn not_understood(&self, answer: String) -> LinkError {
        LinkError::NotUnderstood { line: self.command.clone(), answer }
    }
}

/// Whether a line begins with an error text of the catalogue.
fn is_error_text(line: &str) -> bool {
    let line = line.trim_start();
    all_messages()
        .any(|message| line.get(..message.text.len()).is_some_and(|start| start.eq_ignore_ascii_case(message.text)))
}

/// Reads a number as a controller may print it: blanks around it, a sign, an exponent, a trailing point.
pub(crate) fn parse_number(text: &str) -> Option<f64> {
    let text = text.trim();
    let is_number = |byte: u8| byte.is_ascii_digit() || matches!(byte, b'+' | b'-' | b'.' | b'e' | b'E');
    // `inf` and `nan` are read by the standard library too, and are words here.
    text.bytes().all(is_number).then(|| text.parse().ok()).flatten()
}

/// The level that a prompt names: `SYS>`, `P00>`, `PLC3>`.
pub fn parse_prompt(text: &str) -> Option<Level> {
    let word = text.strip_suffix('>')?;
    if word == "SYS" {
        return Some(Level::System);
    }
    if let Some(digits) = word.strip_prefix("PLC") {
        return index(digits, 1).map(Level::Plc);
    }
    index(word.strip_prefix('P')?, 2).map(Level::Program)
}

/// A number of at least so many digits, and two at most.
fn index(digits: &str, least: usize) -> Option<u8> {
    let is_index = (least..=2).contains(&digits.len()) && digits.bytes().all(|byte| byte.is_ascii_digit());
    is_index.then(|| digits.parse().ok()).flatten()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn answer(lines: &[&str]) -> Answer {
        let lines = lines.iter().map(ToString::to_string).collect();
        Answer { command: "?P12288".to_owned(), lines, prompt: Level::System }
    }

    #[test]
    fn prompts_name_levels() {
        assert_eq!(parse_prompt("SYS>"), Some(Level::System));
        assert_eq!(parse_prompt("P00>"), Some(Level::Program(0)));
        assert_eq!(parse_prompt("P15>"), Some(Level::Program(15)));
        assert_eq!(parse_prompt("PLC7>"), Some(Level::Plc(7)));
        for text in ["P1>", "P+1>", "P00", "PLC>", "P123>", "sys>", "SYS> ", ">", ""] {
            assert_eq!(parse_prompt(text), None, "{text}");
        }
    }

    #[test]
    fn numbers_are_read_as_controllers_may_print_them() {
        for (text, value) in [("4000", 4000.0), (" -1 ", -1.0), ("1.5e-7", 1.5e-7), ("+3.", 3.0), (".5", 0.5)] {
            assert_eq!(answer(&[text]).number().ok(), Some(value), "{text}");
        }
        assert_eq!(answer(&["", "7", ""]).number().ok(), Some(7.0));
        for text in ["nan", "inf", "1 2", "Unknown Command", "0x10"] {
            assert!(matches!(answer(&[text]).number(), Err(LinkError::Refused { .. })), "{text}");
        }
        assert!(matches!(answer(&[]).number(), Err(LinkError::NotUnderstood { .. })));
        assert!(matches!(answer(&["1", "2"]).number(), Err(LinkError::NotUnderstood { .. })));
    }

    #[test]
    fn error_texts_are_those_of_the_catalogue() {
        assert_eq!(answer(&["X 1", "unknown command."]).refusal(), Some("unknown command."));
        assert_eq!(answer(&["10 REM Unknown Command"]).refusal(), None);
        assert!(answer(&[]).silence().is_ok());
        let refused = answer(&["anything"]).silence().unwrap_err().to_string();
        assert_eq!(refused, "the controller refused `?P12288`: anything");
    }
}
