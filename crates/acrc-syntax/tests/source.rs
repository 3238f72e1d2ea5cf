//! The bytes of a file as text, and back.

use acrc_diagnostics::Severity;
use acrc_syntax::{DecodeError, Encoding, MAX_BYTES, SourceText, codes, parse};

fn decoded(bytes: &[u8]) -> SourceText {
    let source = SourceText::decode(bytes).expect("a text");
    assert_eq!(source.encode(), bytes, "written back as it was");
    source
}

#[test]
fn plain_text_has_nothing_to_say() {
    let source = decoded(b"VEL 5\r\nX10\r\n");
    assert_eq!((source.text.as_str(), source.encoding), ("VEL 5\r\nX10\r\n", Encoding::Utf8));
    assert!(source.diagnostics().is_empty());
    assert!(decoded("REM größer".as_bytes()).diagnostics().is_empty());
    assert_eq!(decoded(b"").text, "");
}

#[test]
fn a_byte_order_mark_is_no_part_of_the_text() {
    let source = decoded(b"\xEF\xBB\xBFVEL 5");
    assert_eq!((source.text.as_str(), source.encoding), ("VEL 5", Encoding::Utf8Bom));
    let [diagnostic] = source.diagnostics().try_into().expect("one diagnostic");
    assert_eq!((diagnostic.code, diagnostic.severity), (codes::ENCODING, Severity::Advice));
    assert!(diagnostic.help.is_some());
}

#[test]
fn bytes_that_are_not_utf8_are_read_in_the_code_page_of_windows() {
    let source = decoded(b"REM 5\xB0 \x93quoted\x94 \x81");
    assert_eq!(source.encoding, Encoding::Windows1252);
    assert_eq!(source.text, "REM 5\u{B0} \u{201C}quoted\u{201D} \u{81}");
    let [diagnostic] = source.diagnostics().try_into().expect("one diagnostic");
    assert_eq!(diagnostic.span.range(), 5..7, "the first character that is not ASCII");
}

#[test]
fn both_orders_of_wide_text_are_read() {
    let little = decoded(b"\xFF\xFEX\x005\x00");
    assert_eq!((little.text.as_str(), little.encoding), ("X5", Encoding::Utf16Le));
    let big = decoded(b"\xFE\xFF\x00X\x005");
    assert_eq!((big.text.as_str(), big.encoding), ("X5", Encoding::Utf16Be));
    assert_eq!(big.diagnostics().len(), 1);
}

#[test]
fn a_ctrl_z_ends_a_file_and_is_no_part_of_the_text() {
    for (bytes, text) in [(&b"X5\r\n\x1A"[..], "X5\r\n"), (b"REM \xB0\x1A", "REM \u{B0}"), (b"\xEF\xBB\xBF\x1A", "")] {
        let source = decoded(bytes);
        assert!(source.end_mark);
        assert_eq!(source.text, text);
    }
    assert!(!decoded(b"X5\r\n").end_mark);
}

#[test]
fn what_is_no_text_is_refused_at_its_first_such_byte() {
    let refused = |bytes: &[u8]| SourceText::decode(bytes).expect_err("no text");
    assert_eq!(refused(b"VEL\x005"), DecodeError::Binary { offset: 3 });
    assert_eq!(refused(b"X5\x1A\n"), DecodeError::Binary { offset: 2 }, "Ctrl-Z kills all motion on a controller");
    assert_eq!(refused(b"X5\x1A\x1A"), DecodeError::Binary { offset: 2 }, "one is enough to end a file");
    assert_eq!(refused(b"\x7F"), DecodeError::Binary { offset: 0 });
    assert_eq!(refused(b"\xFF\xFEX\x00\x03\x00"), DecodeError::Binary { offset: 4 });
    assert_eq!(refused(b"\xFF\xFEX\x00\x00\xD8Y\x00"), DecodeError::Binary { offset: 4 });
    assert_eq!(refused(b"\xFE\xFF\x00X\x00"), DecodeError::Binary { offset: 4 }, "half a character");
    assert_eq!(refused(b"\xFF\xFE\x00\x00"), DecodeError::Binary { offset: 2 });
}

#[test]
fn a_file_that_is_too_large_is_refused() {
    let bytes = vec![b' '; MAX_BYTES + 1];
    assert_eq!(SourceText::decode(&bytes), Err(DecodeError::TooLarge { bytes: MAX_BYTES + 1 }));
}

#[test]
fn a_changed_text_is_written_in_an_encoding_that_has_its_characters() {
    let mut source = decoded(b"REM 5\xB0");
    source.text.push_str(" \u{2212}");
    assert_eq!(source.encode(), "REM 5\u{B0} \u{2212}".as_bytes());
}

#[test]
fn tabs_and_form_feeds_are_blanks() {
    let source = decoded(b"\x0C\tVEL\t5\n");
    assert!(parse(&source.text).errors().is_empty());
}
