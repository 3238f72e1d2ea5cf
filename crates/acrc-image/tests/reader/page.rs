//! What a reader needs to know, taken from `docs/image-format.md` and the data files of the catalogue.

use std::collections::HashMap;
use std::fs;
use std::path::Path;

/// A kind of node word: its name and the names and widths of its fields.
pub(crate) struct Layout {
    pub(crate) name: String,
    pub(crate) fields: Vec<(String, u32)>,
}

/// The tables.
pub(crate) struct Page {
    /// Kinds of node words by tag.
    pub(crate) layouts: HashMap<u32, Layout>,
    /// Rows of the table of codes: a column for each vocabulary.
    codes: Vec<Vec<String>>,
    opcodes: HashMap<u32, String>,
    functions: HashMap<u32, String>,
}

impl Page {
    /// Reads them.
    pub(crate) fn read() -> Self {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let text = fs::read_to_string(root.join("docs/image-format.md")).expect("the page is part of the project");
        let layouts = table(&text, "layout").into_iter().map(|row| {
            let fields = row[2].split(", ").filter_map(|field| field.rsplit_once(' '));
            let fields = fields.map(|(name, width)| (name.to_owned(), width.parse().expect("a width")));
            (row[0].parse().expect("a tag"), Layout { name: row[1].clone(), fields: fields.collect() })
        });
        let data = root.join("crates/acrc-catalog/data");
        let mut opcodes = HashMap::new();
        for entry in fs::read_dir(data.join("commands")).expect("the folder of the commands") {
            opcodes.extend(named(&entry.expect("readable").path(), "opcode"));
        }
        Self {
            layouts: layouts.collect(),
            codes: table(&text, "codes"),
            opcodes,
            functions: named(&data.join("functions.toml"), "id"),
        }
    }

    /// The name of a command.
    pub(crate) fn command(&self, opcode: u32) -> String {
        self.opcodes[&opcode].clone()
    }

    /// The name of a function.
    pub(crate) fn function(&self, id: u32) -> String {
        self.functions[&id].clone()
    }

    /// A name from the table of codes. The columns are the code, then the vocabularies.
    pub(crate) fn code(&self, column: usize, code: u32) -> String {
        self.codes[code as usize][column].clone()
    }
}

/// The rows of a table between marks, without its heading.
fn table(page: &str, mark: &str) -> Vec<Vec<String>> {
    let (_, rest) = page.split_once(&format!("<!-- {mark} -->")).expect("the table begins");
    let (table, _) = rest.split_once(&format!("<!-- /{mark} -->")).expect("the table ends");
    let cells = |row: &str| {
        let cells = row.trim_matches('|').split(" | ").map(|cell| cell.trim().to_owned());
        cells.collect()
    };
    table.lines().filter(|line| line.starts_with('|')).skip(2).map(cells).collect()
}

/// The names of the rows of a data file by their number.
fn named(path: &Path, key: &str) -> HashMap<u32, String> {
    let text = fs::read_to_string(path).expect("readable");
    let value = |row: &str, key: &str| {
        let line = row.lines().find_map(|line| line.strip_prefix(key)?.strip_prefix(" = "));
        line.map(str::to_owned)
    };
    let rows = text.split("[[").filter_map(|row| {
        let name = value(row, "name")?.trim_matches('"').to_owned();
        Some((value(row, key)?.parse().ok()?, name))
    });
    rows.collect()
}
