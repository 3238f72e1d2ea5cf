//! What a person calls a parameter or flag: `P12288`, `BIT(516)`, `KAMR`, `AXIS1.KAMR`, `X.following_error`, an alias.

use std::fmt;

use acrc_analysis::nearest;
use acrc_catalog::{
    AddressLaw, Model, ObjectKind, Space, all_bits, all_parameters, bit, bit_number, default_model, parameter,
    parameter_number,
};
use thiserror::Error;

/// A parameter or flag by number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Register {
    /// `P12288`
    Parameter(u32),
    /// `BIT516`
    Bit(u32),
}

impl Register {
    /// What it is, as the catalogue says; empty when no source does.
    pub fn title(self) -> String {
        let (title, owner) = match self {
            Self::Parameter(number) => {
                let info = parameter(number);
                (info.title, info.owner())
            }
            Self::Bit(number) => {
                let info = bit(number);
                (info.title, info.owner())
            }
        };
        [title, owner.as_str()].into_iter().filter(|text| !text.is_empty()).collect::<Vec<_>>().join(", ")
    }
}

impl fmt::Display for Register {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Parameter(number) => write!(f, "P{number}"),
            Self::Bit(number) => write!(f, "BIT{number}"),
        }
    }
}

/// A parameter or flag that was asked for by a name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Named {
    /// What it is called.
    pub name: String,
    /// What that is.
    pub register: Register,
}

/// What is wrong with a name.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum NameError {
    /// No controller has a parameter or flag of this number.
    #[error("{0} is outside the parameters and flags of every controller")]
    OutOfSpace(Register),
    /// Nothing has this name.
    #[error("nothing is named `{name}`{}", suggestion(.meant.as_deref()))]
    Unknown {
        /// The name.
        name: String,
        /// What is near it.
        meant: Option<String>,
    },
    /// There is no such axis, master, ...
    #[error("`{name}`: no controller has {object}{index}")]
    NoSuchObject {
        /// The name.
        name: String,
        /// `AXIS`
        object: &'static str,
        /// Its number.
        index: u32,
    },
    /// An alias of the project that stands for something else.
    #[error("the alias {0} stands for no parameter and no flag")]
    Alias(String),
    /// Several have this name, where one is needed.
    #[error("`{name}` names {count} of them, {first} and others: say which, as in AXIS0.{name} or --axis 0")]
    Several {
        /// The name.
        name: String,
        /// How many.
        count: usize,
        /// One of them.
        first: Register,
    },
}

fn suggestion(meant: Option<&str>) -> String {
    meant.map(|meant| format!("; did you mean `{meant}`?")).unwrap_or_default()
}

/// The names of a project, and which objects are meant where a name does not say.
#[derive(Clone, Debug)]
pub struct Names {
    /// The controller: how many axes, masters and programs a name stands for that does not say which.
    pub model: &'static Model,
    /// The aliases of a project; none for what is neither parameter nor flag.
    pub aliases: Vec<(String, Option<Register>)>,
    /// The names of the axes of its programs.
    pub axes: Vec<(String, u8)>,
    /// The object of a kind that is meant where a name does not say.
    pub usual: Vec<(ObjectKind, u32)>,
}

impl Default for Names {
    fn default() -> Self {
        Self { model: default_model(), aliases: Vec::new(), axes: Vec::new(), usual: Vec::new() }
    }
}

impl Names {
    /// The one parameter or flag that a name stands for.
    ///
    /// # Errors
    /// When nothing or several are called so.
    pub fn one(&self, name: &str) -> Result<Named, NameError> {
        let mut found = self.find(name)?;
        match (found.pop(), found.first()) {
            (Some(named), None) => Ok(named),
            (Some(_), Some(first)) => {
                let (name, count, first) = (name.to_owned(), found.len() + 1, first.register);
                Err(NameError::Several { name, count, first })
            }
            (None, _) => Err(unknown(name, None)),
        }
    }

    /// What a name stands for: `KAMR` is a flag of every axis unless [`Names::usual`] says which.
    ///
    /// # Errors
    /// When nothing is called so.
    pub fn find(&self, name: &str) -> Result<Vec<Named>, NameError> {
        let name = name.trim();
        if let Some((alias, register)) = self.aliases.iter().find(|(alias, _)| alias == name) {
            let register = register.ok_or_else(|| NameError::Alias(alias.clone()))?;
            return Ok(vec![Named { name: name.to_owned(), register }]);
        }
        if let Some(register) = numbered(name)? {
            return Ok(vec![Named { name: register.to_string(), register }]);
        }
        let words: Vec<&str> = name
            .split(|separator: char| separator == '.' || separator.is_whitespace())
            .filter(|word| !word.is_empty())
            .collect();
        let (object, words) = self.object(&words);
        let field = Field::named(&words, object.map(|(kind, _)| kind));
        let Some(field) = field else { return Err(self.unknown(name, &words)) };
        match object.or_else(|| self.usual.iter().copied().find(|(kind, _)| field.kind == Some(*kind))) {
            Some((kind, index)) => {
                let register = field.of(index).ok_or_else(|| NameError::NoSuchObject {
                    name: name.to_owned(),
                    object: kind.name(),
                    index,
                })?;
                Ok(vec![Named { name: format!("{kind}{index}.{}", field.name), register }])
            }
            None => Ok(field.all(self.model)),
        }
    }

    /// The object among the words of a name, `AXIS1`, `axis 1` or `X`, and the other words.
    fn object<'w>(&self, words: &[&'w str]) -> (Option<(ObjectKind, u32)>, Vec<&'w str>) {
        for (place, word) in words.iter().enumerate() {
            let digits = word.trim_start_matches(|letter: char| letter.is_ascii_alphabetic());
            let kind = word.strip_suffix(digits).and_then(ObjectKind::from_name);
            let next = words.get(place + 1).and_then(|next| next.parse().ok());
            let (object, used) = match (kind, digits.parse(), next) {
                (Some(kind), Ok(index), _) => ((kind, index), 1),
                (Some(kind), Err(_), Some(index)) if digits.is_empty() => ((kind, index), 2),
                _ => match self.axes.iter().find(|(axis, _)| axis.eq_ignore_ascii_case(word)) {
                    Some((_, axis)) if words.len() > 1 => ((ObjectKind::Axis, u32::from(*axis)), 1),
                    _ => continue,
                },
            };
            let others = words.iter().take(place).chain(words.iter().skip(place + used)).copied().collect();
            return (Some(object), others);
        }
        (None, words.to_vec())
    }

    fn unknown(&self, name: &str, words: &[&str]) -> NameError {
        let asked = words.join("_").to_ascii_lowercase();
        let fields = all_parameters().map(|row| row.field).chain(all_bits().map(|row| row.field));
        let near = nearest(name, self.aliases.iter().map(|(alias, _)| alias.as_str()));
        unknown(name, near.or_else(|| nearest(&asked, fields)))
    }
}

fn unknown(name: &str, meant: Option<&str>) -> NameError {
    NameError::Unknown { name: name.to_owned(), meant: meant.map(str::to_owned) }
}

/// `P12288`, `p(12288)`, `BIT 516`.
fn numbered(name: &str) -> Result<Option<Register>, NameError> {
    let digits = |prefix: &str| {
        let (head, rest) = name.split_at_checked(prefix.len())?;
        let rest = rest.trim_start();
        let digits = rest.strip_prefix('(').and_then(|rest| rest.strip_suffix(')')).unwrap_or(rest).trim();
        let is_number = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
        // A number too large for any register is as far outside as the largest.
        (head.eq_ignore_ascii_case(prefix) && is_number).then(|| digits.parse().unwrap_or(u32::MAX))
    };
    let register = match (digits("P"), digits("BIT")) {
        (Some(number), _) => Register::Parameter(number),
        (None, Some(number)) => Register::Bit(number),
        (None, None) => return Ok(None),
    };
    let is_outside = match register {
        // Packets name a parameter with a word.
        Register::Parameter(number) => u16::try_from(number).is_err(),
        Register::Bit(number) => bit(number).word.is_none(),
    };
    if is_outside { Err(NameError::OutOfSpace(register)) } else { Ok(Some(register)) }
}

/// A field of the catalogue.
struct Field {
    name: &'static str,
    law: AddressLaw,
    is_bit: bool,
    kind: Option<ObjectKind>,
}

impl Field {
    /// The field that words name, of objects of a kind if one is said.
    fn named(words: &[&str], kind: Option<ObjectKind>) -> Option<Self> {
        let (blanks, bars) = (words.join(" "), words.join("_"));
        let same = |field: &str, title: &str, also: &[&str]| {
            field.eq_ignore_ascii_case(&bars)
                || title.eq_ignore_ascii_case(&blanks)
                || also.iter().any(|also| also.eq_ignore_ascii_case(&blanks))
        };
        let fits = |object: Space| kind.is_none() || object.object_kind() == kind;
        let parameter = all_parameters().find(|row| fits(row.object) && same(row.field, row.title, row.also));
        if let Some(row) = parameter {
            return Some(Self { name: row.field, law: row.law, is_bit: false, kind: row.object.object_kind() });
        }
        let row = all_bits().find(|row| fits(row.object) && same(row.field, row.title, row.also))?;
        Some(Self { name: row.field, law: row.law, is_bit: true, kind: row.object.object_kind() })
    }

    fn register(&self, number: u32) -> Register {
        if self.is_bit { Register::Bit(number) } else { Register::Parameter(number) }
    }

    fn of(&self, index: u32) -> Option<Register> {
        let number = if self.is_bit { bit_number(self.name, index) } else { parameter_number(self.name, index) };
        number.map(|number| self.register(number))
    }

    /// Those of all objects that a controller has.
    fn all(&self, model: &Model) -> Vec<Named> {
        let count = match self.kind {
            Some(ObjectKind::Axis) => model.axes,
            Some(ObjectKind::Master) => model.masters,
            Some(ObjectKind::Prog) => model.programs,
            Some(ObjectKind::Plc) => model.plcs,
            _ => u8::MAX,
        };
        let exists = |place| self.law.object_index(place).is_none_or(|index| index < u32::from(count));
        let places = (0..self.law.count).filter(|place| exists(*place));
        let numbers = places.filter_map(|place| Some((place, self.law.number(place)?)));
        let named = numbers.map(|(place, number)| {
            let name = match (self.kind, self.law.object_index(place)) {
                (Some(kind), Some(index)) if self.law.count > 1 => format!("{kind}{index}.{}", self.name),
                _ if self.law.count > 1 => format!("{}.{place}", self.name),
                _ => self.name.to_owned(),
            };
            Named { name, register: self.register(number) }
        });
        named.collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names() -> Names {
        Names {
            aliases: vec![("Lamp".to_owned(), Some(Register::Bit(32))), ("LED".to_owned(), None)],
            axes: vec![("X".to_owned(), 0), ("TILT".to_owned(), 1)],
            ..Names::default()
        }
    }

    #[test]
    fn one_name_one_register() {
        for (name, register) in [
            ("P12288", Register::Parameter(12288)),
            ("p (12288)", Register::Parameter(12288)),
            ("bit(516)", Register::Bit(516)),
            ("Lamp", Register::Bit(32)),
            ("kamr axis 1", Register::Bit(8499)),
            ("AXIS1.KAMR", Register::Bit(8499)),
            ("axis1 kill all motion request", Register::Bit(8499)),
            ("tilt.kamr", Register::Bit(8499)),
            ("KAMR X", Register::Bit(8467)),
            ("master0.in_motion", Register::Bit(516)),
            ("in motion master 1", Register::Bit(548)),
            ("X.actual_position", Register::Parameter(12290)),
        ] {
            assert_eq!(names().one(name).map(|named| named.register), Ok(register), "{name}");
        }
    }

    #[test]
    fn a_field_without_an_object_is_that_of_all_or_of_the_usual_one() {
        let all = names().find("KAMR").unwrap();
        assert_eq!(all.len(), 8);
        assert_eq!(all[1], Named { name: "AXIS1.kill_all_motion_request".to_owned(), register: Register::Bit(8499) });
        let usual = Names { usual: vec![(ObjectKind::Axis, 2)], ..names() };
        assert_eq!(usual.one("kamr").map(|named| named.register), Ok(Register::Bit(8531)));
        let several = names().one("KAMR").unwrap_err().to_string();
        assert_eq!(several, "`KAMR` names 8 of them, BIT8467 and others: say which, as in AXIS0.KAMR or --axis 0");
    }

    #[test]
    fn what_is_not_found_is_named() {
        for (name, said) in [
            ("P70000", "P70000 is outside the parameters and flags of every controller"),
            ("BIT99999", "BIT99999 is outside the parameters and flags of every controller"),
            ("LED", "the alias LED stands for no parameter and no flag"),
            ("Lmap", "nothing is named `Lmap`; did you mean `Lamp`?"),
            ("in_motoin", "nothing is named `in_motoin`; did you mean `in_motion`?"),
            ("AXIS77.KAMR", "`AXIS77.KAMR`: no controller has AXIS77"),
            ("", "nothing is named ``"),
        ] {
            assert_eq!(names().find(name).unwrap_err().to_string(), said, "{name}");
        }
    }
}
