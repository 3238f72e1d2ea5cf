//! One wrong token costs one diagnostic, and the statements on both sides of the broken one stay what they are.

mod support;

use acrc_syntax::ast::{Statement, StatementKind};
use acrc_syntax::{Tree, debug_tree, lexer};

/// Statements that are right, one of each kind.
const STATEMENTS: [&str; 40] = [
    "ACC 10",
    "ACC10 DEC10 VEL 5",
    "X10 Y/-5",
    "X2 SINE Y(0,90,90,100)",
    "MOV X(P0 + 1)",
    "RES X 0 RES Y 0",
    "SLM X(24, 0) Y 5",
    "DRIVE ON X AXIS2",
    "AXIS0 JOG INC 5",
    "MASTER0 VEL500",
    "ENC 0 SRC 1",
    "GEAR SRC X ENC2",
    "JOG HOME X-1 Y1",
    "SET 32 CLR BIT33",
    "INH -516",
    "IHPOS -P12290 (100, 5)",
    "MASK P4097 (1, 2)",
    "LD NOT 5 AND 6 OUT 32",
    "TIM 0 100",
    "P0 = P1 + 2 * (LV0 - 1)",
    "LA0(LV0) = SIN(P0)",
    "BIT 32 = NOT BIT 33",
    "$V0 = UCASE$($V1) + CHR$(27)",
    "Speed = 5",
    "IF (P0 > 4000 OR BIT 24)",
    "IF (P0 = 1) THEN SET 5",
    "ELSE IF (P0)",
    "FOR LV0 = 0 TO 9 STEP 2",
    "WHILE (BIT 24)",
    "GOTO Loop1",
    "_Loop1",
    "PRINT #1, USING \"##\"; P0; P1;",
    "?P0",
    "INPUT; \"how many\"; $V0, P1",
    "OPEN \"COM1:9600\" AS #1",
    "DIM $V(1, 80)",
    "DIM PROG0(8192)",
    "#DEFINE Ready BIT128",
    "ATTACH SLAVE0 AXIS0 \"X\"",
    "CONFIG NONE STEPPER4 DACSTEP2 NONE",
];

/// Tokens that are put where they do not belong. Colons, quotes and remarks are none of them: they change where the
/// neighbours begin.
const INTRUDERS: [&str; 14] = ["(", ")", ",", ";", "=", "/", "-", "5", "Name", "VEL", "THEN", "P0", "AXIS1", "@"];

/// The statement before and the statement behind the one that is broken.
const BEFORE: &str = "DWL 1 : ";
const BEHIND: &str = " : INH 7";

fn check(mutant: &str, source: &str) {
    let text = format!("{BEFORE}{mutant}{BEHIND}");
    let tree = support::checked(&text);
    let errors = support::errors(&tree);
    assert!(errors.len() <= 1, "{source:?} became {mutant:?}: {errors:#?}");
    let whole = support::checked(&format!("{BEFORE}{}", BEHIND.trim_start_matches(" : ")));
    let expected = [whole.statements().first(), whole.statements().last()].map(Option::unwrap);
    let found = [tree.statements().first(), tree.statements().last()].map(Option::unwrap);
    for (expected, found) in expected.into_iter().zip(found) {
        assert_eq!(name(expected), name(found), "{source:?} became {mutant:?}: {}", debug_tree(&tree, &text));
    }
    assert!(is_told(&tree), "{source:?} became {mutant:?}: {}", debug_tree(&tree, &text));
}

/// A broken statement and its diagnostic come together.
fn is_told(tree: &Tree) -> bool {
    let broken = tree.statements().iter().any(support::is_error);
    !broken || support::errors(tree).len() == 1
}

fn name(statement: &Statement) -> &'static str {
    match &statement.kind {
        StatementKind::Command(command) => command.id.info().name,
        _ => "no command",
    }
}

#[test]
fn one_token_is_missing() {
    for source in STATEMENTS {
        assert!(support::checked(source).errors().is_empty(), "{source}");
        for token in lexer::tokenize(source).tokens {
            let mut mutant = source.to_owned();
            mutant.replace_range(token.span.range(), "");
            check(&mutant, source);
        }
    }
}

#[test]
fn one_token_is_too_many() {
    for source in STATEMENTS {
        for token in lexer::tokenize(source).tokens {
            for intruder in INTRUDERS {
                let mut mutant = source.to_owned();
                mutant.insert_str(token.span.start as usize, &format!(" {intruder} "));
                check(&mutant, source);
            }
        }
    }
}

#[test]
fn one_token_is_another_one() {
    for source in STATEMENTS {
        for token in lexer::tokenize(source).tokens {
            for intruder in INTRUDERS {
                let mut mutant = source.to_owned();
                mutant.replace_range(token.span.range(), &format!(" {intruder} "));
                check(&mutant, source);
            }
        }
    }
}
