//! What holds for every text, however broken, and for every program at hand.

mod support;

use proptest::prelude::*;
use support::pieces::{layouts, programs, short_lines, soup};

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_order_of_words_keeps_its_tokens(text in soup()) {
        support::checked(&text);
    }

    #[test]
    fn any_lines_keep_their_tokens(text in short_lines()) {
        support::checked(&text);
    }

    #[test]
    fn any_layout_is_laid_out_once(text in layouts()) {
        support::checked(&text);
    }

    #[test]
    fn untidy_programs_stay_the_same_program(text in programs()) {
        support::checked(&text);
    }

    #[test]
    fn any_text_keeps_its_tokens(text in "(\\PC|[\\x00-\\x1F]){0,200}") {
        support::checked(&text);
    }
}

#[test]
fn programs_of_the_guide_keep_their_tokens() {
    let Some(corpus) = support::corpus() else { return };
    let programs = support::programs(&corpus.join("guide"));
    assert!(programs.len() > 80, "the corpus is complete");
    for (_, text) in programs {
        support::checked(&text);
        support::checked(&text.replace('\n', "\r\n"));
    }
}

#[test]
fn examples_keep_their_tokens() {
    for (_, text) in support::examples() {
        support::checked(&text);
    }
}

/// What may stand around the name of a command, with a blank wherever one may stand.
const FORMS: [&str; 32] = [
    "$",
    "$ 5",
    "$ - 5 5",
    "$ ( 1 )",
    "$ ( 1 , 2 )",
    "$ X",
    "$ X 5",
    "$ X - 5 Y / 5 Z ( P 0 )",
    "$ X ( 1 , 2 ) SINE Y 1e3",
    "$ A 1 B 2 = 3",
    "$ Name",
    "$ Name 1",
    "$ Name = 1",
    "$ P 0",
    "$ P 0 ( 1 , 2 )",
    "$ LA 0 ( 1 ) 5",
    "$ $V 0",
    "$ ENC 0",
    "$ AXIS 0 5",
    "$ AXIS 0 / - 5 ENC 2",
    "$ STREAM 2 5",
    "$ COM 1",
    "$ \"a\" AS # 1",
    "$ - BIT 5",
    "$ BIT ( 5 ) X 5",
    "$ ALL",
    "$ NONE 2 DACSTEP 2",
    "AXIS 0 $ 5",
    "ENC 0 $ X 5",
    "$ $ 5",
    "X 5 $ 5 REM $",
    "20 $ X . 5 ' $",
];

#[test]
fn every_command_keeps_its_arguments() {
    for form in FORMS {
        let form = form.replace("$V", "\u{1}").replace('$', "\u{2}").replace('\u{1}', "$V");
        let lines = acrc_catalog::all_commands().map(|command| form.replace('\u{2}', command.name));
        support::checked_once(&lines.collect::<Vec<_>>().join("\n"));
    }
}
