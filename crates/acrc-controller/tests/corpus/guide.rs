//! The files of the guide: program text, what has to be set up before it, and the facts that it must show.

use std::path::{Path, PathBuf};

use serde::Deserialize;

/// Where nothing else is said.
const MODEL: &str = "ACR9000";

/// What stands beside the text of a program.
#[derive(Deserialize)]
struct Notes {
    kind: String,
    #[serde(default)]
    models: Vec<String>,
    context: Vec<String>,
    #[serde(default)]
    behaviour: Vec<Fact>,
    #[serde(default, rename = "figure")]
    figures: Vec<Figure>,
}

/// A drawing of a homing: what was typed, and the homing bits.
#[derive(Clone, Debug, Deserialize)]
pub(crate) struct Figure {
    #[serde(rename = "figure")]
    pub(crate) name: String,
    pub(crate) statement: String,
    #[serde(rename = "backup_enable_bit24")]
    pub(crate) backup: u8,
    #[serde(rename = "negative_edge_bit25")]
    pub(crate) negative_edge: u8,
    #[serde(rename = "negative_final_direction_bit26")]
    pub(crate) negative_final: u8,
}

/// Something that a program must show.
#[derive(Clone, Debug, Deserialize)]
pub(crate) struct Fact {
    pub(crate) fact: String,
    value: Option<toml::Value>,
    tolerance: Option<f64>,
}

impl Fact {
    /// Its number.
    #[track_caller]
    pub(crate) fn number(&self) -> f64 {
        real(self.value.as_ref().unwrap_or_else(|| panic!("no value: {}", self.fact)))
    }

    /// Its numbers.
    #[track_caller]
    pub(crate) fn numbers(&self) -> Vec<f64> {
        self.items().iter().map(real).collect()
    }

    /// Its text.
    #[track_caller]
    pub(crate) fn text(&self) -> &str {
        self.value.as_ref().and_then(toml::Value::as_str).unwrap_or_else(|| panic!("no text: {}", self.fact))
    }

    /// Its texts.
    #[track_caller]
    pub(crate) fn texts(&self) -> Vec<&str> {
        self.items().iter().filter_map(toml::Value::as_str).collect()
    }

    /// The points that its text lists: `(6,6) (12,6) ...`.
    #[track_caller]
    pub(crate) fn points(&self) -> Vec<Vec<f64>> {
        let groups = self.text().split('(').skip(1).filter_map(|rest| rest.split_once(')'));
        groups
            .map(|(point, _)| point.split(',').map(|number| number.trim().parse().expect("a number")).collect())
            .collect()
    }

    /// Whether a number is the one of the fact, within its tolerance or what is given.
    #[track_caller]
    pub(crate) fn holds(&self, found: f64, otherwise: f64) {
        let tolerance = self.tolerance.unwrap_or(otherwise);
        let expected = self.number();
        // Sums of ticks are not exact.
        assert!((found - expected).abs() <= tolerance + 1e-9, "{found}, not {expected}: {}", self.fact);
    }

    #[track_caller]
    fn items(&self) -> &[toml::Value] {
        self.value.as_ref().and_then(toml::Value::as_array).unwrap_or_else(|| panic!("no list: {}", self.fact))
    }
}

/// The model with the most axes, since one listing is printed for a model that has too few for it.
fn largest(models: &[String]) -> String {
    let known = models.iter().filter_map(|model| acrc_catalog::model(model));
    known.max_by_key(|model| model.axes).map_or(MODEL, |model| model.name).to_owned()
}

fn real(value: &toml::Value) -> f64 {
    match value {
        toml::Value::Integer(number) => *number as f64,
        toml::Value::Float(number) => *number,
        other => panic!("{other} is no number"),
    }
}

/// A file of the guide.
pub(crate) struct Listing {
    /// The number that its name begins with.
    pub(crate) number: u8,
    pub(crate) name: String,
    pub(crate) text: String,
    /// Statements that are entered at the prompts; the others are stored as a program.
    entered: bool,
    pub(crate) model: String,
    /// Statements before it, from the system prompt of a controller with factory settings.
    pub(crate) context: String,
    pub(crate) facts: Vec<Fact>,
    pub(crate) figures: Vec<Figure>,
}

impl Listing {
    /// The folder of the files, when it is there.
    pub(crate) fn folder() -> Option<PathBuf> {
        let beside = || Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/corpus");
        let corpus = std::env::var_os("ACRC_CORPUS").map_or_else(beside, PathBuf::from);
        let folder = corpus.join("guide");
        folder.is_dir().then_some(folder)
    }

    /// All files, in order. Empty when the folder is not there.
    pub(crate) fn all() -> Vec<Self> {
        let Some(folder) = Self::folder() else {
            println!("the corpus is not there: nothing is run");
            return Vec::new();
        };
        let entries = std::fs::read_dir(folder).expect("the folder of the guide can be read");
        let mut files: Vec<_> = entries.map(|entry| entry.expect("an entry").path()).collect();
        files.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
        files.sort();
        files.iter().map(|path| Self::read(path)).collect()
    }

    fn read(path: &Path) -> Self {
        let notes = std::fs::read_to_string(path).expect("the notes of a file");
        let notes: Notes = toml::from_str(&notes).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let name = path.file_stem().and_then(|name| name.to_str()).expect("a name").to_owned();
        let digits = name.split('-').next().unwrap_or_default();
        Self {
            number: digits.parse().expect("a name that begins with a number"),
            text: std::fs::read_to_string(path.with_extension("8K")).expect("the text beside its notes"),
            entered: notes.kind == "setup",
            model: largest(&notes.models),
            context: notes.context.iter().flat_map(|line| [line, "\n"]).collect(),
            facts: notes.behaviour,
            figures: notes.figures,
            name,
        }
    }

    /// Statements before it and its text as one project. A text that is neither setup code nor stored by itself becomes the program of the
    /// prompt.
    pub(crate) fn project(&self) -> String {
        self.project_with("", "")
    }

    /// The same with statements of a test behind those of the context, and with lines of a test at the end of the program.
    pub(crate) fn project_with(&self, before: &str, behind: &str) -> String {
        let Self { context, text, .. } = self;
        let stores = text.lines().any(|line| line.trim_start().starts_with("PROGRAM"));
        if self.entered || stores {
            assert!(behind.is_empty(), "{} has no open end", self.name);
            return format!("SYS\n{context}{before}\n{text}");
        }
        let body = text.trim_end().trim_end_matches("ENDP");
        let prompt = if context.contains("PROG") { "" } else { "PROG0\n" };
        format!("SYS\n{context}{prompt}{before}\nPROGRAM\n{body}\n{behind}\nENDP\n")
    }

    /// The program that its prompt belongs to.
    pub(crate) fn program(&self) -> u8 {
        u8::from(self.context.contains("PROG1"))
    }
}
