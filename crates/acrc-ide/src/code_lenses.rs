//! What can be done with a program, and what it takes, above its text.

use acrc_analysis::memory::grouped;
use acrc_analysis::{Db, Project, SourceFile};
use acrc_diagnostics::Span;
use acrc_syntax::units::Level;

use crate::{ProgramUsage, programs};

/// A line above a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CodeLens {
    /// Where the program begins.
    pub span: Span,
    /// What is shown.
    pub title: String,
    /// What happens when it is chosen.
    pub action: LensAction,
}

/// What happens when a line is chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LensAction {
    /// The program runs in a dry run.
    DryRun(Level),
    /// The memory of the project is shown.
    Memory,
    /// The page of the last run is shown.
    LastRun,
}

/// The lines above the programs of a file. `outcome` tells how the last run of a program ended.
pub fn code_lenses(
    db: &dyn Db,
    project: Project,
    file: SourceFile,
    outcome: &dyn Fn(Level) -> Option<String>,
) -> Vec<CodeLens> {
    let mut lenses = Vec::new();
    for program in programs(db, project, file) {
        let span = program.start;
        if matches!(program.level, Level::Program(_)) {
            let action = LensAction::DryRun(program.level);
            lenses.push(CodeLens { span, title: format!("Dry run {}", program.level), action });
        }
        lenses.push(CodeLens { span, title: memory(&program), action: LensAction::Memory });
        if let Some(title) = outcome(program.level) {
            lenses.push(CodeLens { span, title, action: LensAction::LastRun });
        }
    }
    lenses
}

fn memory(program: &ProgramUsage) -> String {
    match program.space {
        Some(space) if space > 0 => {
            let percent = program.bytes.saturating_mul(100) / space;
            format!("Text {} of {} bytes ({percent} %)", grouped(program.bytes), grouped(space))
        }
        _ => format!("Text {} bytes", grouped(program.bytes)),
    }
}
