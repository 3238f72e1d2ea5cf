//! Memory of the system and of programs (guide, "Memory Allocations").

use crate::support::Sim;

#[test]
fn a_block_is_dimensioned_once() {
    assert_eq!(
        Sim::new("SYS\nDIM P(10)\nDIM P(20)\n").faults(),
        ["Re-dimensioned block: P has 80 bytes already; CLEAR frees them"]
    );
    assert_eq!(
        Sim::new("SYS\nDIM PROG0(8192)\n").faults(),
        ["Re-dimensioned block: PROG0 has 65536 bytes already; CLEAR frees them"]
    );
    Sim::new("SYS\nCLEAR\nDIM P(10)\nDIM PROG0(8192)\nDIM DEF 20\nCLEAR\nDIM P(20)\n").run().clean();
}

#[test]
fn memory_runs_out() {
    let faults = Sim::new("SYS\nCLEAR\nDIM PROG0(1000000)\nDIM PROG1(100000)\n").faults();
    assert_eq!(faults, ["out of memory: 100000 bytes are needed and 48576 are free"]);
    assert_eq!(Sim::new("SYS\nDIM P(5000)\n").faults(), ["the size must be between 1 and 4096"]);
    assert_eq!(Sim::new("SYS\nDIM DEF(1000000)\n").faults().len(), 1);
}

#[test]
fn a_program_that_does_not_fit_its_space_is_not_stored() {
    let text = "SYS\nCLEAR\nDIM PROG0(16)\nPROG0\nPROGRAM\nPRINT \"long text\"\nENDP\nRUN PROG0\n";
    let ran = Sim::new(text).run();
    assert_eq!(ran.record.faults[0].message, "PROG0 needs 17 bytes but DIM PROG0 gives 16");
    assert_eq!((ran.record.faults[0].line, ran.record.output.len()), (Some(5), 0));
    assert_eq!(ran.controller.programs().len(), 0);
}

#[test]
fn a_program_without_space_is_not_stored() {
    let ran = Sim::new("PROG9\nPROGRAM\nEND\nENDP\n").run();
    assert_eq!(ran.record.faults.len(), 1);
}

#[test]
fn variables_fit_beside_the_text_of_their_program() {
    let text = |bytes: u32| {
        format!("SYS\nCLEAR\nDIM PROG0({bytes})\nPROG0\nPROGRAM\nDIM LV(10)\nLV9 = 1\nPRINT LV9\nENDP\nRUN PROG0\n")
    };
    assert_eq!(Sim::new(&text(200)).prints(), ["1"]);
    let faults = Sim::new(&text(60)).faults();
    assert!(faults.len() == 1 && faults[0].contains("40 bytes"), "{faults:?}");
}

#[test]
fn variables_belong_to_their_program_and_outlive_its_runs() {
    let text = "PROG0\nDIM LV(1)\nLV0 = 7\nPROGRAM\nLV0 = LV0 + 1\nPRINT LV0\nENDP\nPROG1\nDIM LV(1)\nPROGRAM\nPRINT LV0\n\
                DWL 0.1\nRUN PROG0\nENDP\n";
    assert_eq!(Sim::new(text).start(&[0, 1]).prints(), ["8", "0", "9"]);
}

#[test]
fn a_second_dim_needs_a_clear() {
    assert_eq!(Sim::program("DIM LV(2)\nDIM LV(3)").faults(), ["Re-dimensioned block"]);
    assert_eq!(Sim::program("DIM LV(2)\nCLEAR\nDIM LV(3)\nLV2 = 5\nPRINT LV2").prints(), ["5"]);
}

#[test]
fn clear_at_the_system_prompt_frees_the_variables_of_programs() {
    let text = "PROG0\nDIM LV(1)\nSYS\nCLEAR\nDIM PROG0(100)\nPROG0\nDIM LV(2)\nLV1 = 3\nPRINT LV1\n";
    assert_eq!(Sim::new(text).prints(), ["3"]);
}

#[test]
fn space_with_a_program_is_not_cleared() {
    let text = "PROG0\nPROGRAM\nPRINT 1\nENDP\nSYS\nCLEAR\n";
    let faults = Sim::new(text).faults();
    assert_eq!(faults, ["PROG0 has a program: NEW erases it before CLEAR can free its space"]);
    Sim::new(&format!("{}NEW ALL\nCLEAR\nDIM PROG0(100)\n", text.trim_end_matches("CLEAR\n"))).run().clean();
}

#[test]
fn plc_programs_have_a_space_of_their_own() {
    let text = "PLC2\nPROGRAM\nLD 0\nOUT 32\nENDP\n";
    assert_eq!(Sim::new(text).faults(), ["PLC2 needs 16 bytes but DIM PLC2 gives 0"]);
    Sim::new(&format!("SYS\nDIM PLC2(200)\n{text}")).run().clean();
}

#[test]
fn stream_buffers_take_system_memory_once() {
    let sim = |lines: &str| Sim::new(&format!("SYS\n{lines}\n"));
    sim("DIM COM1(512)\nDIM STREAM2(1024)\nCLEAR COM1\nDIM COM1(100)\nCLEAR STREAM2\nDIM STREAM2(10)").run().clean();
    assert_eq!(
        sim("DIM COM1(512)\nDIM COM1(512)").faults(),
        ["Re-dimensioned block: COM1 has 512 bytes already; CLEAR frees them"]
    );
    assert_eq!(
        sim("DIM FIFO(512)").faults(),
        ["ACR9000 has no FIFO: its streams are COM1, COM2, STREAM1, STREAM2, STREAM3, STREAM4, STREAM5"]
    );
}

#[test]
fn system_blocks_are_not_for_programs() {
    assert_eq!(Sim::program("DIM PROG3(100)").faults().len(), 1);
    let faults = Sim::new("PROG0\nDIM P(10)\n").faults();
    assert_eq!(faults, ["DIM P is not possible at the program level"]);
}
