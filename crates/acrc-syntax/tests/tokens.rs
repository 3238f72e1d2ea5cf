//! Text to tokens, before and after the reader has seen them.

use acrc_diagnostics::Span;
use acrc_syntax::lexer::{TokenKind, tokenize};
use acrc_syntax::parse;

/// Kind and text of each token.
fn shown(tokens: &[acrc_syntax::lexer::Token], text: &str) -> Vec<String> {
    tokens.iter().map(|token| format!("{:?} {:?}", token.kind, &text[token.span.range()])).collect()
}

#[test]
fn words_and_numbers_touch() {
    let text = "SET34 X1.5Y.2Z2. 1e-005 VEL1E3";
    let expected = [
        "Word \"SET\"",
        "Integer \"34\"",
        "Word \"X\"",
        "Real \"1.5\"",
        "Word \"Y\"",
        "Real \".2\"",
        "Word \"Z\"",
        "Real \"2.\"",
        "Real \"1e-005\"",
        "Word \"VEL\"",
        "Real \"1E3\"",
    ];
    assert_eq!(shown(&tokenize(text).tokens, text), expected);
}

#[test]
fn strings_end_at_their_quote_or_at_the_line() {
    let cases = [
        ("\"a:b\" 5", "\"a:b\""),
        ("\"open\nX5", "\"open"),
        ("\u{201C}a\u{201D} 5", "\u{201C}a\u{201D}"),
        ("\"mixed\u{201C} 5", "\"mixed\u{201C}"),
        ("\u{201D}a\"b", "\u{201D}a\""),
        ("\"say \u{201C}hi\u{201D}\" 5", "\"say \u{201C}hi\u{201D}\""),
    ];
    for (text, expected) in cases {
        let first = tokenize(text).tokens[0];
        assert_eq!((first.kind, &text[first.span.range()]), (TokenKind::String, expected), "{text:?}");
    }
}

#[test]
fn the_text_of_a_remark_is_one_token() {
    for text in ["REM \"x : \u{2013} 5", "15 rem a : b", "VEL 5 : REM x'y", "REM---x"] {
        let lexed = tokenize(text);
        assert_eq!(lexed.tokens.last().map(|token| token.kind), Some(TokenKind::RemarkText), "{text}");
        assert!(lexed.typographic.is_empty(), "{text}");
    }
    let text = "REMOTE 5 : REM";
    assert_eq!(
        shown(&tokenize(text).tokens, text),
        ["Word \"REMOTE\"", "Integer \"5\"", "Colon \":\"", "Word \"REM\""]
    );
}

#[test]
fn a_remark_in_an_unusual_place_is_found_by_the_reader() {
    let text = "CLOSE #1 REM \u{2013} a \"b : c\nX5 REM x";
    let tree = parse(text);
    let expected = [
        "Word \"CLOSE\"",
        "Hash \"#\"",
        "Integer \"1\"",
        "Word \"REM\"",
        "RemarkText \" – a \\\"b : c\"",
        "Newline \"\\n\"",
        "Word \"X\"",
        "Integer \"5\"",
        "Word \"REM\"",
        "RemarkText \" x\"",
    ];
    assert_eq!(shown(tree.tokens(), text), expected);
    assert!(tree.errors().iter().all(|error| error.code == acrc_syntax::codes::REMARK_WITHOUT_COLON));
}

#[test]
fn a_word_that_the_reader_cuts_is_two_tokens() {
    let text = "IF (0) THENP0=1 : IF (1) thenSET 5";
    let tree = parse(text);
    let words = shown(tree.tokens(), text);
    for word in ["Word \"THEN\"", "Word \"P\"", "Word \"then\"", "Word \"SET\""] {
        assert!(words.iter().any(|shown| shown == word), "{word} in {words:?}");
    }
}

#[test]
fn lines_end_at_any_break() {
    let text = "X1\r\nX2\rX3\nX4\n";
    let tree = parse(text);
    let lines: Vec<&str> = tree.lines().iter().map(|line| &text[line.span.range()]).collect();
    assert_eq!(lines, ["X1", "X2", "X3", "X4", ""]);
    assert_eq!(parse("").lines().len(), 1);
}

#[test]
fn tokens_of_a_place_are_found() {
    let text = "VEL 5 : X10 Y5";
    let tree = parse(text);
    let place = tree.statements()[1].span;
    assert_eq!(shown(tree.tokens_in(place), text), ["Word \"X\"", "Integer \"10\"", "Word \"Y\"", "Integer \"5\""]);
    assert!(tree.tokens_in(Span::new(900, 950)).is_empty());
}
