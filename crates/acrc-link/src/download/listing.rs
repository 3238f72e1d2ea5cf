//! The text of a program as a controller lists it, beside the one that it should be.

use acrc_compile::{Tables, compile_stored};
use acrc_image::list::{ListOptions, lines, list};
use acrc_image::{Alias, Unit, UnitName};
use acrc_syntax::SourceText;

use super::script::Place;

/// A text as a controller lists it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Listing {
    /// The lines, without blanks at their ends; none is empty.
    pub lines: Vec<String>,
}

/// Two texts that are not the same.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// The first line that differs, from 1.
    pub line: usize,
    /// What it should be; `None` behind the end.
    pub expected: Option<String>,
    /// What it is; `None` behind the end.
    pub found: Option<String>,
    /// Where the source has the expected line.
    pub place: Option<Place>,
}

impl Listing {
    /// From the lines of an answer.
    pub fn new(lines: &[String]) -> Self {
        let lines = lines.iter().map(|line| line.trim_end().to_owned());
        Self { lines: lines.filter(|line| !line.is_empty()).collect() }
    }

    /// As one text.
    pub fn text(&self) -> String {
        self.lines.iter().flat_map(|line| [line.as_str(), "\n"]).collect()
    }

    /// The listed text in its stored form, where it can be read and all names in it are known.
    pub fn unit(&self, name: UnitName, aliases: &Tables) -> Option<Unit> {
        let text = self.text();
        let source = SourceText::decode(text.as_bytes()).ok()?;
        compile_stored(name, &source.text, &acrc_syntax::parse(&source.text), aliases).ok()
    }

    /// The lines in the form in which this project lists them, so that how a controller sets its blanks does not count. A text
    /// that cannot be read stays as it is.
    pub fn canonical(&self, name: UnitName, names: &Names) -> Vec<String> {
        let listed = self.unit(name, &names.tables).and_then(|unit| unit_lines(&unit, &names.entries));
        listed.unwrap_or_else(|| self.lines.clone())
    }

    /// Compares with the text that it should be, word by word of the stored form.
    ///
    /// # Errors
    /// The first line that differs.
    pub fn compare(&self, unit: &Unit, names: &Names) -> Result<(), Difference> {
        let found = self.unit(unit.name, &names.tables);
        if found.is_some_and(|found| found.words == unit.words && found.strings == unit.strings) {
            return Ok(());
        }
        let expected = unit_lines(unit, &names.entries).unwrap_or_default();
        let found = self.canonical(unit.name, names);
        let same = expected.iter().zip(&found).take_while(|(expected, found)| expected == found).count();
        Err(Difference {
            line: same + 1,
            expected: expected.get(same).cloned(),
            found: found.get(same).cloned(),
            place: places_of_lines(unit).get(same).copied().flatten(),
        })
    }
}

/// Aliases by name and by place.
#[derive(Clone, Debug, Default)]
pub struct Names {
    /// Their places.
    pub tables: Tables,
    /// What they stand for.
    pub entries: Vec<Alias>,
}

impl Names {
    /// The aliases of a project, and behind them those of a controller that the project does not have.
    pub fn new(project: &[Alias], controller: &[Alias]) -> Self {
        let mut names = Self::default();
        for alias in project.iter().chain(controller) {
            if let Ok(place) = u16::try_from(names.entries.len())
                && !names.tables.aliases.contains_key(&alias.name)
            {
                names.tables.aliases.insert(alias.name.clone(), place);
                names.entries.push(alias.clone());
            }
        }
        names
    }
}

/// The lines of a unit as they are listed.
pub fn unit_lines(unit: &Unit, aliases: &[Alias]) -> Option<Vec<String>> {
    let text = list(unit, aliases, &ListOptions::default()).ok()?;
    Some(text.lines().map(str::to_owned).collect())
}

/// Where the source has each line of a unit.
pub(super) fn places_of_lines(unit: &Unit) -> Vec<Option<Place>> {
    let instructions = unit.decode().unwrap_or_default();
    let place = |address| {
        let location = unit.debug.as_ref()?.locate(address)?;
        let span = acrc_diagnostics::Span::new(location.span.start, location.span.end);
        Some(Place { file: location.file as usize, line: location.line, span })
    };
    lines(&instructions).map(|line| place(line.address)).collect()
}
