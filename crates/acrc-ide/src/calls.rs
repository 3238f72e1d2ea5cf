//! Who calls which subroutine with `GOSUB`.

use acrc_analysis::index::Jump;
use acrc_analysis::query::{file_index, parse};
use acrc_analysis::{Db, SectionIndex, SourceFile};
use acrc_diagnostics::Span;
use acrc_syntax::Tree;
use acrc_syntax::ast::StatementKind;
use acrc_syntax::units::SectionKind;

use crate::place::{section_of, slice};
use crate::routine::{Subroutine, span_of, subroutines};
use crate::{FilePosition, Role, Target, at, statement_at};

/// A subroutine, or the main code of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Routine {
    /// The label or the line of a subroutine, the program of main code.
    pub name: String,
    /// The program in which it stands.
    pub program: String,
    /// It is main code.
    pub is_main: bool,
    /// Where it stands. The start of its name is the place by which [`incoming_calls`] and [`outgoing_calls`] know it.
    pub target: Target,
}

/// A routine at the other end of some calls.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Calls {
    /// It calls or is called.
    pub routine: Routine,
    /// The targets of the `GOSUB`s, in the file of the one that calls.
    pub places: Vec<Span>,
}

/// The routine that is called or begins at a place. On any other word of a program there is none.
pub fn routine_at(db: &dyn Db, position: FilePosition) -> Option<Routine> {
    let file = position.file;
    let statement = match at(db, position) {
        Some(occurrence) if matches!(occurrence.role, Role::Call | Role::Jump) => {
            let section = section_of(db, file, occurrence.statement)?;
            let jump = section.jumps.iter().find(|jump| jump.statement == occurrence.statement)?;
            jump.to?
        }
        Some(occurrence) if occurrence.role == Role::Define => occurrence.statement,
        _ => return main_at(db, position),
    };
    let program = Program::of(db, file, statement)?;
    let own = program.routines.iter().find(|routine| routine.statements.start == statement);
    own.map(|routine| program.subroutine(routine)).or_else(|| main_at(db, position))
}

/// Who calls the routine whose name begins at a place. Main code is called by nobody.
pub fn incoming_calls(db: &dyn Db, position: FilePosition) -> Vec<Calls> {
    let Some((program, Some(own))) = known_at(db, position) else { return Vec::new() };
    let called = program.calls().filter(|jump| jump.to == Some(own.statements.start));
    let mut calls: Vec<Calls> = Vec::new();
    for jump in called {
        for routine in program.holding(jump.statement) {
            add(&mut calls, routine, jump.target.span());
        }
    }
    calls
}

/// Whom the routine calls whose name begins at a place.
pub fn outgoing_calls(db: &dyn Db, position: FilePosition) -> Vec<Calls> {
    let Some((program, own)) = known_at(db, position) else { return Vec::new() };
    let is_own = |statement: u32| match &own {
        Some(own) => own.statements.contains(&statement),
        None => !program.routines.iter().any(|routine| routine.statements.contains(&statement)),
    };
    let mut calls: Vec<Calls> = Vec::new();
    for jump in program.calls().filter(|jump| is_own(jump.statement)) {
        let called = program.routines.iter().find(|routine| Some(routine.statements.start) == jump.to);
        if let Some(called) = called {
            add(&mut calls, program.subroutine(called), jump.target.span());
        }
    }
    calls
}

fn add(calls: &mut Vec<Calls>, routine: Routine, place: Span) {
    match calls.iter_mut().find(|known| known.routine == routine) {
        Some(known) => known.places.push(place),
        None => calls.push(Calls { routine, places: vec![place] }),
    }
}

/// The main code of the program whose first statement begins at a place.
fn main_at(db: &dyn Db, position: FilePosition) -> Option<Routine> {
    let statement = statement_at(db, position.file, position.offset)?;
    let program = Program::of(db, position.file, statement)?;
    let word = parse(db, position.file).tokens_in(program.main_name()).first().map(|token| token.span);
    let touches = |word: Span| word.start <= position.offset && position.offset <= word.end;
    (program.first() == statement && word.is_some_and(touches)).then(|| program.main())
}

/// The program with the routine whose name begins at a place; `None` beside it for its main code.
fn known_at(db: &dyn Db, position: FilePosition) -> Option<(Program<'_>, Option<Subroutine>)> {
    let routine = routine_at(db, position)?;
    let statement = parse(db, position.file).statements();
    let start = statement.partition_point(|statement| statement.span.start < routine.target.whole.start) as u32;
    let program = Program::of(db, routine.target.file, start)?;
    let own = program.routines.iter().find(|own| !routine.is_main && own.statements.start == start).cloned();
    Some((program, own))
}

/// A stored text with its subroutines.
struct Program<'a> {
    file: SourceFile,
    text: &'a str,
    tree: &'a Tree,
    section: &'a SectionIndex,
    routines: Vec<Subroutine>,
}

impl<'a> Program<'a> {
    /// The program to which a statement belongs.
    fn of(db: &'a dyn Db, file: SourceFile, statement: u32) -> Option<Self> {
        let section = section_of(db, file, statement)?;
        // The line `PROGRAM` may itself be the first of a section that the file leaves open.
        let stored = section.section.kind == SectionKind::Stored || file_index(db, file).implicit_program;
        let tree = parse(db, file);
        stored.then(|| Self { file, text: file.text(db), tree, section, routines: subroutines(tree, section) })
    }

    fn calls(&self) -> impl Iterator<Item = &Jump> {
        self.section.jumps.iter().filter(|jump| jump.call)
    }

    /// The routines to which a statement belongs.
    fn holding(&self, statement: u32) -> Vec<Routine> {
        let own = self.routines.iter().filter(|routine| routine.statements.contains(&statement));
        let own: Vec<Routine> = own.map(|routine| self.subroutine(routine)).collect();
        if own.is_empty() { vec![self.main()] } else { own }
    }

    fn subroutine(&self, routine: &Subroutine) -> Routine {
        let first = routine.statements.start;
        let whole = span_of(self.tree, routine.statements.clone());
        let name = match self.tree.statements().get(first as usize).map(|statement| &statement.kind) {
            Some(StatementKind::Label(label)) => label.name,
            _ => {
                let line = self.tree.lines().get(self.tree.line_of(first) as usize);
                line.and_then(|line| line.number).map_or(whole, |number| number.span)
            }
        };
        self.routine(slice(self.text, name).to_owned(), false, whole, name)
    }

    fn main(&self) -> Routine {
        let section = &self.section.section;
        let end = section.closer.map_or(section.statements.end, |closer| closer + 1);
        let whole = span_of(self.tree, self.first()..end);
        self.routine(section.level.to_string(), true, whole, self.main_name())
    }

    fn routine(&self, name: String, is_main: bool, whole: Span, place: Span) -> Routine {
        let target = Target { file: self.file, whole: Span::cover(whole, place), name: place };
        Routine { name, program: self.section.section.level.to_string(), is_main, target }
    }

    /// `PROGRAM`, or the first statement where the file is the program.
    fn first(&self) -> u32 {
        self.section.section.opener.unwrap_or(self.section.section.statements.start)
    }

    fn main_name(&self) -> Span {
        span_of(self.tree, self.first()..self.first() + 1)
    }
}
