//! The account as one JSON object (`docs/memory.md` describes it).

use std::io::{self, Write};

use acrc_analysis::memory::{Allocation, Calls, Exact, IssueKind, Part, ProgramReport, Space, SystemBlock, SystemLine};
use serde::Serialize;

use super::Account;
use crate::commands::kinds::Kinds;

/// The version of the form. It grows when a field changes its meaning or goes.
const VERSION: u32 = 1;

#[derive(Serialize)]
struct Document {
    version: u32,
    project: String,
    model: &'static str,
    /// Something does not fit.
    over: bool,
    system: System,
    programs: Vec<Program>,
    refused: Vec<Refused>,
    exact: Vec<ExactDim>,
}

#[derive(Serialize)]
struct System {
    total: u64,
    /// Null when the size of a block is computed, as `free` is.
    used: Option<u64>,
    free: Option<u64>,
    blocks: Vec<SystemBlockBytes>,
    aliases: u64,
    parameters: u64,
    parameters_computed: bool,
}

#[derive(Serialize)]
struct SystemBlockBytes {
    block: String,
    /// Null when the size is computed.
    bytes: Option<u64>,
    count: Option<u64>,
    factory: bool,
}

#[derive(Serialize)]
struct Program {
    program: String,
    /// Null when the size is computed.
    space: Option<u64>,
    factory: bool,
    needed: u64,
    /// More may be needed.
    open: bool,
    excess: u64,
    text: Text,
    variables: Vec<Variable>,
    calls: CallLevels,
    parts: Vec<PartBytes>,
}

#[derive(Serialize)]
struct Text {
    total: u64,
    #[serde(flatten)]
    kinds: Kinds,
}

#[derive(Serialize)]
struct Variable {
    block: String,
    count: Option<u64>,
    length: Option<u64>,
    bytes: Option<u64>,
    conditional: bool,
}

#[derive(Serialize)]
struct CallLevels {
    /// Null when a subroutine calls itself.
    depth: Option<u32>,
    bytes: u64,
}

#[derive(Serialize)]
struct PartBytes {
    /// Null for what comes before the first label.
    label: Option<String>,
    file: Option<String>,
    line: Option<u32>,
    bytes: u64,
}

#[derive(Serialize)]
struct Refused {
    file: String,
    line: u32,
    reason: &'static str,
}

#[derive(Serialize)]
struct ExactDim {
    statement: String,
    bytes: u64,
    /// Why more may be needed.
    open: Option<&'static str>,
}

/// Writes the object with a line break behind it.
pub(super) fn write(account: &Account<'_>, out: &mut dyn Write) -> io::Result<()> {
    let report = account.report;
    let file = |file: usize| account.files.get(file).map(|name| (*name).to_owned());
    let document = Document {
        version: VERSION,
        project: account.title.to_owned(),
        model: report.model.name,
        over: account.is_over(),
        system: System {
            total: report.total,
            used: (!report.is_open()).then(|| report.used()),
            free: (!report.is_open()).then(|| report.free()),
            blocks: report.system.iter().map(SystemBlockBytes::from).collect(),
            aliases: report.aliases,
            parameters: report.parameters.count,
            parameters_computed: report.parameters.computed,
        },
        programs: report.programs.iter().map(|program| Program::new(program, &file)).collect(),
        refused: report
            .refused
            .iter()
            .map(|(at, line, kind)| Refused { file: file(*at).unwrap_or_default(), line: *line, reason: reason(*kind) })
            .chain(account.errors.iter().map(|error| Refused {
                file: file(error.file).unwrap_or_default(),
                line: error.line,
                reason: error.rule,
            }))
            .collect(),
        exact: report.exact().iter().map(ExactDim::from).collect(),
    };
    serde_json::to_writer_pretty(&mut *out, &document)?;
    writeln!(out)
}

impl From<&SystemLine> for SystemBlockBytes {
    fn from(line: &SystemLine) -> Self {
        let counted = matches!(line.block, SystemBlock::Parameters | SystemBlock::Aliases);
        Self {
            block: line.block.to_string(),
            bytes: line.bytes,
            count: line.count.filter(|_| counted),
            factory: line.factory,
        }
    }
}

impl Program {
    fn new(program: &ProgramReport, file: &dyn Fn(usize) -> Option<String>) -> Self {
        let text = program.text;
        let part = |part: &Part| PartBytes {
            label: part.label.clone(),
            file: part.place.and_then(|(at, _)| file(at)),
            line: part.place.map(|(_, line)| line),
            bytes: part.bytes,
        };
        Self {
            program: program.level.to_string(),
            space: program.space.map(Space::bytes),
            factory: matches!(program.space, Some(Space::Factory(_))),
            needed: program.needed(),
            open: program.is_open(),
            excess: program.excess(),
            text: Text { total: text.total(), kinds: Kinds(text) },
            variables: program.variables.iter().map(Variable::from).collect(),
            calls: CallLevels {
                depth: match program.calls {
                    Calls::Depth(depth) => Some(depth),
                    Calls::Recursive => None,
                },
                bytes: program.calls.bytes(),
            },
            parts: program.parts.iter().map(part).collect(),
        }
    }
}

impl From<&Allocation> for Variable {
    fn from(allocation: &Allocation) -> Self {
        Self {
            block: allocation.block.to_string(),
            count: allocation.size.count,
            length: allocation.size.length.filter(|length| *length > 0),
            bytes: allocation.bytes,
            conditional: allocation.conditional,
        }
    }
}

impl From<&Exact> for ExactDim {
    fn from(exact: &Exact) -> Self {
        Self { statement: format!("DIM {}({})", exact.block, exact.count), bytes: exact.bytes(), open: exact.open }
    }
}

/// A word for each reason, as stable as the form.
fn reason(kind: IssueKind) -> &'static str {
    match kind {
        IssueKind::TooLarge { .. } => "program-too-large",
        IssueKind::Redimensioned { .. } => "redimensioned-block",
        IssueKind::SystemExceeded { .. } => "system-memory-exceeded",
        IssueKind::NoReference { .. } => "array-reference-count",
        IssueKind::TooManyAliases { .. } => "too-many-aliases",
        IssueKind::NotCleared(_) => "dim-without-clear",
    }
}
