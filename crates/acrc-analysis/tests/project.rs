//! What `load` makes of directories, descriptions and files, and what it says when it can't.

use std::error::Error;
use std::fs;

use acrc_analysis::project::{FailOn, LoadError, LoadedProject, RunTarget, SimTime, load};
use acrc_analysis::{Database, FileRole, facts};
use acrc_syntax::units::Level;
use camino::{Utf8Path, Utf8PathBuf};
use tempfile::TempDir;

/// A directory with files.
struct Place {
    _directory: TempDir,
    root: Utf8PathBuf,
}

impl Place {
    fn new(files: &[(&str, &str)]) -> Self {
        let directory = TempDir::new().expect("a temporary directory");
        let root = Utf8PathBuf::from_path_buf(directory.path().join("machine")).expect("a readable path");
        fs::create_dir(&root).expect("a directory in it");
        for (name, text) in files {
            let path = root.join(name);
            fs::create_dir_all(path.parent().expect("a file in a directory")).expect("its directory");
            fs::write(path, text).expect("a file");
        }
        Self { _directory: directory, root }
    }

    fn load(&self) -> Result<LoadedProject, LoadError> {
        load(&self.root)
    }

    fn load_at(&self, path: &str) -> Result<LoadedProject, LoadError> {
        load(self.root.join(path))
    }

    /// The messages of the error and of what caused it, without the place of the temporary directory.
    fn error(&self) -> String {
        let error = self.load().expect_err("an error");
        let causes = std::iter::successors(Some(&error as &dyn Error), |&error| error.source());
        let chain: Vec<_> = causes.map(ToString::to_string).collect();
        chain.join(": ").replace(self.root.as_str(), "machine").replace('\\', "/")
    }

    fn names(&self, project: &LoadedProject) -> Vec<(String, FileRole)> {
        let relative = |path: &Utf8Path| path.strip_prefix(&self.root).unwrap_or(path).as_str().replace('\\', "/");
        project.files.iter().map(|file| (relative(&file.path), file.role)).collect()
    }
}

fn named(names: &[(&str, FileRole)]) -> Vec<(String, FileRole)> {
    names.iter().map(|(name, role)| ((*name).to_owned(), *role)).collect()
}

#[test]
fn a_directory_of_the_vendors_editor_is_sent_setup_first_and_the_rest_last() {
    let place = Place::new(&[
        ("zz.8k", ""),
        ("PLC0.8K", ""),
        ("prog10.8k", ""),
        ("Prog2.8K", ""),
        ("SETUP.8K", ""),
        ("notes.txt", ""),
        ("deep/Prog1.8K", ""),
    ]);
    let project = place.load().expect("a project");
    assert_eq!(
        place.names(&project),
        named(&[
            ("SETUP.8K", FileRole::Setup),
            ("Prog2.8K", FileRole::Program(2)),
            ("prog10.8k", FileRole::Program(10)),
            ("PLC0.8K", FileRole::Plc(0)),
            ("zz.8k", FileRole::Any),
        ])
    );
    assert_eq!((project.name.as_str(), project.model.name), ("machine", acrc_catalog::default_model().name));
}

#[test]
fn a_description_without_files_finds_them_beside_it_and_in_src() {
    let place = Place::new(&[("acrc.toml", "[project]\nname = \"gantry\"\n"), ("Setup.8K", ""), ("src/Prog0.8K", "")]);
    for project in [place.load(), place.load_at("acrc.toml")] {
        let project = project.expect("a project");
        assert_eq!(
            place.names(&project),
            named(&[("Setup.8K", FileRole::Setup), ("src/Prog0.8K", FileRole::Program(0))])
        );
        assert_eq!(project.name, "gantry");
    }
}

#[test]
fn a_description_says_everything() {
    let config = "[project]\nmodel = \"acr8020\"\nfiles = [\"b.8K\", \"a/Prog0.8K\"]\n\
                  [sim]\nworld = \"world.toml\"\nrun = [\"PROG0\", \"PLC3\"]\nuntil = \"1.5min\"\nplc-scan = \"5ms\"\n\
                  [lint]\nfail-on = \"warning\"\n";
    let place = Place::new(&[("acrc.toml", config), ("b.8K", ""), ("a/Prog0.8K", ""), ("unlisted.8K", "")]);
    let project = place.load().expect("a project");
    assert_eq!(place.names(&project), named(&[("b.8K", FileRole::Any), ("a/Prog0.8K", FileRole::Program(0))]));
    assert_eq!(project.model.name, "ACR8020");
    assert_eq!(project.config.sim.run, Some(vec![RunTarget(Level::Program(0)), RunTarget(Level::Plc(3))]));
    assert_eq!(project.config.sim.until, Some(SimTime(std::time::Duration::from_secs(90))));
    assert_eq!(project.config.sim.plc_scan, Some(SimTime(std::time::Duration::from_millis(5))));
    assert_eq!(project.config.lint.fail_on, Some(FailOn::Warning));
}

#[test]
fn a_time_without_a_unit_is_in_seconds() {
    for (written, milliseconds) in [("5", 5000), ("2.5", 2500), ("0", 0), ("\"500ms\"", 500)] {
        let config = format!("[sim]\nuntil = {written}\n");
        let place = Place::new(&[("acrc.toml", config.as_str()), ("Prog0.8K", "")]);
        let until = place.load().expect("a project").config.sim.until;
        assert_eq!(until, Some(SimTime(std::time::Duration::from_millis(milliseconds))), "{written}");
    }
}

#[test]
fn a_single_file_is_a_project() {
    let place = Place::new(&[("Prog3.8K", "X10\n"), ("Prog4.8K", "")]);
    let project = place.load_at("Prog3.8K").expect("a project");
    assert_eq!(place.names(&project), named(&[("Prog3.8K", FileRole::Program(3))]));
}

#[test]
fn errors_name_the_path_and_the_reason() {
    let case = |title: &str, files: &[(&str, &str)]| format!("{title}\n{}\n", Place::new(files).error());
    let cases = [
        case("no programs", &[("notes.txt", "")]),
        case("two files for one program", &[("acrc.toml", ""), ("Prog1.8K", ""), ("src/prog1.8k", "")]),
        case("binary", &[("Prog0.8K", "VEL 1\0")]),
        case("unknown model", &[("acrc.toml", "[project]\nmodel = \"ACR9001\"\n"), ("a.8K", "")]),
        case("no such model", &[("acrc.toml", "[project]\nmodel = \"toaster\"\n"), ("a.8K", "")]),
        case("unknown key", &[("acrc.toml", "[project]\nname = \"a\"\nmodle = \"ACR9000\"\n")]),
        case("unknown section", &[("acrc.toml", "[projct]\n")]),
        case("wrong type", &[("acrc.toml", "[project]\nfiles = \"a.8K\"\n")]),
        case("broken", &[("acrc.toml", "[project\n")]),
        case("no program", &[("acrc.toml", "[sim]\nrun = [\"PROG16\"]\n")]),
        case("no time", &[("acrc.toml", "[sim]\nuntil = \"soon\"\n")]),
        case("no time either", &[("acrc.toml", "[sim]\nuntil = -1\n")]),
        case("no time at all", &[("acrc.toml", "[sim]\nuntil = true\n")]),
        case("no scan", &[("acrc.toml", "[sim]\nplc-scan = \"0ms\"\n")]),
        case("nothing listed", &[("acrc.toml", "[project]\nfiles = []\n"), ("Prog0.8K", "")]),
        case("listed and missing", &[("acrc.toml", "[project]\nfiles = [\"a.8K\"]\n")]),
        case("outside", &[("acrc.toml", "[project]\nfiles = [\"../machine/../machine/../..\"]\n")]),
    ];
    insta::assert_snapshot!(cases.join("\n"));
}

#[test]
fn a_path_that_is_not_there_is_an_error() {
    let place = Place::new(&[]);
    assert!(matches!(place.load_at("nowhere"), Err(LoadError::Missing { .. })));
}

#[cfg(unix)]
#[test]
fn links_in_a_circle_end_in_an_error() {
    let place = Place::new(&[("acrc.toml", "[project]\nfiles = [\"a.8K\"]\n")]);
    std::os::unix::fs::symlink("b.8K", place.root.join("a.8K")).expect("a link");
    std::os::unix::fs::symlink("a.8K", place.root.join("b.8K")).expect("a link");
    assert!(matches!(place.load(), Err(LoadError::Unreadable { .. })));
    assert!(matches!(place.load_at("a.8K"), Err(LoadError::Unreadable { .. })));
    // Found by its name instead of listed: still an error, because a program would be missing.
    fs::remove_file(place.root.join("acrc.toml")).expect("the description");
    assert!(matches!(place.load(), Err(LoadError::Unreadable { .. })));
    // Nor is a description passed over that can't be read.
    let place = Place::new(&[("Prog0.8K", "")]);
    std::os::unix::fs::symlink("acrc.toml", place.root.join("acrc.toml")).expect("a link");
    assert!(matches!(place.load(), Err(LoadError::Unreadable { .. })));
}

#[cfg(unix)]
#[test]
fn a_link_out_of_the_project_is_refused() {
    let place = Place::new(&[("acrc.toml", "[project]\nfiles = [\"a.8K\"]\n")]);
    let outside = place.root.with_file_name("outside.8K");
    fs::write(&outside, "").expect("a file");
    std::os::unix::fs::symlink(&outside, place.root.join("a.8K")).expect("a link");
    assert!(matches!(place.load(), Err(LoadError::OutsideProject { .. })));
}

#[test]
fn facts_answer_with_places() {
    let place = Place::new(&[
        ("Setup.8K", "#DEFINE Clamp BIT32\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"x\"\n"),
        ("Prog0.8K", "PROGRAM\n_Start\nSET Clamp\nX10\nGOTO Start\nENDP\n"),
    ]);
    let db = Database::new();
    let project = place.load().expect("a project").add_to(&db);
    let names = |level| facts::axis_names(&db, project, level).map(|axes| axes.names.clone());
    assert_eq!(names(Level::Program(0)), Some(vec![("X".into(), Some(0))]));
    assert_eq!(names(Level::Program(1)), None);
    let aliases: Vec<_> =
        facts::aliases(&db, project).iter().map(|alias| (&*alias.name, &*alias.operand.text)).collect();
    assert_eq!(aliases, [("Clamp", "BIT32")]);
    let labels = facts::labels(&db, project, Level::Program(0));
    assert_eq!(labels.len(), 1);
    let shown = |definition: &facts::Definition| {
        let text = definition.file.text(&db);
        format!("{:?} {} {}", definition.kind, definition.name, &text[definition.span.range()])
    };
    let all: Vec<_> = facts::definitions(&db, project).iter().map(shown).collect();
    assert_eq!(all, ["Alias Clamp Clamp", "Axis(Program(0)) X \"x\"", "Label(Program(0)) Start Start"]);
}

#[test]
fn facts_tell_who_reads_and_writes() {
    let place = Place::new(&[
        ("Setup.8K", "#DEFINE Clamp BIT32\nP(4096+8) = 1\nPROG0\nRUN\n"),
        (
            "Prog0.8K",
            "PROGRAM\nSET Clamp\nINH -516\nIF (Clamp) THEN P5 = P6 + LV0\nP(LV1) = 2\nHALT PLC2\nHALT ALL\nENDP\n",
        ),
    ]);
    let db = Database::new();
    let project = place.load().expect("a project").add_to(&db);
    let shown =
        |access: &facts::Access| format!("{} {} {:?}", access.level, access.reference.name(), access.reference.usage);
    let all: Vec<_> = facts::accesses(&db, project).iter().map(shown).collect();
    assert_eq!(
        all,
        [
            "SYS bit 32 Define",
            "SYS P4104 Write",
            "PROG0 bit 32 Write",
            "PROG0 bit 516 Wait { set: false }",
            "PROG0 bit 32 Read",
            "PROG0 P5 Write",
            "PROG0 P6 Read",
        ]
    );
    let orders: Vec<_> = facts::program_orders(&db, project)
        .iter()
        .map(|order| (order.from, order.order.info().name, order.to))
        .collect();
    let program = Level::Program(0);
    assert_eq!(
        orders,
        [(program, "RUN", Some(program)), (program, "HALT", Some(Level::Plc(2))), (program, "HALT", None)]
    );
}

#[test]
fn a_project_compiles() {
    let place = Place::new(&[
        ("Setup.8K", "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\n"),
        ("Prog0.8K", "_Start\nX10\nGOTO Start\n"),
    ]);
    let image = place.load().expect("a project").compile().expect("an image");
    assert_eq!(image.programs.len(), 1, "a program file without PROGRAM is stored as a whole");
    let broken = Place::new(&[("Prog0.8K", "GOTO Nowhere\n")]);
    let errors = broken.load().expect("a project").compile().expect_err("an undefined label");
    assert_eq!(errors.len(), 1);
}
