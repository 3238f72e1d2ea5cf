//! An edit costs what depends on it, and nothing else.

use std::sync::{Arc, Mutex};

use acrc_analysis::project::Config;
use acrc_analysis::{Checker, Database, FileRole, Project, SourceFile, diagnostics};

const SETUP: &str = "SYS\n#DEFINE Clamp BIT32\n#DEFINE Speed P1\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\n\
                     PROG1\nATTACH MASTER1\nATTACH SLAVE0 AXIS1 \"Y\"\n";
const FIRST: &str = "PROGRAM\nSET Clamp\nX10\nENDP\n";
const SECOND: &str = "PROGRAM\nVEL (Speed)\nY20\nENDP\n";

/// A checker that finds nothing: what is counted is how often it is asked.
const NOTHING: Checker = Checker { name: "nothing", run: |_| Vec::new() };

struct Bench {
    db: Database,
    project: Project,
    files: Vec<SourceFile>,
    log: Arc<Mutex<Vec<String>>>,
}

impl Bench {
    fn new() -> Self {
        Self::with(SETUP)
    }

    /// A project that shows how its controller is set up, so that files depend on what others do.
    fn complete() -> Self {
        Self::with(&format!("{SETUP}SYS\nAXIS0 PPU 1000\nAXIS1 PPU 1000\n"))
    }

    fn with(setup: &str) -> Self {
        let log = Arc::new(Mutex::new(Vec::new()));
        let sink = Arc::clone(&log);
        let db =
            Database::observed(move |query| sink.lock().expect("no test panics while logging").push(query.to_owned()));
        let texts = [("Setup.8K", setup), ("Prog0.8K", FIRST), ("Prog1.8K", SECOND)];
        let files = texts
            .map(|(name, text)| SourceFile::new(&db, name.to_owned(), text.to_owned(), FileRole::of(name), Vec::new()));
        let project = Project::new(&db, files.to_vec(), acrc_catalog::default_model(), Config::default());
        let mut bench = Self { db, project, files: files.to_vec(), log };
        bench.check();
        bench
    }

    /// Checks all files; returns the queries that were computed, without their arguments, sorted.
    fn check(&mut self) -> Vec<String> {
        for file in &self.files {
            diagnostics(&self.db, self.project, *file, NOTHING);
        }
        let mut computed = std::mem::take(&mut *self.log.lock().expect("no test panics while logging"));
        for query in &mut computed {
            query.truncate(query.find('(').unwrap_or(query.len()));
        }
        computed.sort();
        computed
    }

    fn edit(&mut self, file: usize, text: &str) -> Vec<String> {
        self.db.edit(self.files[file], text.to_owned());
        self.check()
    }
}

fn count(computed: &[String], query: &str) -> usize {
    computed.iter().filter(|name| *name == query).count()
}

#[test]
fn nothing_is_computed_twice() {
    let mut bench = Bench::new();
    assert_eq!(bench.check(), Vec::<String>::new());
}

#[test]
fn editing_the_body_of_a_file_checks_that_file_only() {
    let mut bench = Bench::new();
    let computed = bench.edit(1, "PROGRAM\nREM a remark that moves everything\nSET Clamp\nX10 : X20\nENDP\n");
    assert_eq!(count(&computed, "parse"), 1);
    assert_eq!(count(&computed, "diagnostics"), 1);
    assert_eq!(count(&computed, "symbols"), 0);
    assert_eq!(count(&computed, "environment"), 0);
}

#[test]
fn a_new_alias_that_nobody_uses_checks_its_own_file_only() {
    let mut bench = Bench::new();
    let computed = bench.edit(0, &format!("{SETUP}SYS\n#DEFINE Lamp BIT33\n"));
    assert_eq!(count(&computed, "symbols"), 1);
    assert_eq!(count(&computed, "diagnostics"), 1);
}

#[test]
fn another_meaning_of_an_alias_checks_the_files_that_use_it() {
    let mut bench = Bench::new();
    let computed = bench.edit(0, &SETUP.replace("BIT32", "BIT33"));
    assert_eq!(count(&computed, "diagnostics"), 2, "the setup and program 0: {computed:?}");
}

#[test]
fn another_axis_name_checks_the_program_that_it_belongs_to() {
    let mut bench = Bench::new();
    let computed = bench.edit(0, &SETUP.replace("\"Y\"", "\"Z\""));
    assert_eq!(count(&computed, "diagnostics"), 2, "the setup and program 1: {computed:?}");
}

#[test]
fn a_comment_in_the_setup_checks_the_setup_only() {
    let mut bench = Bench::new();
    let computed = bench.edit(0, &format!("' made by hand\n{SETUP}"));
    assert_eq!(count(&computed, "diagnostics"), 1);
    assert_eq!(count(&computed, "symbols"), 0);
}

#[test]
fn the_first_use_of_an_alias_checks_the_file_that_defines_it() {
    let mut bench = Bench::new();
    let computed = bench.edit(2, &SECOND.replace("Y20", "Y20 : SET Clamp"));
    assert_eq!(count(&computed, "diagnostics"), 2, "the setup and program 1: {computed:?}");
}

#[test]
fn another_number_checks_its_own_file_only() {
    let mut bench = Bench::new();
    let computed = bench.edit(1, &FIRST.replace("X10", "X10 : P5 = P12290"));
    assert_eq!(count(&computed, "diagnostics"), 1, "{computed:?}");
    assert_eq!(count(&computed, "symbols"), 0);
}

const MEMORY: &str = "SYS\nCLEAR\nDIM PROG0(1000)\nDIM PROG1(1000)\nDIM P(10)\nDIM DEF(5)\n";

/// A bench whose setup gives memory.
fn with_memory() -> Bench {
    let mut bench = Bench::new();
    bench.edit(0, &format!("{MEMORY}{SETUP}"));
    bench
}

#[test]
fn a_program_with_room_enough_is_not_counted_and_concerns_nobody() {
    let mut bench = with_memory();
    let computed = bench.edit(1, "PROGRAM\nSET Clamp\nX10 : X2\nENDP\n");
    for query in ["text_bytes", "project_memory", "memory_view"] {
        assert_eq!(count(&computed, query), 0, "{query}: {computed:?}");
    }
    assert_eq!(count(&computed, "diagnostics"), 1);
}

#[test]
fn a_program_that_grows_out_of_its_memory_checks_the_setup_too() {
    let mut bench = with_memory();
    let long = "SET 32\n".repeat(200);
    let computed = bench.edit(1, &format!("PROGRAM\nSET Clamp\nX10\n{long}ENDP\n"));
    assert_eq!(count(&computed, "text_bytes"), 1, "the other program has room enough: {computed:?}");
    assert_eq!(count(&computed, "diagnostics"), 2, "the program and the setup: {computed:?}");
}

#[test]
fn another_size_checks_only_whom_it_concerns() {
    let mut bench = with_memory();
    let computed = bench.edit(0, &format!("{}{SETUP}", MEMORY.replace("PROG1(1000)", "PROG1(2000)")));
    assert_eq!(count(&computed, "project_memory"), 1);
    assert_eq!(count(&computed, "diagnostics"), 1, "everything fits as before: {computed:?}");
    let computed = bench.edit(0, &format!("{}{SETUP}", MEMORY.replace("PROG1(1000)", "PROG1(10)")));
    assert_eq!(count(&computed, "diagnostics"), 2, "the setup and program 1: {computed:?}");
}

#[test]
fn a_dim_of_variables_checks_the_program_that_it_belongs_to() {
    let mut bench = with_memory();
    let computed = bench.edit(0, &format!("{MEMORY}{SETUP}PROG1\nDIM LV(4)\n"));
    assert_eq!(count(&computed, "diagnostics"), 2, "the setup and program 1: {computed:?}");
}

#[test]
fn more_of_what_is_done_already_checks_its_own_file_only() {
    let mut bench = Bench::complete();
    for body in
        ["X10 : X20 Y", "AXIS0 PPU 2000 : X10", "IF (BIT 1) THEN MOV X5", "P5 = 1 : SET 130 : X10", "NOSUCH 5 : X10"]
    {
        let computed = bench.edit(1, &format!("PROGRAM\nSET Clamp\n{body}\nENDP\n"));
        assert_eq!(count(&computed, "diagnostics"), 1, "{body}: {computed:?}");
    }
}

#[test]
fn a_change_of_what_is_done_to_an_axis_checks_all_files() {
    let mut bench = Bench::complete();
    for body in ["DRIVE ON X : X10", "X10", "SET 8465 : X10", "SET 8497 : X10", "P12348 = 5 : X10", "JOG FWD AXIS1"] {
        let computed = bench.edit(1, &format!("PROGRAM\nSET Clamp\n{body}\nENDP\n"));
        assert_eq!(count(&computed, "diagnostics"), 3, "{body}: {computed:?}");
    }
}

#[test]
fn what_is_done_matters_only_in_projects_that_show_their_setup() {
    let mut bench = Bench::new();
    let computed = bench.edit(1, "PROGRAM\nSET Clamp\nDRIVE ON X : X10 : JOG FWD X\nENDP\n");
    assert_eq!(count(&computed, "diagnostics"), 1, "{computed:?}");
}
