//! Texts that nobody would write take no more than their share of time and memory. A step that looks back over what it
//! has seen would not come to an end here.

use acrc_fmt::{Options, format};

/// Formats a text and checks that it did not grow beyond reason.
fn formatted(text: &str) -> String {
    let formatted = format(text, &Options::default()).text;
    assert!(formatted.len() <= 24 * text.len() + 100, "{} bytes from {}", formatted.len(), text.len());
    formatted
}

#[test]
fn deep_blocks() {
    let count = 50_000;
    formatted(&("IF(P0)\n".repeat(count) + &"ENDIF\n".repeat(count)));
    formatted(&("IF(P0)\n".repeat(count) + &"NEXT\n".repeat(count)));
    formatted(&("WHILE(P0)\nIF(P0)\n".repeat(count / 2) + &"WEND\n".repeat(count / 2)));
}

#[test]
fn long_lines() {
    let count = 20_000;
    for piece in ["X1Y2", "SET34:", "_A1", "p0;", "1", "A", "(", "\"", "#", "$v", "REM", "\u{A0}", "\t"] {
        formatted(&piece.repeat(count));
    }
    formatted(&format!("PRINT {}", "P0;".repeat(count)));
    formatted(&format!("REM {}", "a".repeat(count)));
}

#[test]
fn many_lines() {
    let count = 20_000;
    for line in ["\n", "\r\n", "'a\n", "RETURN\n", "_A\n", "X1:REM a\n", "#DEFINE A P0\n", "DIM LV(1)\n", "@\n"] {
        formatted(&line.repeat(count));
    }
    formatted(&format!("RETURN\n{}_A\n", "'a\n".repeat(count)));
    formatted(&"PROGRAM\nIF(P0)\nENDP\n".repeat(count));
}

#[test]
fn columns_do_not_grow_with_their_lines() {
    let steps: Vec<String> = (0..2000).map(|width| format!("X{}:REM a\n", "1".repeat(width))).collect();
    formatted(&steps.concat());
}
