//! PLC programs: rungs, timers, counters, latches, scans (`plc_ladder.toml`; `docs/fidelity.md`, "PLC programs").

use acrc_controller::State;
use acrc_image::UnitName;

use crate::support::{Ran, Sim, TWO_AXES};

/// PLC program 0 runs beside program 0.
fn beside(rungs: &str, program: &str) -> Sim {
    let text =
        format!("{TWO_AXES}SYS\nDIM PLC0(2000)\nPLC0\nPROGRAM\n{rungs}\nENDP\nRUN\nPROG0\nPROGRAM\n{program}\nENDP\n");
    Sim::new(&text).start(&[0])
}

fn plc(ran: &Ran) -> State {
    let programs = ran.controller.programs();
    programs.iter().find(|program| program.unit == UnitName::Plc(0)).expect("it has a text").state
}

/// What flag 40 is for each state of flags 128 to 130.
fn truth_table(rungs: &str) -> String {
    let program = "FOR LV0 = 0 TO 7\nP4100 = LV0\nDWL 0.01\nPRINT BIT 40\nNEXT";
    let lines = beside(rungs, &format!("DIM LV(1)\n{program}")).prints();
    lines.iter().map(|line| if line == "-1" { '1' } else { '0' }).collect()
}

#[test]
fn contacts_in_series_and_parallel() {
    assert_eq!(truth_table("LD 128\nAND 129\nOUT 40"), "00010001");
    assert_eq!(truth_table("LD 128\nOR 129\nOUT 40"), "01110111");
    assert_eq!(truth_table("LD NOT 128\nAND NOT 129\nOUT 40"), "10001000");
    assert_eq!(truth_table("LD 128\nOR NOT 130\nOUT NOT 40"), "00001010");
}

#[test]
fn blocks_in_series_and_parallel() {
    assert_eq!(truth_table("LD 128\nOR 129\nLD 130\nAND LD\nOUT 40"), "00000111");
    assert_eq!(truth_table("LD 128\nAND 129\nLD 130\nOR LD\nOUT 40"), "00011111");
}

#[test]
fn one_rung_may_drive_several_outputs() {
    let ran = beside("LD 128\nOUT 40\nOUT 41\nLD NOT 128\nOUT 42", "SET 128\nDWL 0.1").run().clean();
    assert_eq!([40, 41, 42].map(|bit| ran.bit(bit)), [true, true, false]);
}

#[test]
fn a_keep_relay_is_set_by_one_rung_and_reset_by_another() {
    let program = "SET 128\nDWL 0.01\nCLR 128\nDWL 0.01\nPRINT BIT 40\nSET 129\nDWL 0.01\nPRINT BIT 40\n\
                   SET 128\nDWL 0.01\nPRINT BIT 40";
    assert_eq!(beside("LD 128\nLD 129\nKR 40", program).prints(), ["-1", "0", "0"]);
}

#[test]
fn a_timer_comes_on_after_its_preset() {
    let program = "P6916 = 0\nSET 128\nINH 40\nPRINT P6916\nCLR 128\nDWL 0.01\nPRINT BIT 40";
    assert_eq!(beside("LD 128\nTIM 0 250\nOUT 40", program).prints(), ["252", "0"]);
}

#[test]
fn a_timer_that_loses_its_rung_starts_again() {
    let program = "SET 128\nDWL 0.2\nCLR 128\nDWL 0.01\nSET 128\nDWL 0.2\nPRINT BIT 40\nDWL 0.1\nPRINT BIT 40";
    assert_eq!(beside("LD 128\nTIM 0 250\nOUT 40", program).prints(), ["0", "-1"]);
}

#[test]
fn a_counter_counts_edges() {
    let pulse = "SET 128\nDWL 0.01\nCLR 128\nDWL 0.01\nPRINT BIT 40\n";
    let program = format!("{}SET 129\nDWL 0.01\nPRINT BIT 40", pulse.repeat(3));
    assert_eq!(beside("LD 128\nLD 129\nCNT 4 3\nOUT 40", &program).prints(), ["0", "0", "-1", "0"]);
}

#[test]
fn a_plc_program_scans_in_each_slice_before_the_programs() {
    let program = "SET 128\nPRINT BIT 40\nPRINT 1\nPRINT 2\nPRINT BIT 40";
    assert_eq!(beside("LD 128\nOUT 40", program).prints(), ["0", "1", "2", "-1"]);
}

#[test]
fn the_scan_period_can_be_chosen() {
    let sim = beside("LD 128\nOUT 40", "DWL 0.001\nP6916 = 0\nSET 128\nINH 40\nPRINT P6916").plc_scan(0.1);
    assert_eq!(sim.prints(), ["98"]);
}

#[test]
fn a_plc_program_may_also_compute() {
    let ran = beside("P0 = P0 + 1\nIF (P0 > 4) THEN HALT PLC0", "DWL 0.1").run().clean();
    assert_eq!((ran.controller.parameter(0), plc(&ran)), (Ok(acrc_vm::Value::Double(5.0)), State::Ended));
}

#[test]
fn plc_programs_start_and_stop_like_programs() {
    let ran = beside("LD 128\nOUT 40", "PRINT BIT 1536\nHALT PLC0\nSET 128\nDWL 0.1\nPRINT BIT 40; BIT 1536").run();
    assert_eq!(ran.record.output.iter().map(|line| &*line.text).collect::<Vec<_>>(), ["-1", "00"]);
    let by_flag =
        beside("LD 128\nOUT 40", "SET 1545\nDWL 0.1\nSET 128\nDWL 0.1\nPRINT BIT 40\nSET 1544\nDWL 0.1\nPRINT BIT 40");
    assert_eq!(by_flag.prints(), ["0", "-1"]);
    let erased = beside("LD 128\nOUT 40", "NEW PLC0\nSET 128\nDWL 0.1\nRUN PLC0\nDWL 0.1").run().clean();
    assert!(!erased.bit(40) && erased.controller.programs().len() == 1);
    assert_eq!(beside("LD 128", "PAUSE PLC0").faults(), ["PAUSE expects PROGn or ALL"]);
}

#[test]
fn a_plc_program_that_begins_with_pboot_starts_by_itself() {
    let text = "SYS\nDIM PLC3(200)\nPLC3\nPROGRAM\nPBOOT\nLD NOT 128\nOUT 40\nENDP\n";
    let ran = Sim::new(text).run().clean();
    assert!(ran.bit(40) && ran.bit(1536 + 3 * 32));
    assert!(ran.milliseconds() < 5.0, "nothing can happen any more");
}

#[test]
fn a_timer_keeps_a_run_of_nothing_else_going() {
    let text = "SYS\nDIM PLC0(200)\nPLC0\nPROGRAM\nPBOOT\nLD NOT 128\nTIM 0 5000\nOUT 40\nENDP\n";
    let ran = Sim::new(text).run().clean();
    assert!(ran.bit(40) && (5000.0..5003.0).contains(&ran.milliseconds()), "{}", ran.milliseconds());
}

#[test]
fn rungs_that_do_not_fit_together_stop_their_plc_program() {
    let faults = beside("AND 128\nOUT 40", "DWL 0.01").run().record.faults;
    assert_eq!(faults[0].to_string(), "PLC0 test.8K line 12 statement 1: AND needs LD in front of it on its rung");
    let faults = beside("LD 128\nAND LD\nOUT 40", "DWL 0.01").faults();
    assert_eq!(faults, ["AND LD needs two blocks that begin with LD in front of it on its rung"]);
}

#[test]
fn plc_programs_do_not_reach_the_upper_flags() {
    let faults = beside("LD 8192\nOUT 40", "DWL 0.01").faults();
    assert_eq!(faults, ["BIT8192 is out of reach: PLC programs of this controller use BIT0 to BIT8191"]);
}

#[test]
fn ladder_commands_belong_to_plc_programs() {
    assert_eq!(Sim::program("LD 128").faults(), ["LD is not possible at the program level"]);
}

#[test]
fn what_is_not_documented_is_said_once() {
    let notes = beside("LD 128\nTIM 0 10\nOUT NOT 40\nLD 129\nTIM 1 10\nOUT NOT 41", "DWL 0.1").run().notes();
    let wanted = [
        "PLC0 uses OUT NOT, whose behaviour is unconfirmed",
        "PLC0 uses TIM: presets are taken in milliseconds, which is unconfirmed",
    ];
    assert_eq!(notes, wanted);
}

/// Units and lines of the commands that keep a run from beginning.
fn refused(text: &str, programs: &[u8], plcs: &[u8]) -> Vec<(String, u32)> {
    let image = Sim::new(text).image();
    let found = acrc_controller::Controller::unsupported(&image, programs, plcs);
    found.iter().map(|item| (item.unit.to_string(), item.line.expect("the text is known"))).collect()
}

#[test]
fn what_a_run_may_start_is_looked_at_before_it() {
    // Line 4 of PLC1 cannot be executed, and nobody starts it; what is put in front moves it down.
    let plc = |before: &str, behind: &str| {
        format!("{before}SYS\nPLC1\nPROGRAM\nDTALK AXIS0\nENDP\nPROG0\nPROGRAM\n{behind}\nENDP\n")
    };
    assert_eq!(refused(&plc("", "SET 32"), &[0], &[]), []);
    assert_eq!(refused(&plc("", "SET 32"), &[0], &[1]), [("PLC1".to_owned(), 4)], "named by the project");
    for start in ["RUN PLC1", "RUN ALL", "SET 1576", "BIT 1576 = 1", "IF (BIT 24) THEN RUN PLC1"] {
        assert_eq!(refused(&plc("", start), &[0], &[]), [("PLC1".to_owned(), 4)], "{start}");
        assert_eq!(refused(&plc("", start), &[], &[]), [], "{start} in a program that nobody starts");
    }
    for setup in ["RUN PLC1", "RUN ALL", "PLC1 : RUN", "LRUN PLC1", "SET 1576", "#DEFINE Ladder BIT1576\nSET Ladder"] {
        let line = 4 + setup.lines().count() as u32;
        assert_eq!(refused(&plc(&format!("{setup}\n"), "SET 32"), &[], &[]), [("PLC1".to_owned(), line)], "{setup}");
    }
    assert_eq!(refused(&plc("RUN PLC2 : PROG0 : RUN\n", "SET 32"), &[], &[]), []);
}

#[test]
fn what_programs_start_is_followed() {
    let text = "PROG0\nPROGRAM\nRUN PROG1\nENDP\nPROG1\nPROGRAM\nRUN PROG2\nRUN PROG0\nENDP\nPROG2\nPROGRAM\nPBOOT\nDTALK AXIS0\nENDP\n";
    assert_eq!(refused(text, &[0], &[]), [("PROG2".to_owned(), 13)]);
    assert_eq!(refused(&text.replace("RUN PROG2", "RUN PROG3"), &[0], &[]), []);
    for all in ["PBOOT", "REBOOT"] {
        assert_eq!(refused(&format!("{all}\n{text}"), &[], &[]), [("PROG2".to_owned(), 14)], "{all}");
    }
}

#[test]
fn an_input_cannot_be_driven_whatever_its_rung_says() {
    for rung in ["LD 128", "LD NOT 128"] {
        let ran = beside(&format!("{rung}\nOUT 0"), "DWL 0.1").run();
        assert_eq!(ran.record.faults[0].message, "BIT0 (Onboard input) is read-only", "{rung}");
        assert_eq!(plc(&ran), State::Fault, "{rung}");
    }
}
