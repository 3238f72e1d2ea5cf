//! The files of a project to an image.

use acrc_image::{Image, Unit, UnitName, VERSION};
use acrc_syntax::Tree;
use acrc_syntax::units::Level;

use crate::aliases::AliasTable;
use crate::assemble::Assembler;
use crate::error::CompileError;
use crate::plan::{self, Plan, Text};
use crate::scope::Tables;

/// A file of a project.
#[derive(Clone, Copy, Debug)]
pub struct SourceUnit<'a> {
    /// Its name, for the debug map.
    pub name: &'a str,
    /// Its text.
    pub text: &'a str,
    /// The tree of the text.
    pub tree: &'a Tree,
    /// The prompt at which its first statement is entered.
    pub start: Level,
    /// The whole text is the stored text of the program at `start`, without `PROGRAM` and `ENDP`.
    pub implicit_program: bool,
}

/// Compiles the files of a project in their order.
///
/// # Errors
/// Every mistake of every file, in the order of files and places. A file with a statement that cannot be read is not compiled.
pub fn compile(files: &[SourceUnit<'_>], model: &str) -> Result<Image, Vec<CompileError>> {
    let mut errors = Vec::new();
    let aliases = AliasTable::collect(files, &mut errors);
    let plan = Plan::of(files, &mut errors);
    let mut assembler = Assembler::new(files, aliases.places, errors);
    let programs = plan.programs.iter().filter_map(|Text { name, parts }| assembler.unit(*name, parts)).collect();
    let boot = assembler.unit(UnitName::Boot, &plan.boot);
    let mut errors = assembler.errors;
    // A stored text that numbered lines change later is assembled more than once.
    errors.sort_by_cached_key(|error| (error.file, error.span, error.kind.to_string()));
    errors.dedup();
    match boot {
        Some(boot) if errors.is_empty() => Ok(Image {
            model: model.to_owned(),
            aliases: aliases.aliases,
            boot,
            programs,
            files: files.iter().map(|file| file.name.to_owned()).collect(),
            version: VERSION,
        }),
        _ => Err(errors),
    }
}

/// Compiles the stored text of one program by itself, as a controller does with lines that were typed: each line of `text` is a line of the
/// program, and the aliases are those of `names`. The unit has no debug map.
///
/// # Errors
/// Every mistake, with file 0.
pub fn compile_stored(name: UnitName, text: &str, tree: &Tree, names: &Tables) -> Result<Unit, Vec<CompileError>> {
    let file = SourceUnit { name: "", text, tree, start: Level::System, implicit_program: true };
    let files = [file];
    let mut assembler = Assembler::new(&files, names.aliases.clone(), Vec::new());
    let parts = plan::whole(0, &file);
    match assembler.unit(name, &parts) {
        Some(unit) if assembler.errors.is_empty() => Ok(Unit { debug: None, ..unit }),
        _ => Err(assembler.errors),
    }
}
