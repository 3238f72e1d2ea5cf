//! Which projects a folder holds, to which project a file belongs, and a file that is not saved yet.

use std::fs;

use acrc_analysis::project::{Config, FileGlob, FileGlobs, Files, LintLevel, Overlay, load_from, owner, search};
use camino::{Utf8Path, Utf8PathBuf};
use tempfile::TempDir;

struct Place {
    _directory: TempDir,
    root: Utf8PathBuf,
}

impl Place {
    fn new(files: &[(&str, &str)]) -> Self {
        let directory = TempDir::new().expect("a temporary directory");
        let root = Utf8PathBuf::from_path_buf(directory.path().to_owned()).expect("a readable path");
        for (name, text) in files {
            let path = root.join(name);
            fs::create_dir_all(path.parent().expect("a file in a directory")).expect("its directory");
            fs::write(path, text).expect("a file");
        }
        Self { _directory: directory, root }
    }

    fn found(&self, path: &str) -> Vec<String> {
        let search = search(&self.root.join(path));
        assert!(search.problems.is_empty(), "{:?}", search.problems);
        search.projects.iter().map(|project| self.name(project)).collect()
    }

    fn owner(&self, files: &dyn Files, path: &str) -> Option<String> {
        owner(files, &self.root.join(path)).expect("a project that loads").map(|project| self.name(&project))
    }

    fn name(&self, path: &Utf8Path) -> String {
        path.strip_prefix(&self.root).unwrap_or(path).as_str().replace('\\', "/")
    }
}

#[test]
fn projects_are_folders_with_a_description_or_the_names_of_the_vendors_editor_and_single_files() {
    let place = Place::new(&[
        ("a/acrc.toml", ""),
        ("a/src/Prog0.8K", ""),
        ("a/backup/Prog0.8K", ""),
        ("a/backup/acrc.toml", ""),
        ("a/other/Prog0.8K", ""),
        ("b/PLC0.8K", ""),
        ("b/more.8k", ""),
        ("b/deep/one.8K", ""),
        ("b/deep/two.8K", ""),
        (".hidden/Prog0.8K", ""),
        ("ignored/Prog0.8K", ""),
        (".gitignore", "ignored/\n"),
        ("text/notes.txt", ""),
    ]);
    assert_eq!(place.found(""), ["a", "a/backup", "b", "b/deep/one.8K", "b/deep/two.8K"]);
    assert_eq!(place.found("a"), ["a", "a/backup"]);
    assert_eq!(place.found("b/deep"), ["b/deep"], "single files that are named together are one project");
    assert_eq!(place.found("b/deep/one.8K"), ["b/deep/one.8K"]);
    assert_eq!(place.found("ignored"), ["ignored"]);
    assert_eq!(place.found("text"), ["text"], "loading it says what is missing");
    assert_eq!(place.found("gone"), ["gone"]);
}

#[test]
fn a_file_belongs_to_the_nearest_description_that_has_it() {
    let place = Place::new(&[
        ("a/acrc.toml", "[project]\nfiles = [\"code/x.8K\"]\n"),
        ("a/code/x.8K", ""),
        ("a/code/y.8K", ""),
        ("a/code/Prog0.8K", ""),
        ("b/Prog0.8K", ""),
        ("b/x.8K", ""),
    ]);
    let disk = acrc_analysis::project::Disk;
    assert_eq!(place.owner(&disk, "a/code/x.8K").as_deref(), Some("a/acrc.toml"));
    assert_eq!(place.owner(&disk, "a/code/y.8K"), None);
    assert_eq!(place.owner(&disk, "a/code/Prog0.8K"), None, "the project says what it has");
    assert_eq!(place.owner(&disk, "b/Prog0.8K").as_deref(), Some("b"));
    assert_eq!(place.owner(&disk, "b/x.8K"), None);
}

#[test]
fn a_text_that_is_not_saved_takes_the_place_of_its_file() {
    let place = Place::new(&[("p/acrc.toml", ""), ("p/Setup.8K", "old"), ("p/src/Prog0.8K", "")]);
    for (path, count) in [("p/Setup.8K", 2), ("p/src/Prog4.8K", 3), ("p/./src/../Setup.8K", 2)] {
        let files = Overlay::new(&place.root.join(path), b"SET 32".to_vec());
        assert_eq!(place.owner(&files, path).as_deref(), Some("p/acrc.toml"), "{path}");
        let project = load_from(&files, &place.root.join("p")).expect("a project");
        assert_eq!(project.files.len(), count);
        assert_eq!(project.files.iter().filter(|file| file.source.text == "SET 32").count(), 1, "{path}");
    }
}

#[test]
fn the_configuration_of_the_linter_and_the_formatter_is_read() {
    let text = "[lint]\nextend-select = [\"a\"]\nexclude = [\"x/*\"]\n[lint.severity]\na = \"off\"\n\
                [lint.per-file-ignores]\n\"*.8K\" = [\"b\"]\n[[lint.override]]\nfiles = [\"y\"]\nselect = []\n\
                [fmt]\nindent = 2\nkeyword-case = \"keep\"\n";
    let place = Place::new(&[("acrc.toml", text), ("Prog0.8K", "")]);
    let Config { lint, fmt, .. } = load_from(&acrc_analysis::project::Disk, &place.root).expect("a project").config;
    assert_eq!((lint.select.is_none(), &lint.extend_select[..]), (true, &["a".to_owned()][..]));
    assert_eq!(lint.severity["a"], LintLevel::Off);
    assert_eq!(lint.per_file_ignores.0, [(FileGlob::new("*.8K").expect("a pattern"), vec!["b".to_owned()])]);
    assert_eq!(lint.overrides[0].select, Some(Vec::new()));
    let exclude = FileGlobs::new(&lint.exclude).expect("short patterns");
    for (name, excluded) in [("x/a.8K", true), ("a.8K", false)] {
        let path = place.root.join(name);
        assert_eq!(!exclude.matching(lint.relative(path.as_str())).is_empty(), excluded, "{name}");
    }
    assert_eq!(fmt.indent, Some(2));
    for (broken, expected) in [
        ("[lint]\nselct = []\n", "unknown field `selct`"),
        ("[[lint.override]]\nselect = []\n", "missing field `files`"),
        ("[lint]\nexclude = [\"{a\"]\n", "`{a` is no pattern of files"),
        ("[fmt]\nindent = -1\n", "indent = -1"),
    ] {
        fs::write(place.root.join("acrc.toml"), broken).expect("a file");
        let error = load_from(&acrc_analysis::project::Disk, &place.root).expect_err("no description").to_string();
        assert!(error.contains(expected), "{error}");
    }
}
