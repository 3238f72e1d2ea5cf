//! What a person asks about the language, answered from the rows: `acrc explain`, hover texts, reference pages.

mod lookup;
mod near;
mod render;
mod sheet;

use crate::{
    BitInfo, BitRow, Command, Function, Keyword, Message, Model, ObjectKind, Operand, OperatorInfo, ParameterInfo,
    ParameterRow,
};

pub use near::nearest_command;

/// The answer to a topic.
#[derive(Clone, Debug, PartialEq)]
pub enum Explanation {
    /// Everything of that name: `STEP` is a command and a keyword.
    Entries(Vec<Entry>),
    /// Nothing has that name.
    Near {
        /// The topic as asked for.
        topic: String,
        /// Similar names, the most similar first; there may be none.
        suggestions: Vec<&'static str>,
    },
}

/// One thing that a topic names.
#[derive(Clone, Debug, PartialEq)]
pub enum Entry {
    /// A command.
    Command(&'static Command),
    /// A function.
    Function(&'static Function),
    /// An operator with one or two operands.
    Operator(&'static OperatorInfo),
    /// A kind of operand.
    Operand(&'static Operand),
    /// A word that is only a part of statements.
    Keyword(Keyword),
    /// A numbered object that is no command of its own: `SLAVE`.
    Object(ObjectKind),
    /// A parameter by number.
    Parameter(Box<ParameterInfo>),
    /// A flag by number.
    Bit(Box<BitInfo>),
    /// A field of parameters by name; the first of its rows.
    ParameterField(&'static ParameterRow),
    /// A field of flags by name; the first of its rows.
    BitField(&'static BitRow),
    /// A controller model.
    Model(&'static Model),
    /// A text of the controller.
    Message(&'static Message),
}

/// Looks a topic up: a command, function, operator, operand, keyword or object, `P12290`, `BIT8467`, a field or its acronym (`KAMR`), a model, or a
/// text of the controller. Case and repeated blanks do not matter.
pub fn explain(topic: &str) -> Explanation {
    let entries = lookup::entries(topic);
    if entries.is_empty() {
        return Explanation::Near { topic: topic.trim().to_owned(), suggestions: near::topics(topic.trim()) };
    }
    Explanation::Entries(entries)
}

impl Entry {
    /// What is known of it, as Markdown that ends in a line break.
    pub fn markdown(&self) -> String {
        render::entry(self).markdown()
    }
}

impl Explanation {
    /// The answer as plain text, ending in a line break.
    pub fn render(&self) -> String {
        match self {
            Self::Entries(entries) => {
                entries.iter().map(|entry| render::entry(entry).plain()).collect::<Vec<_>>().join("\n")
            }
            Self::Near { topic, suggestions } if suggestions.is_empty() => {
                format!("nothing is known about `{topic}`\n")
            }
            Self::Near { topic, suggestions } => {
                format!("nothing is known about `{topic}`; similar names: {}\n", suggestions.join(", "))
            }
        }
    }
}
