//! New line numbers, and what keeps them from being given.

mod support;

use std::fmt::Write;
use std::num::NonZeroU32;

use acrc_catalog::command;
use acrc_compile::{SourceUnit, compile};
use acrc_diagnostics::{Fix, LineIndex, apply};
use acrc_fmt::renumber::{RenumberError, Source, renumber};
use acrc_image::list::{ListOptions, list};
use acrc_image::{Image, Node};
use acrc_syntax::units::Level;
use acrc_syntax::{Tree, parse};
use proptest::prelude::*;

/// A file: text, prompt, and whether it is a program as a whole.
type File<'a> = (&'a str, Level, bool);

const PROMPT: Level = Level::Program(0);

fn number(value: u32) -> NonZeroU32 {
    NonZeroU32::new(value).expect("a number above 0")
}

fn renumbered(files: &[File<'_>], start: u32, step: u32) -> Result<Vec<String>, Vec<RenumberError>> {
    let trees: Vec<Tree> = files.iter().map(|(text, ..)| parse(text)).collect();
    let sources: Vec<Source<'_>> = files
        .iter()
        .zip(&trees)
        .map(|(&(text, start, implicit_program), tree)| Source { text, tree, start, implicit_program })
        .collect();
    let edits = renumber(&sources, number(start), number(step))?;
    let changed = files.iter().zip(edits).map(|((text, ..), edits)| {
        apply(text, &[&Fix::safe("new line numbers", edits)]).expect("edits that fit the text")
    });
    Ok(changed.collect())
}

/// One file at the prompt of program 0, numbered 10, 20, 30, ...
fn one(text: &str) -> String {
    match renumbered(&[(text, PROMPT, false)], 10, 10) {
        Ok(texts) => texts.concat(),
        Err(errors) => refusals(&[text], &errors),
    }
}

fn refusals(texts: &[&str], errors: &[RenumberError]) -> String {
    let mut out = String::new();
    for error in errors {
        let place = LineIndex::new(texts[error.file]).position(error.span.start);
        let file = if texts.len() > 1 { format!("file {}, ", error.file) } else { String::new() };
        let _ = writeln!(out, "{file}line {place}: {error}");
    }
    out
}

#[test]
fn lines_and_jumps_get_new_numbers() {
    let text = "\
1 REM counts parts\n2 P0 = 0\n5SET32 : DWL 0.5\n7 P0 = P0 + 1\n9 IF (P0 < 10) THEN CLR 32 : GOTO 5\n12 GOSUB20\n13 \
                END\n20 PRINT \"full\"\n21 RETURN\n";
    insta::assert_snapshot!(one(text), @r#"
    10 REM counts parts
    20 P0 = 0
    30SET32 : DWL 0.5
    40 P0 = P0 + 1
    50 IF (P0 < 10) THEN CLR 32 : GOTO 30
    60 GOSUB80
    70 END
    80 PRINT "full"
    90 RETURN
    "#);
}

#[test]
fn start_and_step_are_chosen() {
    let texts = renumbered(&[("1 SET 32\n2 GOTO 1\n", PROMPT, false)], 1000, 5).expect("numbers that rise");
    assert_eq!(texts, ["1000 SET 32\n1005 GOTO 1000\n"]);
}

#[test]
fn each_program_is_numbered_by_itself() {
    let text = "PROG0\n5 SET 32\n6 GOTO 5\nPROG1\nPROGRAM\n7 CLR 32\n8 GOTO 7\nENDP\nRUN PROG1\n";
    assert_eq!(one(text), "PROG0\n10 SET 32\n20 GOTO 10\nPROG1\nPROGRAM\n10 CLR 32\n20 GOTO 10\nENDP\nRUN PROG1\n");
}

#[test]
fn a_program_in_two_files_is_one_program() {
    let files =
        [("5 SET 32\n6 GOSUB 9\n", PROMPT, false), ("PROG0\n7 END\n9 CLR 32\n10 RETURN\n", Level::System, false)];
    let texts = renumbered(&files, 100, 100).expect("numbers that rise");
    assert_eq!(texts, ["100 SET 32\n200 GOSUB 400\n", "PROG0\n300 END\n400 CLR 32\n500 RETURN\n"]);
}

#[test]
fn labels_of_digits_are_passed_over() {
    // Without a line 20 the jump goes to the label; with one it would go to the line.
    let text = "1 GOTO 20\n2 SET 32\n3 _20\n4 GOTO 2\n";
    assert_eq!(one(text), "10 GOTO 20\n30 SET 32\n40 _20\n50 GOTO 30\n");
}

#[test]
fn lines_without_numbers_keep_their_places() {
    let text = "PROGRAM\n5 SET 32\nDWL 1\nCLR 32\nDWL 1\n6 GOTO 5\nENDP\n";
    assert_eq!(one(text), "PROGRAM\n10 SET 32\nDWL 1\nCLR 32\nDWL 1\n50 GOTO 10\nENDP\n");
    let whole = ("5 SET 32\nDWL 1\n6 GOTO 5\n", PROMPT, true);
    assert_eq!(renumbered(&[whole], 1, 1).expect("numbers that rise"), ["1 SET 32\nDWL 1\n11 GOTO 1\n"]);
}

#[test]
fn a_program_without_numbers_is_left_alone() {
    let text = "GOTO 100\nPROGRAM\n_Start\nGOTO Nowhere\nGOSUB 100\n@\nENDP\n";
    assert_eq!(one(text), text);
}

#[test]
fn what_would_change_the_program_is_refused() {
    let texts = [
        "10 SET 32\n30 CLR 32\n20 DWL 1\n",
        "10 SET 32\n10 CLR 32\n",
        "10 SET 32\n20\n",
        "10 SET 32\n20 GOTO 15\n30 GOSUB Nowhere\n",
        "10 SET 32\n20 GOTO (P0)\n",
        "10 SET 32\nGOTO 10\n",
        "PROGRAM\nSET 32\nENDP\n15 CLR 32\n",
        "SYS\n10 SET 32\n",
    ];
    let refused: Vec<String> = texts.iter().map(|text| format!("{text}--\n{}", one(text))).collect();
    insta::assert_snapshot!(refused.join("====\n"));
}

#[test]
fn numbers_end() {
    let errors = renumbered(&[("1 SET 32\n2 CLR 32\n", PROMPT, false)], 2_147_483_647, 1).expect_err("too large");
    insta::assert_snapshot!(refusals(&["1 SET 32\n2 CLR 32\n"], &errors), @"line 2:1: the line would get the number 2147483648; line numbers go up to 2147483647");
    assert!(renumbered(&[("1 SET 32\n", PROMPT, false)], u32::MAX, u32::MAX).is_err());
}

fn image(text: &str, implicit_program: bool) -> Image {
    let tree = parse(text);
    let source = SourceUnit { name: "test.8K", text, tree: &tree, start: PROMPT, implicit_program };
    compile(&[source], "ACR9000").unwrap_or_else(|errors| panic!("{text}\n{errors:?}"))
}

/// The instructions of the programs, with each line number as the index of its line.
fn meaning(image: &Image) -> Vec<String> {
    let mut out = Vec::new();
    for unit in &image.programs {
        let mut code = unit.decode().expect("a compiled unit");
        let mut lines: Vec<i32> = Vec::new();
        for instruction in code.iter().filter(|instruction| instruction.command == command::LINE_NUMBER) {
            lines.extend(instruction.items.iter().filter_map(|item| as_long(&item.node)));
        }
        for instruction in &mut code {
            if [command::LINE_NUMBER, command::GOTO, command::GOSUB].contains(&instruction.command) {
                for item in &mut instruction.items {
                    let line = as_long(&item.node).and_then(|number| lines.iter().position(|line| *line == number));
                    item.node = line.map_or(item.node.clone(), |line| Node::Long(line as i32));
                }
            }
        }
        out.push(format!("{code:?}"));
    }
    out
}

fn as_long(node: &Node) -> Option<i32> {
    match node {
        Node::Long(number) => Some(*number),
        _ => None,
    }
}

/// A program of numbered lines with jumps among them, and the numbers.
fn program() -> impl Strategy<Value = String> {
    let line = (1_u32..50, any::<bool>(), any::<prop::sample::Index>(), 0_usize..5);
    prop::collection::vec(line, 1..12).prop_map(|lines| {
        let mut last = 0;
        let numbers: Vec<u32> = lines
            .iter()
            .map(|(gap, ..)| {
                last += gap;
                last
            })
            .collect();
        let mut text = String::new();
        for ((_, numbered, target, form), number) in lines.iter().zip(&numbers) {
            let numbered = *numbered || *number == numbers[0];
            let targets: Vec<u32> = lines
                .iter()
                .zip(&numbers)
                .filter(|(line, number)| line.1 || **number == numbers[0])
                .map(|(_, number)| *number)
                .collect();
            let to = target.get(&targets);
            if numbered {
                let _ = write!(text, "{number} ");
            }
            let _ = match form {
                0 => writeln!(text, "GOTO {to}"),
                1 => writeln!(text, "IF (P0 > {to}) THEN SET {to} : GOSUB {to}"),
                2 => writeln!(text, "_{number} : GOTO {number}"),
                3 => writeln!(text, "P{to} = {to} : REM to {to}"),
                _ => writeln!(text, "X{to}"),
            };
        }
        text
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_program_stays_the_same_but_for_its_numbers(text in program(), start in 1_u32..2000, step in 1_u32..200) {
        let file = (text.as_str(), PROMPT, true);
        let once = renumbered(&[file], start, step).expect("numbers that rise").concat();
        let (before, after) = (image(&text, true), image(&once, true));
        prop_assert_eq!(meaning(&before), meaning(&after), "{}\n{}", text, once);
        let again = renumbered(&[(once.as_str(), PROMPT, true)], start, step).expect("numbers that rise").concat();
        prop_assert_eq!(&again, &once);
        // A listing with all numbers shows them rising, so that lines can be added between them.
        let listing = list(&after.programs[0], &after.aliases, &ListOptions { line_numbers: true }).expect("a compiled unit");
        let numbers: Vec<u64> = listing.lines().map(|line| line.split(' ').next().unwrap_or_default().parse().expect("a number")).collect();
        prop_assert!(numbers.is_sorted_by(|a, b| a < b), "{}", listing);
    }

    #[test]
    fn any_lines_are_numbered_or_refused(text in support::pieces::short_lines(), start in 1_u32..100, implicit in any::<bool>()) {
        if let Ok(once) = renumbered(&[(&text, PROMPT, implicit)], start, 10) {
            let once = once.concat();
            prop_assert_eq!(parse(&once).statements().len(), parse(&text).statements().len());
            prop_assert_eq!(renumbered(&[(&once, PROMPT, implicit)], start, 10), Ok(vec![once]));
        }
    }
}
