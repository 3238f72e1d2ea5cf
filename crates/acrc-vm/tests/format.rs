//! Printed numbers and lines (guide, "Printing the Current Value", `PRINT` and `PRINT USING`).

mod support;

use acrc_vm::format::{double, number, single};
use acrc_vm::{Text, Value};
use proptest::prelude::*;
use support::output;

#[test]
fn whole_numbers_have_no_point() {
    let cases = [
        (0.0, "0"),
        (-0.0, "0"),
        (30.0, "30"),
        (-1.0, "-1"),
        (1e14, "100000000000000"),
        (4_294_967_295.0, "4294967295"),
        (1e15, "1e+15"),
        (1.5e20, "1.5e+20"),
    ];
    for (value, expected) in cases {
        assert_eq!(double(value), expected);
    }
    assert_eq!(single(16_777_216.0), "16777216");
    assert_eq!(number(&Value::Long(i32::MIN)), "-2147483648");
}

#[test]
fn fractions_have_the_fewest_digits_that_read_back() {
    let doubles = [
        (0.1, "0.1"),
        (-2.5, "-2.5"),
        (1.0 / 3.0, "0.333333333333333"),
        (0.1 + 0.2, "0.3"),
        (123_456.789, "123456.789"),
        (100_000.5, "100000.5"),
        (0.0001, "0.0001"),
        (0.00001, "1e-05"),
        (1.25e-7, "1.25e-07"),
        (-1e-300, "-1e-300"),
        (0.999_999_999_999_999_9, "1"),
        (123_456_789_012_345.6, "123456789012346"),
    ];
    for (value, expected) in doubles {
        assert_eq!(double(value), expected);
    }
    let singles = [
        (0.1, "0.1"),
        (1.0 / 3.0, "0.3333333"),
        (2.6, "2.6"),
        (1e-5, "1e-05"),
        (1234.567, "1234.567"),
        (3e38, "3e+38"),
        (1.234_567_9, "1.234568"),
    ];
    for (value, expected) in singles {
        assert_eq!(single(value), expected);
    }
}

#[test]
fn print_joins_at_semicolons_and_tabs_at_commas() {
    assert_eq!(output("PRINT 1;2;\"x\"; -3"), "12x-3\r\n");
    assert_eq!(output("PRINT 1,2"), "1\t2\r\n");
    assert_eq!(output("PRINT \"open\";\nPRINT \"tab\",\nPRINT \"\"\nPRINT"), "opentab\t\r\n\r\n");
    assert_eq!(output("?P0+1"), "1\r\n");
    assert_eq!(
        output("PRINT \"Done in\";LV0;\"tries\""),
        "LV0 has no memory: no DIM LV was executed [line 1, statement 1]"
    );
}

#[test]
fn using_puts_numbers_into_a_picture() {
    assert_eq!(output("PRINT USING \"##\";5;\" Hours \";12;\"|\";123"), " 5 Hours 12|123\r\n");
    assert_eq!(output("PRINT #1, USING \"###.##\";3.14159;-2.5"), "  3.14 -2.50\r\n");
    assert_eq!(output("PRINT USING \"<#.#>\";0.25"), "<0.2>\r\n");
    assert_eq!(output("PRINT USING \"none\";7"), "none7\r\n");
    assert_eq!(output("PRINT USING 5;7"), "a string is needed here, this is a number [line 1, statement 1]");
}

#[test]
fn text_is_latin_1() {
    let text = Text::from("°C €");
    assert_eq!(text.as_bytes(), [0xb0, b'C', b' ', b'?']);
    assert_eq!(text.to_string(), "°C ?");
    assert_eq!(format!("{text:?}"), "\"°C ?\"");
}

fn finite() -> impl Strategy<Value = f64> {
    any::<f64>().prop_filter("finite", |value| value.is_finite())
}

fn normal() -> impl Strategy<Value = f32> {
    any::<f32>().prop_filter("normal", |value| value.is_normal())
}

proptest! {
    #[test]
    fn a_printed_double_reads_back_to_fifteen_digits(value in finite()) {
        let printed: f64 = double(value).parse().unwrap();
        let error = (printed - value).abs();
        let tolerance = (value.abs() * 1e-14).max(f64::MIN_POSITIVE);
        prop_assert!(error <= tolerance, "{value:e} printed as {}", double(value));
    }

    #[test]
    fn a_printed_single_reads_back_to_seven_digits(value in normal()) {
        let printed: f64 = single(value).parse().unwrap();
        let error = (printed - f64::from(value)).abs();
        prop_assert!(error <= f64::from(value).abs() * 1e-6, "{value:e} printed as {}", single(value));
    }

    #[test]
    fn printing_is_stable(value in finite()) {
        let once = double(value);
        let again: f64 = once.parse().unwrap();
        prop_assert_eq!(double(again), once);
    }
}
