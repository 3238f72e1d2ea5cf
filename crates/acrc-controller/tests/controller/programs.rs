//! Program control from programs: RUN, HALT, PAUSE, RESUME, their flags, ends and faults (guide, "Starting, Pausing, and Halting Programs").

use acrc_controller::State;
use acrc_image::UnitName;

use crate::support::{Ran, Sim, TWO_AXES};

/// Program 0 has the axes; program 1 is started with it.
fn pair(zero: &str, one: &str) -> Sim {
    Sim::new(&format!("{TWO_AXES}PROGRAM\n{zero}\nENDP\nPROG1\nPROGRAM\n{one}\nENDP\n")).start(&[0, 1])
}

fn states(ran: &Ran) -> Vec<(u8, State)> {
    let programs = ran.controller.programs();
    let numbered = programs.iter().filter_map(|program| match program.unit {
        UnitName::Program(number) => Some((number, program.state)),
        UnitName::Boot | UnitName::Plc(_) => None,
    });
    numbered.collect()
}

#[test]
fn halt_ends_a_program_and_ramps_its_motion_down() {
    let ran = pair("X10\nX20\nX30\nPRINT \"no\"", "DWL 0.5\nHALT PROG0").run().clean();
    assert_eq!(states(&ran), [(0, State::Ended), (1, State::Ended)]);
    assert!((ran.position(0) - 5.0).abs() < 0.05, "{}", ran.position(0));
    assert!(!ran.bit(516) && !ran.bit(522), "HALT leaves no Kill All Moves");
}

#[test]
fn a_halted_program_can_run_again_and_move() {
    let ran = pair("X10\nINH -516\nPRINT \"there\"", "DWL 0.5\nHALT PROG0\nDWL 0.5\nRUN PROG0").run().clean();
    assert_eq!((ran.position(0), &*ran.record.output[0].text), (10.0, "there"));
}

#[test]
fn halting_a_program_at_rest_does_not_block_its_master() {
    let text = format!("{TWO_AXES}HALT PROG0\nHALT ALL\nPROGRAM\nX10\nINH -516\nENDP\n");
    assert_eq!(Sim::new(&text).start(&[0]).run().clean().position(0), 10.0);
}

#[test]
fn halt_keeps_a_kill_flag_that_is_set() {
    assert!(pair("SET 522\nDWL 1", "DWL 0.1\nHALT PROG0").run().clean().bit(522));
}

#[test]
fn a_program_halts_itself() {
    let ran = Sim::program("X10\nHALT PROG0\nPRINT \"no\"").run().clean();
    assert_eq!((states(&ran), ran.record.output.len()), (vec![(0, State::Ended)], 0));
    let ran = Sim::program("HALT ALL : PRINT \"no\"").run().clean();
    assert_eq!(ran.record.output.len(), 0);
}

#[test]
fn pause_and_resume_hold_program_and_motion() {
    let ran = pair("X10\nINH -516\nPRINT \"there\"", "DWL 0.5\nPAUSE PROG0\nDWL 5\nRESUME PROG0").run().clean();
    assert_eq!(ran.position(0), 10.0);
    assert_eq!(ran.record.output[0].milliseconds, 6100.0);
    let ran = pair("X10\nINH -516\nPRINT \"there\"", "DWL 0.5\nPAUSE PROG0\nDWL 2").until(2.0).run().clean();
    assert!(ran.bit(1048) && !ran.bit(1024) && ran.bit(519));
    assert_eq!(states(&ran), [(0, State::Paused), (1, State::Waiting)]);
}

#[test]
fn the_pause_flag_pauses_and_resumes() {
    let sim = pair("DWL 0.2\nPRINT \"on\"", "SET 1048\nDWL 1\nCLR 1048");
    let timed = sim.timed();
    assert_eq!(timed.len(), 1);
    assert!(timed[0].starts_with("100"), "{timed:?}");
}

#[test]
fn a_program_that_pauses_itself_stops_at_that_statement() {
    let sim = pair("PRINT 1\nPAUSE PROG0 : PRINT 2\nPRINT 3", "DWL 1\nPRINT \"resume\"\nRESUME PROG0");
    assert_eq!(sim.prints(), ["1", "resume", "2", "3"]);
}

#[test]
fn resume_also_ends_a_feedhold_that_was_requested_by_flag() {
    let ran = pair("X10\nINH -516", "DWL 0.5\nSET 520\nDWL 1\nRESUME PROG0").run().clean();
    assert_eq!(ran.position(0), 10.0);
}

#[test]
fn a_program_that_is_paused_when_its_motion_is_all_that_is_left_holds_it() {
    let ran = pair("X10", "DWL 0.5\nPAUSE PROG0\nDWL 1\nPRINT BIT(519)\nRESUME PROG0").run().clean();
    assert_eq!((&*ran.record.output[0].text, ran.position(0)), ("-1", 10.0));
}

#[test]
fn pausing_everything_holds_no_master_at_rest() {
    let ran = pair("END", "DWL 0.1\nPAUSE PROG0\nPRINT BIT(519)").run().clean();
    assert_eq!(ran.record.output[0].text, "0");
}

#[test]
fn the_run_request_flag_starts_a_program_and_clears_itself() {
    let text = format!("{TWO_AXES}PROGRAM\nPRINT \"zero\"\nENDP\nPROG1\nPROGRAM\nSET 1032\nPRINT BIT(1032)\nENDP\n");
    assert_eq!(Sim::new(&text).start(&[1]).prints(), ["0", "zero"]);
}

#[test]
fn the_running_flag_follows_the_program() {
    let sim = pair("DWL 0.3", "PRINT BIT(1024)\nINH -1024\nPRINT P6916\nPRINT BIT(1024); BIT(1056)");
    assert_eq!(sim.prints(), ["-1", "301", "0-1"]);
}

#[test]
fn the_running_flag_is_cleared_by_a_fault() {
    let ran = pair("DWL 0.3\nX1 X2", "INH -1024\nPRINT \"seen\"").run();
    assert_eq!((ran.record.faults.len(), &*ran.record.output[0].text), (1, "seen"));
}

#[test]
fn a_request_is_carried_out_before_the_next_line() {
    let sim = pair("RUN PROG2\nPRINT BIT(1088)", "END");
    assert_eq!(sim.prints(), ["0"], "a program without text does not run");
    let text = format!("{TWO_AXES}PROGRAM\nRUN PROG1\nPRINT BIT(1056)\nENDP\nPROG1\nPROGRAM\nDWL 1\nENDP\n");
    assert_eq!(Sim::new(&text).start(&[0]).prints(), ["-1"]);
}

#[test]
fn run_starts_a_running_program_from_its_beginning() {
    let sim = pair("PRINT \"start\"\nDWL 1\nPRINT \"end\"", "DWL 0.5\nRUN PROG0");
    assert_eq!(sim.prints(), ["start", "start", "end"]);
    let held = pair("PRINT \"start\"\nX10\nINH -516\nPRINT \"end\"", "DWL 0.5\nPAUSE PROG0\nDWL 1\nRUN PROG0");
    assert_eq!(held.prints(), ["start", "start", "end"]);
}

#[test]
fn new_erases_a_program() {
    let ran = pair("DWL 10\nPRINT \"no\"", "DWL 0.5\nNEW PROG0\nRUN PROG0").run().clean();
    assert_eq!((states(&ran), ran.record.output.len()), (vec![(1, State::Ended)], 0));
    let itself = Sim::program("NEW PROG0\nPRINT \"no\"").run().clean();
    assert_eq!((states(&itself), itself.record.output.len()), (vec![], 0));
}

#[test]
fn end_stops_execution_before_the_end_of_the_text() {
    assert_eq!(Sim::program("GOSUB One\nPRINT 2\nEND\n_One\nPRINT 1\nRETURN").prints(), ["1", "2"]);
    assert_eq!(Sim::program("PRINT 1").prints(), ["1"]);
}

#[test]
fn a_fault_stops_its_program_only() {
    let ran = pair("X10\nP0 = 1/0\nPRINT \"no\"", "DWL 2\nPRINT \"on\"").run();
    assert_eq!(states(&ran), [(0, State::Fault), (1, State::Ended)]);
    assert_eq!(ran.position(0), 10.0, "moves already given are finished");
    assert_eq!(ran.record.faults[0].to_string(), "PROG0 test.8K line 10 statement 1: division by zero");
    assert_eq!(ran.record.output[0].text, "on");
}

#[test]
fn program_numbers_are_those_of_the_model() {
    assert_eq!(Sim::program("RUN PROG16").faults(), ["PROG16 does not exist: this controller has PROG0 to PROG15"]);
    assert_eq!(Sim::program("RUN PLC8").faults(), ["PLC8 does not exist: this controller has PLC0 to PLC7"]);
}

#[test]
fn programs_that_begin_with_pboot_are_known() {
    let text = "PROG0\nPROGRAM\nREM first\nPBOOT\nENDP\nPROG1\nPROGRAM\nPRINT 1\nPBOOT\nENDP\n";
    assert_eq!(acrc_controller::Controller::boot_programs(&Sim::new(text).image()), [0]);
}

#[test]
fn random_numbers_follow_from_the_seed() {
    let draw = |seed: u64| Sim::program("PRINT RND(1000000)\nPRINT RND(1000000)").seed(seed).prints();
    assert_eq!(draw(1), draw(1));
    assert_ne!(draw(1), draw(2));
    assert_ne!(draw(1)[0], draw(1)[1]);
}
