//! What a terminal and block mode need: single lines and statements, statements beside a program, edited text, and
//! variables that are kept.

mod support;

use acrc_catalog::OperandClass;
use acrc_vm::{
    Budget, Code, FaultKind, Frame, Locals, LocalsImage, Reference, RestoreError, Stop, Text, TextsImage, Value, run,
};
use proptest::prelude::*;
use support::{MEMORY, Machine, image, load};

/// Executes a statement that is typed at the prompt of a machine's program.
fn type_in(machine: &mut Machine, text: &str) -> Stop {
    let image = image(text, false);
    let code = Code::load(&image.boot, &image.aliases).expect("it loads");
    // The boot unit begins with the switch to the prompt.
    let mut frame = Frame::beside(&machine.frame);
    run(&code, &mut frame, &mut machine.locals, &mut machine.bench, Budget::statements(100)).stop
}

#[test]
fn a_line_at_a_time_ends_with_its_line() {
    let mut machine = Machine::new("PRINT 1; : PRINT 2;\nPRINT 3; : PRINT 4; : PRINT 5;\nPRINT 6;");
    assert_eq!(machine.run(Budget::lines(1)).stop, Stop::Budget);
    assert_eq!(machine.bench.output, "12");
    // Within a line, the rest of it is what a line is.
    assert_eq!(machine.run(Budget::statements(1)).stop, Stop::Budget);
    assert_eq!(machine.run(Budget::lines(1)).stop, Stop::Budget);
    assert_eq!(machine.bench.output, "12345");
    assert_eq!(machine.code.location(machine.frame.pc()).line, 3);
    assert_eq!(machine.run(Budget::lines(1)).stop, Stop::Ended);
    assert_eq!(machine.bench.output, "123456");
}

#[test]
fn a_loop_within_a_line_is_cut_the_same_in_every_budget() {
    let program = "P0 = 1 : WHILE (P0 < 2000) : P0 = P0 + 1 : WEND : PRINT P0";
    let mut whole = Machine::new(program);
    let used = whole.run(Budget::lines(1000)).used;
    let mut cut = Machine::new(program);
    let mut runs = 1;
    while cut.run(Budget::lines(1)).stop == Stop::Budget {
        runs += 1;
    }
    assert_eq!(whole.bench.output, "2000\r\n");
    assert_eq!(cut.bench.output, whole.bench.output);
    assert_eq!(runs, used);
}

#[test]
fn a_typed_statement_uses_the_variables_of_the_program() {
    let mut machine = Machine::new("DIM LV(2)\nLV0 = 5\nLV0 = LV0 + 1\nPRINT LV0");
    machine.run(Budget::lines(2));
    assert_eq!(type_in(&mut machine, "LV0 = LV0 * 2 : PRINT LV0"), Stop::Ended);
    assert_eq!(machine.finish(), Stop::Ended);
    assert_eq!(machine.bench.output, "10\r\n11\r\n");
}

#[test]
fn a_typed_statement_shares_the_memory_with_the_calls_of_the_program() {
    let mut machine = Machine::new("GOSUB Sub\nEND\n_Sub\nGOSUB Inner\nRETURN\n_Inner\nHALT");
    machine.locals.set_limit(16);
    machine.run(Budget::lines(6));
    assert_eq!(machine.frame.depth(), 2);
    let Stop::Fault(fault) = type_in(&mut machine, "DIM LV(3)") else { panic!("no fault") };
    assert_eq!(fault.kind, FaultKind::OutOfMemory { needed: 12, free: 8 });
    assert_eq!(type_in(&mut machine, "DIM LV(2)"), Stop::Ended);
}

#[test]
fn edited_text_takes_the_place_of_the_old_one() {
    let mut machine = Machine::new("DIM LV(1)\nLV0 = 7\nEND");
    machine.finish();
    machine.code = load("PRINT LV0");
    machine.frame.reset();
    assert_eq!(machine.finish(), Stop::Ended);
    assert_eq!(machine.bench.output, "7\r\n");
}

#[test]
fn an_interrupt_of_the_host_stops_in_front_of_the_next_line() {
    struct Shy(support::Bench, Vec<u32>);
    impl acrc_vm::Host for Shy {
        fn parameter(&mut self, number: i64) -> Result<Value, FaultKind> {
            self.0.parameter(number)
        }
        fn set_parameter(&mut self, number: i64, value: &Value) -> Result<(), FaultKind> {
            self.0.set_parameter(number, value)
        }
        fn bit(&mut self, number: i64) -> Result<bool, FaultKind> {
            self.0.bit(number)
        }
        fn set_bit(&mut self, number: i64, state: bool) -> Result<(), FaultKind> {
            self.0.set_bit(number, state)
        }
        fn command(&mut self, call: &acrc_vm::Call) -> Result<acrc_vm::Outcome, FaultKind> {
            self.0.command(call)
        }
        fn random(&mut self, below: u32) -> u32 {
            self.0.random(below)
        }
        fn take_character(&mut self, device: i32) -> Result<Option<u8>, FaultKind> {
            self.0.take_character(device)
        }
        fn character_waits(&mut self, device: i32) -> Result<bool, FaultKind> {
            self.0.character_waits(device)
        }
        fn reached(&mut self, used: u32) {
            self.1.push(used);
        }
        fn interrupts(&self) -> bool {
            true
        }
    }
    let code = load("P0 = 1\nP0 = 2\nSET 40 : PRINT 1;\nP38912 = 1\nP1 = 3");
    let mut host = Shy(support::Bench::default(), Vec::new());
    let (mut frame, mut locals) = (Frame::new(), Locals::new(MEMORY));
    let stopped = run(&code, &mut frame, &mut locals, &mut host, Budget::lines(10));
    assert_eq!((stopped.stop, stopped.used, stopped.statements), (Stop::Budget, 3, 4));
    assert_eq!((code.location(frame.pc()).line, host.0.output.as_str()), (4, "1"));
    let stopped = run(&code, &mut frame, &mut locals, &mut host, Budget::lines(10));
    assert_eq!((stopped.stop, stopped.used), (Stop::Budget, 1));
    // The user variables are not asked for.
    assert_eq!(host.1, [3, 3, 1]);
}

/// A program with variables of every class.
const EVERY_CLASS: &str = "DIM LV(2)\nDIM SV(1)\nDIM DV(2)\nDIM $V(2,5)\nDIM LA(2)\nDIM LA1(2)\nDIM SA(1)\nDIM SA0(1)\n\
    DIM DA(1)\nDIM DA0(2)\nDIM $A(2)\nDIM $A0(2,3)\nLV1 = -5 : SV0 = 0.1 : DV1 = 1/3 : $V0 = CHR$(255) : LA1(1) = 9\n\
    SA0(0) = 2.5 : DA0(1) = 1e-300 : $A0(1) = \"abc\" : DIM MBUF(2)";

#[test]
fn variables_come_back_as_they_were() {
    let mut machine = Machine::new(EVERY_CLASS);
    assert_eq!(machine.finish(), Stop::Ended);
    let image = machine.locals.image();
    assert_eq!((image.longs.clone(), image.moves), (Some(vec![0, -5]), Some(2)));
    assert_eq!(image.long_arrays, Some(vec![None, Some(vec![0, 9])]));
    assert_eq!(image.texts, Some(TextsImage { length: 5, items: vec![Text::from(&[255][..]), Text::default()] }));
    let restored = Locals::restore(MEMORY, image.clone()).expect("a program left it behind");
    assert_eq!(restored.image(), image);
    assert_eq!((restored.used(), restored.dimensions()), (machine.locals.used(), machine.locals.dimensions()));
    let element = Reference::Element { class: OperandClass::Da, array: 0, element: 1 };
    assert_eq!(restored.read(element), Ok(Value::Double(1e-300)));
    // What had no memory can still get it; what had cannot.
    machine.locals = restored;
    let Stop::Fault(fault) = type_in(&mut machine, "DIM LA0(3) : DIM SA0(1)") else { panic!("no fault") };
    assert_eq!(fault.kind, FaultKind::Redimensioned);
    assert_eq!(machine.locals.array_size(OperandClass::La, 0), Some(3));
}

#[test]
fn nothing_comes_back_as_nothing() {
    assert_eq!(Locals::new(7).image(), LocalsImage::default());
    assert_eq!(Locals::restore(0, LocalsImage::default()).expect("nothing needs nothing").used(), 0);
}

#[test]
fn variables_that_no_program_left_behind_are_refused() {
    let texts = |length, text: &str| TextsImage { length, items: vec![Text::from(text)] };
    let empty = LocalsImage::default;
    let cases = [
        (LocalsImage { longs: Some(vec![0; 3]), ..empty() }, "the variables need 12 bytes, the program has 8"),
        (LocalsImage { doubles: Some(vec![f64::NAN]), ..empty() }, "DV holds a value that is no finite number"),
        (
            LocalsImage { single_arrays: Some(vec![None, Some(vec![f32::INFINITY])]), ..empty() },
            "SA holds a value that is no finite number",
        ),
        (LocalsImage { texts: Some(texts(2, "abc")), ..empty() }, "$V holds a string of 3 characters where 2 fit"),
        (
            LocalsImage { text_arrays: Some(vec![Some(texts(1, "ab"))]), ..empty() },
            "$A holds a string of 2 characters where 1 fit",
        ),
    ];
    for (image, message) in cases {
        let error: RestoreError = Locals::restore(8, image).expect_err(message);
        assert_eq!(error.to_string(), message);
    }
}

proptest! {
    #[test]
    fn numbers_come_back_to_the_bit(longs: Vec<i32>, doubles in prop::collection::vec(prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL | prop::num::f64::ZERO, 0..9)) {
        let image = LocalsImage { longs: Some(longs), doubles: Some(doubles), ..LocalsImage::default() };
        let bits = |image: &LocalsImage| image.doubles.iter().flatten().map(|value| value.to_bits()).collect::<Vec<_>>();
        let restored = Locals::restore(MEMORY, image.clone()).expect("it fits").image();
        prop_assert_eq!(bits(&restored), bits(&image));
        prop_assert_eq!(restored.longs, image.longs);
    }
}
