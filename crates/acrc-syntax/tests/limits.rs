//! Huge and hostile texts: no stack is exhausted, and twice the text takes about twice the work.

mod support;

use acrc_syntax::{codes, parse};
use support::errors;

const MANY: usize = 200_000;

#[test]
fn deep_nesting_is_refused_and_the_next_statement_is_read() {
    for opening in ["(", "-", "NOT ", "SIN(", "P(", "LA0("] {
        let source = format!("P0 = {} : VEL 5", opening.repeat(MANY));
        let tree = support::checked(&source);
        assert_eq!(errors(&tree).len(), 1, "{opening}");
        assert_eq!(tree.statements().len(), 2, "{opening}");
    }
}

#[test]
fn nesting_up_to_the_limit_is_read() {
    let source = format!("P0 = {}1{}", "(".repeat(256), ")".repeat(256));
    assert!(support::checked(&source).errors().is_empty());
}

#[test]
fn one_line_may_hold_very_many_statements() {
    for statement in ["X5 ", "SET34 ", "VEL 5 : ", "P0=1 ", "_a ", ": ", "IF (P0) THENP0=1 ", "RES X P0=1 "] {
        let source = statement.repeat(MANY);
        support::checked(&source);
    }
}

#[test]
fn one_statement_may_be_very_long() {
    let sources = [
        format!("PRINT {}", "P0;".repeat(MANY)),
        format!("LIST {}", "1,".repeat(MANY)),
        format!("X({}", "1,".repeat(MANY)),
        format!("DRIVE ON {}", "X ".repeat(MANY)),
        format!("P0 = 1{}", " + 1".repeat(MANY)),
        "A1".repeat(MANY),
        "\"".repeat(MANY),
        format!("PRINT {}", "\"\u{201C}".repeat(MANY)),
        format!("RES X {}", "P(".repeat(MANY)),
        "a".repeat(MANY),
        "1".repeat(MANY),
        "$".repeat(MANY),
        "#DEFINE ".repeat(MANY),
        "@".repeat(MANY),
    ];
    for source in sources {
        support::checked(&source);
    }
}

#[test]
fn the_list_of_errors_of_a_file_that_is_no_program_is_bounded() {
    let tree = parse(&") \n".repeat(50_000));
    assert_eq!(tree.statements().len(), 50_000);
    assert_eq!(tree.errors().len(), 10_000);
    assert!(tree.errors().iter().all(|error| error.code == codes::SYNTAX_ERROR));
}
