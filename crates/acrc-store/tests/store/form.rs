//! The bytes of a state.

use acrc_controller::nonvolatile::{TypedLine, TypedText};
use acrc_image::UnitName;
use acrc_store::{ReadError, decode, encode};
use proptest::prelude::*;

use crate::support::{full, numbered};

#[test]
fn what_is_written_is_read() {
    let saved = full();
    let bytes = encode(&saved).expect("small enough");
    assert_eq!(decode(&bytes), Ok(saved.clone()));
    assert_eq!(encode(&saved).expect("small enough"), bytes);
}

#[test]
fn the_form_stays() {
    insta::assert_snapshot!(String::from_utf8(encode(&full()).expect("small enough")).expect("text"));
}

#[test]
fn each_kind_of_damage_has_its_reason() {
    let bytes = encode(&numbered(5)).expect("small enough");
    let text = String::from_utf8(bytes.clone()).expect("text");
    let said = |text: String| decode(text.as_bytes()).expect_err("refused");
    assert_eq!(said("ACRX".to_owned()), ReadError::Foreign);
    assert_eq!(said(String::new()), ReadError::Foreign);
    assert_eq!(said(text.replacen("state 1", "state 0", 1)), ReadError::Foreign);
    assert_eq!(said(text.replacen("state 1", "state 2", 1)), ReadError::NewerVersion { found: 2, newest: 1 });
    assert_eq!(said(text.replacen("crc32=", "crc=", 1)), ReadError::Foreign);
    assert!(matches!(said(text.replacen("5.0", "6.0", 1)), ReadError::Altered { .. }));
    assert!(matches!(said(format!("{text}\n")), ReadError::Length { .. }));
    for end in text.find('\n').expect("lines") + 1..text.len() {
        assert!(matches!(decode(&bytes[..end]), Err(ReadError::Length { .. })), "{end}");
    }
}

/// Writes the right checksum and length into changed text.
fn seal(body: &str) -> Vec<u8> {
    format!("acrc-state 1 crc32={:08x} bytes={}\n{body}", crc32fast::hash(body.as_bytes()), body.len()).into_bytes()
}

fn body() -> String {
    let text = String::from_utf8(encode(&full()).expect("small enough")).expect("text");
    text.split_once('\n').expect("lines").1.to_owned()
}

#[test]
fn contents_that_make_no_sense_are_refused() {
    let said = |from: &str, to: &str| {
        let body = body();
        assert!(body.contains(from), "{from} is not in\n{body}");
        decode(&seal(&body.replacen(from, to, 1))).expect_err("refused").to_string()
    };
    insta::assert_snapshot!(
        [
            said("model =", "modell ="),
            said("\"PROG0\"", "\"PROG\""),
            said("GEAR SRC", "GEAR CRS"),
            said("\"LIFT\"", "\"LIFTS\""),
            said("long = -7", "longer = -7"),
            said("ENC", "NEC"),
            said("programs = \"41", "programs = \"4x"),
            said("programs = \"41", "programs = \"42"),
        ]
        .join("\n")
    );
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 256, ..ProptestConfig::default() })]

    #[test]
    fn no_bytes_make_it_panic(place in 0..4096_usize, byte in any::<u8>(), sealed in any::<bool>()) {
        let mut body = body().into_bytes();
        let place = place % body.len();
        body[place] = byte;
        let bytes = match String::from_utf8(body) {
            Ok(body) if sealed => seal(&body),
            Ok(body) => body.into_bytes(),
            Err(error) => error.into_bytes(),
        };
        let _ = decode(&bytes);
    }
}

#[test]
fn a_text_with_mistakes_is_kept_as_it_was_typed() {
    let line = |number, written, text: &str| TypedLine { number, written, text: text.to_owned() };
    let lines = vec![line(10, false, "PRINT \"\u{fc}\" : GARBAGE ="), line(15, true, "\tVEL =")];
    let mut saved = full();
    let memory = saved.memory.as_mut().expect("it has a battery");
    memory.typed =
        vec![TypedText { name: UnitName::Program(3), lines }, TypedText { name: UnitName::Plc(0), lines: vec![] }];
    let bytes = encode(&saved).expect("small enough");
    assert_eq!(decode(&bytes), Ok(saved));
    let body = String::from_utf8(bytes).expect("text").split_once('\n').expect("lines").1.replacen("PLC0", "boot", 1);
    assert_eq!(decode(&seal(&body)).expect_err("refused").to_string(), "`boot` is no program");
}
