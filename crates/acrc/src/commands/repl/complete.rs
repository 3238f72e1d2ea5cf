//! Completion: commands of the prompt and their daughters, functions, aliases and axis names.

use std::sync::{Arc, Mutex, PoisonError};

use acrc_catalog::{Command, CommandId, Levels, all_commands, all_functions, daughter, word};
use acrc_syntax::units::Level;
use reedline::{Completer, CompletionResult, Span, Suggestion};

use super::session::Session;

/// What can be typed at the present prompt.
#[derive(Debug, Default)]
pub(in crate::commands) struct Vocabulary {
    level: Option<Level>,
    names: Vec<String>,
}

impl Vocabulary {
    /// Of the prompt of a session.
    pub(super) fn of(session: &Session) -> Self {
        let level = session.level();
        Self::at(level, session.controller.names_at(level))
    }

    /// Of a prompt, with names beside the words of the language.
    pub(in crate::commands) fn at(level: Level, names: Vec<String>) -> Self {
        Self { level: Some(level), names }
    }

    /// Words that fit the end of a line, each with what it means, and where they begin in it.
    fn fitting(&self, line: &str) -> (usize, Vec<(String, String)>) {
        let is_part = |character: char| character.is_ascii_alphabetic() || matches!(character, '$' | '#');
        let start = line.char_indices().rev().take_while(|(_, character)| is_part(*character)).last();
        let start = start.map_or(line.len(), |(place, _)| place);
        let (before, part) = line.split_at(start);
        let statement = before.rsplit(':').next().unwrap_or_default();
        if let Some(parent) = last_command(statement).filter(|parent| !parent.info().daughters.is_empty()) {
            let daughters = parent.info().daughters.iter().map(|id| id.info());
            let fitting: Vec<_> = daughters.filter(|row| begins(row.word, part)).map(meaning).collect();
            if !fitting.is_empty() {
                return (start, fitting);
            }
        }
        let mut fitting: Vec<_> = if statement.trim().is_empty() {
            let commands = all_commands().filter(|row| row.parent.is_none() && !row.clause && self.takes(row.levels));
            commands.filter(|row| begins(row.word, part)).map(meaning).collect()
        } else {
            let functions = all_functions().filter(|row| begins(row.name, part));
            functions.map(|row| (row.name.to_owned(), row.summary.to_owned())).collect()
        };
        // Names are case-sensitive.
        let names = self.names.iter().filter(|name| name.starts_with(part));
        fitting.extend(names.map(|name| (name.clone(), String::new())));
        fitting.sort();
        fitting.dedup();
        (start, fitting)
    }

    fn takes(&self, levels: Levels) -> bool {
        match self.level {
            Some(Level::System) => levels.sys(),
            Some(Level::Plc(_)) => levels.plc(),
            // A program prompt takes the commands of the system too.
            Some(Level::Program(_)) | None => levels.prog() || levels.sys(),
        }
    }
}

/// The command that the words at the end of a statement name, its daughters included.
fn last_command(statement: &str) -> Option<CommandId> {
    let mut command: Option<CommandId> = None;
    for text in statement.split_whitespace() {
        let text = text.trim_end_matches(|character: char| character.is_ascii_digit());
        command = match command.and_then(|parent| daughter(parent, text)) {
            Some(daughter) => Some(daughter),
            None => word(text).and_then(|word| word.command),
        };
    }
    command
}

fn begins(word: &str, part: &str) -> bool {
    !word.is_empty() && word.get(..part.len()).is_some_and(|beginning| beginning.eq_ignore_ascii_case(part))
}

fn meaning(row: &Command) -> (String, String) {
    (row.word.to_owned(), row.summary.to_owned())
}

/// Completes words for the line editor.
pub(super) struct WordCompleter(pub(super) Arc<Mutex<Vocabulary>>);

impl Completer for WordCompleter {
    fn complete(&mut self, line: &str, pos: usize) -> CompletionResult {
        let vocabulary = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let (start, words) = vocabulary.fitting(line.get(..pos).unwrap_or(line));
        let suggestion = |(value, summary): (String, String)| Suggestion {
            value,
            description: Some(summary).filter(|summary| !summary.is_empty()),
            span: Span::new(start, pos),
            append_whitespace: true,
            ..Suggestion::default()
        };
        CompletionResult::fresh(words.into_iter().map(suggestion).collect::<Vec<_>>())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(level: Level, line: &str) -> Vec<String> {
        let vocabulary = Vocabulary { level: Some(level), names: vec!["ready".to_owned(), "X".to_owned()] };
        vocabulary.fitting(line).1.into_iter().map(|(word, _)| word).collect()
    }

    #[test]
    fn commands_of_the_prompt() {
        assert_eq!(words(Level::Program(0), "gos"), ["GOSUB"]);
        assert_eq!(words(Level::System, "gos"), [""; 0]);
        assert_eq!(words(Level::Program(0), "VEL 5 : rea"), ["ready"]);
    }

    #[test]
    fn daughters_of_a_command() {
        assert_eq!(words(Level::Program(0), "JOG HO"), ["HOME", "HOMVF"]);
        assert_eq!(words(Level::System, "AXIS0 JOG AB"), ["ABS"]);
        assert!(words(Level::System, "FLASH ").contains(&"SAVE".to_owned()));
    }

    #[test]
    fn functions_and_names_behind_a_command() {
        assert_eq!(words(Level::Program(0), "? SQ"), ["SQRT"]);
        assert_eq!(words(Level::Program(0), "? re"), ["ready"]);
    }
}
