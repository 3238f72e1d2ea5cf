//! What a host is given: arguments, references, waiting commands, typed lines.

mod support;

use acrc_vm::{Budget, Code, Frame, Locals, Stop, run};
use support::{Bench, MEMORY, Machine, image, output};

/// The calls that a program makes.
fn calls(text: &str) -> String {
    let mut machine = Machine::new(text);
    let stop = machine.finish();
    assert_eq!(stop, Stop::Ended, "{text}\n{:?}", machine.bench.log);
    machine.bench.log
}

/// Each program of `tests/programs` with the calls that it makes.
#[test]
fn programs_make_their_calls() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/programs");
    for name in ["arguments", "axes", "flags", "objects", "operands"] {
        let text = std::fs::read_to_string(format!("{folder}/{name}.8K")).unwrap();
        let mut machine = Machine::new(&text);
        assert_eq!(machine.finish(), Stop::Ended, "{name}");
        let Bench { log, output, .. } = &machine.bench;
        insta::with_settings!({ omit_expression => true, description => "program, calls, output" }, {
            insta::assert_snapshot!(name, format!("{text}\n{log}\n{output}"));
        });
    }
}

#[test]
fn aliases_of_flags_keep_their_sign() {
    let image = image(
        "#DEFINE Done BIT 128\n#DEFINE Lamp 33\nPROGRAM\nINH Done\nINH -Done\nSET Lamp\nSET Done\n\
            PRINT BIT33; Done\nENDP",
        false,
    );
    let mut machine = Machine::with(Code::load(&image.programs[0], &image.aliases).unwrap());
    assert_eq!(machine.finish(), Stop::Ended);
    let expected = "INH: Bit { index: 128, negative: false }\nINH: Bit { index: 128, negative: true }\n";
    assert_eq!((machine.bench.log.as_str(), machine.bench.output.as_str()), (expected, "-1-1\r\n"));
}

#[test]
fn aliases_stand_for_operands_and_constants() {
    let image = image(
        "#DEFINE Count LV0\n#DEFINE Last 3\n#DEFINE Speed P7\n#DEFINE Ready BIT 40\n#DEFINE Half 0.5\n\
            PROGRAM\nDIM LV(1)\nFOR Count = 1 TO Last\nSpeed = Speed + Half\nNEXT\nReady = Count > Last\n\
            IF (Ready) THEN PRINT Count; \" \"; Speed; Ready\nENDP",
        false,
    );
    let mut machine = Machine::with(Code::load(&image.programs[0], &image.aliases).unwrap());
    assert_eq!(machine.finish(), Stop::Ended);
    assert_eq!(machine.bench.output, "4 1.5-1\r\n");
}

#[test]
fn a_waiting_command_is_offered_again_with_the_same_arguments() {
    let mut machine = Machine::new("P0 = 1\nDWL (P0) : PRINT \"go\"");
    machine.bench.patience = 2;
    let run = machine.run(Budget::lines(4));
    assert_eq!((run.stop, run.used, run.statements), (Stop::Blocked, 2, 2));
    assert!(machine.frame.is_blocked());
    assert_eq!(machine.code.location(machine.frame.pc()).line, 2);
    machine.bench.parameters.insert(0, acrc_vm::Value::Double(9.0));
    let run = machine.run(Budget::lines(4));
    assert_eq!((run.stop, run.used, run.statements), (Stop::Blocked, 0, 0));
    assert_eq!(machine.finish(), Stop::Ended);
    assert_eq!(machine.bench.output, "go\r\n");
    assert_eq!(machine.bench.log, "DWL: Value(Double(1.0), None)\n");
}

#[test]
fn a_command_may_end_its_program() {
    assert_eq!(output("PRINT 1\nHALT\nPRINT 2"), "1\r\n");
}

#[test]
fn getch_waits_for_its_character() {
    let mut machine = Machine::new("DIM LV(1)\nLV0 = GETCH(1) + 1 : PRINT LV0");
    assert_eq!(machine.finish(), Stop::Blocked);
    assert_eq!(machine.finish(), Stop::Blocked);
    machine.bench.keys.push_back(b'A');
    assert_eq!(machine.finish(), Stop::Ended);
    assert_eq!(machine.bench.output, "66\r\n");
}

#[test]
fn input_fills_variables() {
    let program = "DIM LV(2)\nDIM $V(1,12)\nDIM DA(1)\nDIM DA0(2)\nINPUT; \"n = \"; LV0, DA0(1), P5, $V0\n\
        PRINT LV0; \" \"; DA0(1); \" \"; P5; \" \"; $V0\nINPUT LV1\nPRINT LV1";
    let mut machine = Machine::new(program);
    assert_eq!(machine.finish(), Stop::Blocked);
    machine.bench.lines.extend(["3.7, 2.5,x,rest, of it all", "5"]);
    assert_eq!(machine.finish(), Stop::Ended);
    assert_eq!(machine.bench.output, "3 2.5 0 rest, of it \r\n5\r\n");
}

#[test]
fn missing_input_is_zero() {
    let mut machine = Machine::new(
        "DIM LV(2) : DIM $V(1,5)\nLV0 = 9 : $V0 = \"x\"\nINPUT LV0, LV1, $V0\nPRINT LV0; LV1; \"<\"; $V0; \">\"",
    );
    machine.bench.lines.push_back("");
    machine.finish();
    assert_eq!(machine.bench.output, "00<>\r\n");
}

#[test]
fn dim_without_a_size_is_a_report() {
    assert_eq!(calls("DIM\nDIM LV"), "DIM: \nDIM LV: \n");
}

#[test]
fn immediate_statements_share_the_variables_of_their_program() {
    let stored = image("LV0 = LV0 + 1\nPRINT LV0", true);
    let program = Code::load(&stored.programs[0], &stored.aliases).unwrap();
    let typed = image("DIM LV(1)\nLV0 = 41 : END\nPRINT \"on\"", false);
    let typed = Code::load(&typed.boot, &typed.aliases).unwrap();
    let mut locals = Locals::new(MEMORY);
    let mut bench = Bench::default();
    let mut frame = Frame::new();
    assert_eq!(run(&typed, &mut frame, &mut locals, &mut bench, Budget::statements(100)).stop, Stop::Ended);
    assert_eq!(run(&program, &mut Frame::new(), &mut locals, &mut bench, Budget::lines(9)).stop, Stop::Ended);
    assert_eq!(bench.output, "on\r\n42\r\n");
    assert_eq!(bench.log, "PROG: Value(Long(0), None)\nEND: \n");
}

#[test]
fn words_of_a_prompt_go_to_the_host_there_only() {
    assert_eq!(calls("PROGRAM\nPBOOT\nENDP"), "");
    let typed = image("PBOOT\nP0 = 1\nEND", false);
    let mut machine = Machine::with(Code::load(&typed.boot, &typed.aliases).unwrap());
    assert_eq!(machine.finish(), Stop::Ended);
    assert_eq!(machine.bench.log, "PROG: Value(Long(0), None)\nPBOOT: \nEND: \n");
}

#[test]
fn a_refused_statement_can_be_skipped() {
    let mut machine = Machine::new("PRINT 1 / 0 : PRINT \"next\"\nPRINT \"last\"");
    for _ in 0..2 {
        if let Stop::Fault(_) = machine.finish() {
            machine.frame.skip_statement(&machine.code);
        }
    }
    assert_eq!(machine.bench.output, "next\r\nlast\r\n");
}

#[test]
fn what_depends_on_a_refused_statement_is_skipped_with_it() {
    for text in [
        "IF (1 / 0) THEN PRINT 1 : PRINT 2",
        "IF (1 / 0) : PRINT 1 : ELSE : PRINT 2 : ENDIF",
        "IF (0) : PRINT 1 : ELSEIF (1 / 0) : PRINT 2 : ELSEIF (1) : PRINT 3 : ENDIF",
        "WHILE (1 / 0)\nPRINT 1\nWEND",
        "FOR P0 = 1 TO 1 / 0\nPRINT 1\nNEXT",
    ] {
        let mut machine = Machine::new(&format!("{text}\nPRINT \"last\""));
        assert!(matches!(machine.finish(), Stop::Fault(_)), "{text}");
        machine.frame.skip_statement(&machine.code);
        assert_eq!(machine.finish(), Stop::Ended, "{text}");
        assert_eq!(machine.bench.output, "last\r\n", "{text}");
    }
}

#[test]
fn what_the_machine_executes_is_known() {
    assert!(acrc_vm::executes(acrc_catalog::command::WHILE));
    assert!(!acrc_vm::executes(acrc_catalog::command::PRINT));
}
