//! What a file is to a project, by its name: the vendor's editor saves `Setup.8K`, `Prog0.8K` .. `Prog15.8K` and
//! `PLC0.8K` .. `PLC7.8K`.

use std::fmt;

use acrc_syntax::units::Level;

/// Programs of a controller are numbered 0 to 15.
const LAST_PROGRAM: u8 = 15;
/// PLC programs are numbered 0 to 7.
const LAST_PLC: u8 = 7;

/// What a file is to its project.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum FileRole {
    /// Commands that prepare the controller, sent first and at the `SYS` prompt.
    Setup,
    /// The text of a program, sent at its prompt.
    Program(u8),
    /// The text of a PLC program, sent at its prompt.
    Plc(u8),
    /// Anything else, sent at the `SYS` prompt; level switches are expected inside.
    Any,
}

impl FileRole {
    /// The role of a file of this name, upper and lower case alike: `Prog3.8K` is program 3.
    pub fn of(name: &str) -> Self {
        let stem = match name.rsplit_once('.') {
            Some((stem, extension)) if is_program_extension(extension) => stem,
            _ => return Self::Any,
        };
        let digits = stem.find(|c: char| c.is_ascii_digit()).unwrap_or(stem.len());
        let (word, number) = stem.split_at(digits);
        if word.eq_ignore_ascii_case("setup") && number.is_empty() {
            return Self::Setup;
        }
        match number.parse::<u8>() {
            Ok(n) if word.eq_ignore_ascii_case("prog") && n <= LAST_PROGRAM => Self::Program(n),
            Ok(n) if word.eq_ignore_ascii_case("plc") && n <= LAST_PLC => Self::Plc(n),
            _ => Self::Any,
        }
    }

    /// The prompt at which the file is sent.
    pub fn start(self) -> Level {
        match self {
            Self::Setup | Self::Any => Level::System,
            Self::Program(n) => Level::Program(n),
            Self::Plc(n) => Level::Plc(n),
        }
    }
}

impl fmt::Display for FileRole {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Setup => f.write_str("setup"),
            Self::Program(n) => write!(f, "program {n}"),
            Self::Plc(n) => write!(f, "PLC program {n}"),
            Self::Any => f.write_str("other code"),
        }
    }
}

/// Whether a file with this extension is `AcroBASIC`.
pub(crate) fn is_program_extension(extension: &str) -> bool {
    extension.eq_ignore_ascii_case("8k")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_give_roles_in_any_case() {
        for (name, role) in [
            ("Setup.8K", FileRole::Setup),
            ("SETUP.8k", FileRole::Setup),
            ("Prog0.8K", FileRole::Program(0)),
            ("pROG15.8k", FileRole::Program(15)),
            ("PLC7.8K", FileRole::Plc(7)),
            ("Prog16.8K", FileRole::Any),
            ("PLC8.8K", FileRole::Any),
            ("Setup1.8K", FileRole::Any),
            ("Prog.8K", FileRole::Any),
            ("Prog0.txt", FileRole::Any),
            ("Prog0b.8K", FileRole::Any),
            ("0.8K", FileRole::Any),
            ("", FileRole::Any),
        ] {
            assert_eq!(FileRole::of(name), role, "{name}");
        }
    }
}
