//! What holds for every text, however broken, and for every program at hand.

mod support;

use proptest::prelude::*;
use support::pieces::{programs, short_lines, soup};

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
