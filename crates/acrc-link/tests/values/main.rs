//! Reading and writing parameters and flags of a controller.

#[path = "../support/mod.rs"]
mod support;

use acrc_link::LinkError;
use acrc_link::values::{Register, Value, WriteError, read, write};
use support::Machine;

const SETUP: &str =
    "SYS\nDIM P(10)\nP1 = 0.1\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nACC 100 DEC 100 VEL 10\n";

#[test]
fn values_have_the_type_of_their_registers() {
    let mut connection = Machine::with(SETUP).connect();
    let registers =
        [Register::Parameter(1), Register::Bit(8467), Register::Parameter(4097), Register::Parameter(12288)];
    let values = read(&mut connection, &registers).expect("they are read");
    assert_eq!(values[0], Value::Number(0.1));
    assert_eq!(values[1], Value::Flag(false));
    assert_eq!(values[2], Value::Long(0));
    assert_eq!(values.iter().map(ToString::to_string).collect::<Vec<_>>().join(" "), "0.1 0 0 0");
}

#[test]
fn what_is_written_is_read_back() {
    let mut connection = Machine::with(SETUP).connect();
    assert_eq!(
        write(&mut connection, Register::Parameter(2), 1.0 / 3.0).ok(),
        Some(Value::Number(0.333_333_333_333_333)),
        "as it is printed"
    );
    assert_eq!(write(&mut connection, Register::Parameter(3), -2.5e-9).ok(), Some(Value::Number(-2.5e-9)));
    assert_eq!(write(&mut connection, Register::Bit(32), -1.0).ok(), Some(Value::Flag(true)));
    assert_eq!(write(&mut connection, Register::Bit(32), 0.0).ok(), Some(Value::Flag(false)));
}

#[test]
fn what_the_controller_refuses_is_told() {
    let mut connection = Machine::with(SETUP).connect();
    let error = write(&mut connection, Register::Parameter(10), 1.0).expect_err("there are ten");
    assert!(matches!(error, WriteError::Link(LinkError::Refused { .. })), "{error}");
    let error = write(&mut connection, Register::Bit(516), 1.0).expect_err("it is read-only");
    assert_eq!(error.to_string(), "the controller refused `SET 516`: BIT516 (In Motion) is read-only");
}
