//! What the tests of this crate share.
#![allow(dead_code, reason = "each test file uses a part of it")]

pub(crate) mod pieces;

use std::fs;
use std::path::{Path, PathBuf};

use acrc_compile::{CompileErrorKind, SourceUnit, compile};
use acrc_fmt::{BlockEnds, KeywordCase, Options, format};
use acrc_syntax::lexer::TokenKind;
use acrc_syntax::units::{self, Level};
use acrc_syntax::{SourceText, Tree, blocks, debug_tree, parse};

/// Choices that reach every branch of the formatter.
pub(crate) fn choices() -> [Options; 4] {
    let standard = Options::default();
    [
        standard,
        Options { keyword_case: KeywordCase::Lower, indent: 2, block_ends: BlockEnds::Opener, ..standard },
        Options { keyword_case: KeywordCase::Keep, align_remarks: false, align_tables: false, ..standard },
        Options { indent: u8::MAX, align_tables: false, ..standard },
    ]
}

/// What must not change when a text is formatted.
#[derive(Debug, PartialEq)]
pub(crate) struct Facts {
    tokens: Vec<(TokenKind, String)>,
    tree: Vec<String>,
    errors: Vec<String>,
    images: [Result<Words, Vec<String>>; 2],
}

/// The words of an image, debug information left out: aliases, and each unit with its strings.
type Words = (String, Vec<(Vec<u32>, String)>);

impl Facts {
    pub(crate) fn of(text: &str) -> Self {
        let tree = parse(text);
        Self {
            tokens: tokens(&tree, text),
            tree: lines_of(&tree, text),
            errors: errors(&tree),
            images: [image(&tree, text, Level::System, false), image(&tree, text, Level::Program(0), true)],
        }
    }
}

/// Formats a text and checks what must hold for every text.
pub(crate) fn checked(text: &str) -> String {
    let facts = Facts::of(text);
    for options in choices() {
        check(text, &facts, options);
    }
    format(text, &Options::default()).text
}

/// The same with the standard options only.
pub(crate) fn checked_once(text: &str) {
    check(text, &Facts::of(text), Options::default());
}

fn check(text: &str, facts: &Facts, options: Options) {
    let options = &options;
    let first = format(text, options);
    assert_eq!(&Facts::of(&first.text), facts, "the program stays: {text:?}\n{:?}", first.text);
    let second = format(&first.text, options);
    assert_eq!(second.text, first.text, "formatting again changes nothing: {text:?}");
    assert_eq!(second.unreadable.len(), first.unreadable.len(), "{text:?}");
    check_lines(text, &parse(text), &first);
}

fn image(tree: &Tree, text: &str, start: Level, implicit_program: bool) -> Result<Words, Vec<String>> {
    let source = SourceUnit { name: "test.8K", text, tree, start, implicit_program };
    let image = compile(&[source], "ACR9000")
        .map_err(|errors| errors.iter().map(|error| reason(&error.kind)).collect::<Vec<_>>())?;
    let units = image.units().map(|unit| (unit.words.clone(), format!("{} {:?}", unit.name, unit.strings)));
    Ok((format!("{:?}", image.aliases), units.collect()))
}

/// Why a text does not compile, without the text itself.
fn reason(kind: &CompileErrorKind) -> String {
    match kind {
        CompileErrorKind::NumberTooLarge { limit, .. } => (*limit).to_owned(),
        other => other.to_string(),
    }
}

/// What is seen without a parser.
fn check_lines(text: &str, before: &Tree, formatted: &acrc_fmt::Formatted) {
    let out = &formatted.text;
    let is_empty = text.bytes().all(|byte| matches!(byte, b' ' | b'\t' | 0x0C | b'\n' | b'\r'));
    assert_eq!(out.is_empty(), is_empty, "{text:?}");
    assert!(out.is_empty() || out.ends_with(['\n', '\r']), "the last line ends: {text:?}");
    for number in &formatted.unreadable {
        let line = text.get(before.lines()[*number as usize - 1].span.range()).expect("spans lie on characters");
        assert!(lines(out).any(|other| other == line), "an unreadable line stays as it is: {line:?} of {text:?}");
    }
}

/// The lines of a text, whatever ends them.
pub(crate) fn lines(text: &str) -> impl Iterator<Item = &str> {
    text.split(['\n', '\r'])
}

/// Kinds and texts of the tokens; of line ends only that there is one or more between two other tokens.
fn tokens(tree: &Tree, text: &str) -> Vec<(TokenKind, String)> {
    let mut tokens: Vec<(TokenKind, String)> = Vec::new();
    for token in tree.tokens() {
        let slice = text.get(token.span.range()).expect("tokens lie on characters");
        let slice = match token.kind {
            TokenKind::Newline => {
                if tokens.last().is_some_and(|(kind, _)| *kind != TokenKind::Newline) {
                    tokens.push((token.kind, String::new()));
                }
                continue;
            }
            TokenKind::Word | TokenKind::Dollar => slice.to_ascii_uppercase(),
            TokenKind::RemarkText | TokenKind::Comment => slice.trim_end_matches([' ', '\t', '\x0C']).to_owned(),
            _ => slice.to_owned(),
        };
        if !slice.is_empty() {
            tokens.push((token.kind, slice));
        }
    }
    if tokens.last().is_some_and(|(kind, _)| *kind == TokenKind::Newline) {
        tokens.pop();
    }
    tokens
}

/// The tree without the numbers of lines, which blank lines change. Names keep their case in it, keywords do not.
fn lines_of(tree: &Tree, text: &str) -> Vec<String> {
    let without_place = |line: &str| match line.strip_prefix("line ") {
        Some(rest) => rest.trim_start_matches(|digit: char| digit.is_ascii_digit()).to_owned(),
        None => line.to_owned(),
    };
    debug_tree(tree, text).lines().map(without_place).collect()
}

/// What the parser and the blocks complain about.
fn errors(tree: &Tree) -> Vec<String> {
    let parser = tree.errors().iter().map(|error| format!("{:?} {}", error.severity, error.code.id));
    let blocks = units::split(tree, Level::System).into_iter().flat_map(|section| {
        blocks::match_blocks(tree, section.statements)
            .errors()
            .iter()
            .map(|error| format!("{error:?}"))
            .collect::<Vec<_>>()
    });
    parser.chain(blocks).collect()
}

/// The folder of the corpus, if there is one.
pub(crate) fn corpus() -> Option<PathBuf> {
    let default = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/corpus");
    let folder = std::env::var_os("ACRC_CORPUS").map_or(default, PathBuf::from);
    if folder.is_dir() {
        return Some(folder);
    }
    eprintln!("skipped: no corpus at {}", folder.display());
    None
}

/// Names and texts of the programs below a folder, in the order of their paths.
pub(crate) fn programs(folder: &Path) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder that can be read") {
            let path = entry.expect("an entry of a folder").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "8K") {
                let source = SourceText::decode(&fs::read(&path).expect("a readable file")).expect("a text");
                found.push((path.display().to_string(), source.text));
            }
        }
    }
    found.sort();
    found
}

/// The project's own examples.
pub(crate) fn examples() -> Vec<(String, String)> {
    programs(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples"))
}
