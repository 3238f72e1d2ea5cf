//! The labels of one unit.

use acrc_diagnostics::Span;
use acrc_syntax::ast::{Statement, StatementKind};
use rustc_hash::FxHashMap;

use crate::error::{CompileError, CompileErrorKind};

/// Numbers the labels of a unit in the order of their definitions.
#[derive(Default)]
pub(crate) struct LabelTable {
    /// The number of each name.
    pub(crate) numbers: FxHashMap<String, u16>,
    first: FxHashMap<String, (usize, Span)>,
    count: usize,
}

impl LabelTable {
    /// Takes note of a statement of `file`.
    pub(crate) fn add(&mut self, file: usize, text: &str, statement: &Statement, errors: &mut Vec<CompileError>) {
        let StatementKind::Label(label) = &statement.kind else { return };
        let name = text.get(label.name.start as usize..label.name.end as usize).unwrap_or_default().to_owned();
        let mut mistake = |kind| errors.push(CompileError { file, span: label.name, kind });
        if let Some(&(first_file, first)) = self.first.get(&name) {
            mistake(CompileErrorKind::DuplicateLabel { name, first: (first_file == file).then_some(first) });
            return;
        }
        match u16::try_from(self.count) {
            Ok(number) => {
                self.numbers.insert(name.clone(), number);
            }
            Err(_) => mistake(CompileErrorKind::Limit {
                what: "the number of labels",
                value: self.count as u64 + 1,
                limit: 65_536,
            }),
        }
        self.first.insert(name, (file, label.name));
        self.count += 1;
    }
}
