//! Finding the prompt at the end of what a controller sends.

use acrc_link::{parse_prompt, split_prompt};
use acrc_syntax::units::Level;

/// What a controller has sent since a line was typed, as far as it is not shown yet.
#[derive(Debug)]
pub(super) struct Tail {
    /// The echo that is still to come; the line stands on the screen already.
    echo: Option<String>,
    text: String,
    /// What is shown ends in the middle of a line.
    open: bool,
}

impl Tail {
    /// Behind a line that was typed; with `echo` the controller repeats it first.
    pub(super) fn new(line: &str, echo: bool) -> Self {
        Self { echo: echo.then(|| format!("{line}\r\n")), text: String::new(), open: false }
    }

    /// Takes in what has come, and gives what can be shown: whole lines.
    pub(super) fn take(&mut self, text: &str) -> String {
        self.text.push_str(text);
        if let Some(echo) = &self.echo {
            match self.text.strip_prefix(echo.as_str()) {
                Some(rest) => self.text = rest.to_owned(),
                None if echo.starts_with(&self.text) => return String::new(),
                // The controller sends something else first, which is shown as it is.
                None => {}
            }
            self.echo = None;
        }
        let end = self.text.rfind('\n').map_or(0, |place| place + 1);
        let rest = self.text.split_off(end);
        let shown = std::mem::replace(&mut self.text, rest);
        self.open &= shown.is_empty();
        shown
    }

    /// What is not shown is a prompt.
    pub(super) fn prompt(&self) -> Option<Level> {
        parse_prompt(&self.text)
    }

    /// Gives the beginning of a line and the level of the prompt behind it, since nothing more came.
    pub(super) fn take_prompt(&mut self) -> Option<(String, Level)> {
        let (open, level) = split_prompt(&self.text).filter(|_| self.echo.is_none())?;
        let open = open.to_owned();
        self.text.clear();
        self.open |= !open.is_empty();
        Some((open, level))
    }

    /// Gives the beginning of a line, since nothing more came.
    pub(super) fn take_open(&mut self) -> String {
        if self.echo.is_some() {
            return String::new();
        }
        self.open |= !self.text.is_empty();
        std::mem::take(&mut self.text)
    }

    /// What is shown ends in the middle of a line, and the prompt would stand behind it.
    pub(super) fn is_open(&self) -> bool {
        self.open
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_shown_and_the_prompt_is_not() {
        let mut tail = Tail::new("LIST", true);
        let shown: Vec<String> = ["LI", "ST\r", "\n10 X5\r\n20", " Y5\r\nP0", "0>"].map(|text| tail.take(text)).into();
        assert_eq!(shown, ["", "", "10 X5\r\n", "20 Y5\r\n", ""]);
        assert_eq!(tail.prompt(), Some(Level::Program(0)));
        assert!(!tail.is_open());
    }

    #[test]
    fn an_open_line_is_shown_when_nothing_more_comes() {
        let mut tail = Tail::new("? \"a\";", false);
        assert_eq!(tail.take("wait"), "");
        assert_eq!(tail.prompt(), None);
        assert_eq!(tail.take_open(), "wait");
        assert_eq!(tail.take("SYS>"), "");
        assert_eq!((tail.prompt(), tail.is_open()), (Some(Level::System), true));
    }

    #[test]
    fn a_prompt_may_stand_behind_an_open_line() {
        let mut tail = Tail::new("? \"ab\";", true);
        assert_eq!(tail.take("? \"ab\";\r\nabP01>"), "");
        assert_eq!(tail.prompt(), None);
        assert_eq!(tail.take_prompt(), Some(("ab".to_owned(), Level::Program(1))));
        assert!(tail.is_open());
    }

    #[test]
    fn another_text_than_the_echo_is_shown() {
        let mut tail = Tail::new("VEL", true);
        assert_eq!(tail.take("late\r\nSYS>"), "late\r\n");
        assert_eq!(tail.prompt(), Some(Level::System));
    }
}
