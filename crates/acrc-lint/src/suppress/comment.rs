//! Comments that suppress findings, as they are written:
//!
//! ```text
//! ' acrc: allow(undefined-label) -- the host adds the label
//! GOTO Recipe
//! SET 32 : REM acrc: allow(ACR301, ACR302): checked at the machine
//! ' acrc: allow-file(unused-label)
//! ```

use acrc_analysis::nearest;
use acrc_diagnostics::Span;

/// What a comment for this tool begins with.
const MARK: &str = "acrc:";
/// The same without what is easily forgotten.
const BARE_MARK: &str = "acrc";
/// What may stand behind it.
const WORDS: [&str; 3] = ["allow", "allow-file", FORMATTER];
/// Belongs to the formatter.
const FORMATTER: &str = "fmt";
/// What the formatter is told.
const SWITCHES: [&str; 2] = ["off", "on"];

/// For which findings a comment is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scope {
    /// Those of a line.
    Line,
    /// Those of the file.
    File,
}

/// A comment with the rules that it allows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Allow {
    pub(crate) scope: Scope,
    /// The list with its parentheses.
    pub(crate) list: Span,
    /// The names in it.
    pub(crate) names: Vec<Span>,
}

/// Something in such a comment that is not understood.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Mistake {
    pub(crate) span: Span,
    pub(crate) message: String,
    pub(crate) help: String,
}

/// Reads the text of a comment, which begins at `offset`. One that is `alone` has a line of its own. A comment that is
/// not for this linter gives nothing.
pub(crate) fn read(text: &str, offset: u32, alone: bool) -> (Option<Allow>, Option<Mistake>) {
    let mut reader = Reader { text, at: 0, offset };
    reader.skip_blanks();
    let from = reader.at;
    if !reader.rest().get(..MARK.len()).is_some_and(|mark| mark.eq_ignore_ascii_case(MARK)) {
        return (None, reader.wrong_mark());
    }
    reader.at += MARK.len();
    reader.skip_blanks();
    let word = reader.word();
    let scope = match reader.slice(word).to_ascii_lowercase().as_str() {
        FORMATTER => return (None, reader.switch(from, alone)),
        "allow" => Scope::Line,
        "allow-file" => Scope::File,
        other => return (None, Some(unknown_word(reader.whole(from), other))),
    };
    reader.skip_blanks();
    let Some(list) = reader.list() else {
        let open = reader.rest().starts_with('(');
        return (None, Some(if open { no_end(reader.whole(from), scope) } else { no_list(reader.whole(from), scope) }));
    };
    let names = reader.names(list);
    if names.is_empty() {
        return (None, Some(no_list(reader.whole(from), scope)));
    }
    reader.skip_blanks();
    let rest = reader.rest().trim_end();
    let is_reason = rest.is_empty() || rest.starts_with("--") || rest.starts_with(':');
    let mistake = (!is_reason).then(|| Mistake {
        span: Span::new(reader.place(reader.at), reader.place(reader.at + rest.len())),
        message: "text follows the list of rules".to_owned(),
        help: format!("set a reason off with two dashes: `-- {rest}`"),
    });
    (Some(Allow { scope, list, names }), mistake)
}

fn unknown_word(span: Span, word: &str) -> Mistake {
    let message = if word.is_empty() {
        "nothing stands behind `acrc:`".to_owned()
    } else {
        format!("`{word}` is no order to acrc")
    };
    let help = match nearest(word, WORDS) {
        Some(near) => format!("did you mean `{near}`?"),
        None => "write `acrc: allow(RULE)`, `acrc: allow-file(RULE)`, `acrc: fmt off` or `acrc: fmt on`".to_owned(),
    };
    Mistake { span, message, help }
}

fn no_list(span: Span, scope: Scope) -> Mistake {
    let word = scope.word();
    Mistake {
        span,
        message: format!("`acrc: {word}` names no rule in parentheses"),
        help: format!("name the rules in parentheses: `acrc: {word}(undefined-label, ACR103)`"),
    }
}

fn no_end(span: Span, scope: Scope) -> Mistake {
    Mistake {
        span,
        message: format!("the list of `acrc: {}` is not closed, so that nothing is suppressed", scope.word()),
        help: "write `)` behind the last rule".to_owned(),
    }
}

impl Scope {
    fn word(self) -> &'static str {
        match self {
            Self::Line => "allow",
            Self::File => "allow-file",
        }
    }
}

struct Reader<'t> {
    text: &'t str,
    at: usize,
    offset: u32,
}

impl<'t> Reader<'t> {
    fn rest(&self) -> &'t str {
        self.text.get(self.at..).unwrap_or_default()
    }

    fn place(&self, at: usize) -> u32 {
        self.offset + at as u32
    }

    /// The text of a span.
    fn slice(&self, span: Span) -> &'t str {
        let at = |place: u32| (place - self.offset) as usize;
        self.text.get(at(span.start)..at(span.end)).unwrap_or_default()
    }

    /// From `from` to the last character that is no blank.
    fn whole(&self, from: usize) -> Span {
        Span::new(self.place(from), self.place(self.text.trim_end().len()))
    }

    fn skip_blanks(&mut self) {
        self.at += self.rest().len() - self.rest().trim_start().len();
    }

    fn word(&mut self) -> Span {
        let start = self.at;
        let rest = self.rest();
        self.at += rest.find(|c: char| !c.is_ascii_alphabetic() && c != '-').unwrap_or(rest.len());
        Span::new(self.place(start), self.place(self.at))
    }

    /// What is wrong with an order to the formatter, which does nothing then.
    fn switch(&self, from: usize, alone: bool) -> Option<Mistake> {
        let rest = self.rest().trim();
        let mistake = |message: String, help: String| Some(Mistake { span: self.whole(from), message, help });
        match SWITCHES.iter().find(|switch| switch.eq_ignore_ascii_case(rest)) {
            Some(_) if alone => None,
            Some(switch) => mistake(
                format!("`acrc: fmt {switch}` stands behind statements, where the formatter does not see it"),
                "write it on a line of its own".to_owned(),
            ),
            None => {
                let message = if rest.is_empty() {
                    "`acrc: fmt` says neither on nor off".to_owned()
                } else {
                    format!("`{rest}` is no order to the formatter")
                };
                let help = match nearest(&rest.to_ascii_lowercase(), SWITCHES) {
                    Some(near) => format!("did you mean `acrc: fmt {near}`?"),
                    None => "write `acrc: fmt off` or `acrc: fmt on`, and nothing behind it".to_owned(),
                };
                mistake(message, help)
            }
        }
    }

    /// A comment that would be one for acrc, were its first word not misspelt.
    fn wrong_mark(&self) -> Option<Mistake> {
        let rest = self.rest();
        let (mark, behind) = rest.split_at(rest.find(|c: char| !c.is_ascii_alphanumeric())?);
        let lower = mark.to_ascii_lowercase();
        if lower != BARE_MARK && nearest(&lower, [BARE_MARK]).is_none() {
            return None;
        }
        let order = behind.trim_start_matches(|c: char| c.is_whitespace() || c == ':');
        let end = order.find(|c: char| !c.is_ascii_alphabetic() && c != '-').unwrap_or(order.len());
        let (word, end) = order.split_at(end);
        let word = WORDS.into_iter().find(|known| known.eq_ignore_ascii_case(word))?;
        // Else it may be a sentence about a tool.
        let is_order = if word == FORMATTER {
            SWITCHES.iter().any(|switch| switch.eq_ignore_ascii_case(end.trim()))
        } else {
            end.trim_start().starts_with('(')
        };
        is_order.then(|| Mistake {
            span: self.whole(self.at),
            message: "the comment is not read: `acrc:` begins those that are".to_owned(),
            help: format!("write `acrc: {}`", order.trim_end()),
        })
    }

    /// Passes a list in parentheses.
    fn list(&mut self) -> Option<Span> {
        let end = self.rest().strip_prefix('(')?.find(')')? + 2;
        let start = self.at;
        self.at += end;
        Some(Span::new(self.place(start), self.place(self.at)))
    }

    fn names(&self, list: Span) -> Vec<Span> {
        let inner = Span::new(list.start + 1, list.end - 1);
        let mut start = inner.start;
        let mut names = Vec::new();
        for part in self.slice(inner).split(',') {
            let lead = (part.len() - part.trim_start().len()) as u32;
            let name = part.trim();
            if !name.is_empty() {
                names.push(Span::new(start + lead, start + lead + name.len() as u32));
            }
            start += part.len() as u32 + 1;
        }
        names
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(text: &str) -> Vec<&str> {
        let (allow, mistake) = read(text, 0, true);
        assert_eq!(mistake, None, "{text}");
        allow.map_or(Vec::new(), |allow| allow.names.iter().map(|name| &text[name.range()]).collect())
    }

    #[test]
    fn names_stand_in_parentheses() {
        assert_eq!(names("acrc: allow(a)"), ["a"]);
        assert_eq!(names("  ACRC:Allow ( a ,ACR101, ) -- why (not)"), ["a", "ACR101"]);
        assert_eq!(names("acrc: allow-file(a): why"), ["a"]);
        assert_eq!(names(" acrc: fmt off"), [""; 0]);
        for text in ["about acrc: allow(a)", "acrc fmt is run before", "acre: fmt", "acrc allows it", "acrc"] {
            assert_eq!(names(text), [""; 0], "{text}");
        }
        assert_eq!(names(""), [""; 0]);
    }

    #[test]
    fn what_is_not_understood_is_said() {
        for (text, place, expected) in [
            ("acrc:", "acrc:", "nothing stands behind"),
            ("acrc: alow(a)", "acrc: alow(a)", "`alow` is no order"),
            ("acrc: allow", "acrc: allow", "names no rule"),
            (" acrc: allow( , ) ", "acrc: allow( , )", "names no rule"),
            ("acrc: allow(a", "acrc: allow(a", "is not closed"),
            ("acrc: allow a", "acrc: allow a", "names no rule"),
            ("acrc: fmt offf", "acrc: fmt offf", "`offf` is no order to the formatter"),
            ("acrc: fmt", "acrc: fmt", "neither on nor off"),
            ("acrc: fmt off -- why", "acrc: fmt off -- why", "no order to the formatter"),
            ("acrc: fmt on ", "acrc: fmt on", "behind statements"),
            (" acrc fmt OFF", "acrc fmt OFF", "is not read"),
            ("acrc : allow(a)", "acrc : allow(a)", "is not read"),
            ("arcc: allow-file (a)", "arcc: allow-file (a)", "is not read"),
            ("acrc: allow(a) because \u{e4}", "because \u{e4}", "text follows"),
        ] {
            let (_, mistake) = read(text, 0, text != "acrc: fmt on ");
            let mistake = mistake.expect("a mistake");
            assert_eq!(&text[mistake.span.range()], place);
            assert!(mistake.message.contains(expected), "{text}: {}", mistake.message);
        }
    }
}
