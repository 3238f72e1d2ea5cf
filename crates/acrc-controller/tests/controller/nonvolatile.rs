//! What outlasts a reset (guide, "Memory Allocations", "Resetting the Controller", "Return to Factory Default"; `docs/nonvolatile.md`).

use std::sync::Arc;

use acrc_controller::nonvolatile::{RestoreError, Saved};
use acrc_controller::{Controller, Options};

use crate::support::{Record, Sim, TWO_AXES};

/// A controller with what another one has left, and what it does with a text.
fn again(saved: &Saved, battery: bool, text: &str) -> (Controller, Record) {
    let image = Arc::new(Sim::new(text).image());
    let mut controller =
        Controller::with_memory(image, Options::default(), battery, Some(saved)).expect("saved just now");
    let mut record = Record::default();
    let start = controller.kept_boot_programs();
    controller.run(&start, 10.0, &mut record);
    (controller, record)
}

fn texts(record: &Record) -> Vec<&str> {
    record.output.iter().map(|line| line.text.as_str()).collect()
}

#[test]
fn a_reset_brings_back_what_esave_saved() {
    let text = format!(
        "{TWO_AXES}PPU X4000\nPGAIN X0.5\nSYS\nESAVE\nPROG0\nVEL 20\nPPU X1\nPGAIN X9\nREBOOT\nPROG0\nVEL\nACC\nPPU X\nPGAIN X\n"
    );
    assert_eq!(Sim::new(&text).prints(), ["10", "100", "4000", "0.5"]);
}

#[test]
fn what_was_not_saved_is_lost() {
    let text = format!("{TWO_AXES}PPU X4000\nREBOOT\nAXIS0 PPU\nPROG0\nX1\n");
    let ran = Sim::new(&text).run();
    assert_eq!(texts(&ran.record), ["1"]);
    assert_eq!(ran.record.faults[0].message, "program 0 has no master: ATTACH MASTER comes first");
}

#[test]
fn erase_forgets_what_was_saved_and_leaves_what_is_used() {
    let text = format!("{TWO_AXES}SYS\nESAVE\nERASE\nPROG0\nVEL\nREBOOT\nATTACH MASTER0\nPROG0\nATTACH MASTER0\nVEL\n");
    assert_eq!(texts(&Sim::new(&text).run().record), ["10", "0"]);
}

#[test]
fn settings_of_masters_are_saved() {
    let report = "PROG0\nROV\nTOV\nSRC\nLOOK ANG\nROTARY X\n";
    let set = "ROV 0.5 TOV 0.25 SRC ENC1\nLOOK ANG 10 45\nROTARY X360\n";
    let text = format!(
        "{TWO_AXES}{set}SYS\nESAVE\nPROG0\nROV 1 SRC CLOCK\nREBOOT\n{report}SYS\nERASE\nREBOOT\nPROG0\nATTACH MASTER0\nROV\nSRC\n"
    );
    assert_eq!(Sim::new(&text).prints(), ["0.5", "0.25", "ENC1", "10", "45", "360", "1", "CLOCK"]);
}

#[test]
fn eload_brings_back_what_esave_saved() {
    let text = format!(
        "{TWO_AXES}DETACH SLAVE1\nSYS\nESAVE\nPROG0\nVEL 20\nATTACH SLAVE1 AXIS5 \"Z\"\nSYS\nELOAD\nPROG0\nVEL\nATTACH SLAVE1 AXIS5 \"W\"\nX1 W1\n"
    );
    let ran = Sim::new(&text).run().clean();
    assert_eq!((texts(&ran.record), ran.position(5)), (vec!["10"], 1.0));
}

#[test]
fn eload_is_not_valid_in_motion() {
    assert_eq!(Sim::program("ESAVE\nX10\nELOAD").faults(), ["Not valid while in motion"]);
}

#[test]
fn eload_without_anything_saved_changes_nothing() {
    let ran = Sim::new(&format!("{TWO_AXES}ELOAD\nVEL\n")).run().clean();
    assert_eq!(texts(&ran.record), ["10"]);
    assert!(ran.notes().iter().any(|note| note.contains("no saved system parameters")));
}

#[test]
fn the_battery_keeps_programs_and_user_parameters_but_no_local_variables() {
    let text = "SYS\nDIM P(5)\nP0 = 7\nPROG1\nDIM LV(1)\nPROGRAM\nPRINT \"one\"\nENDP\nREBOOT\nPRINT P0\nRUN PROG1\nPROG1\nDIM LV(1)\n";
    assert_eq!(Sim::new(text).prints(), ["7", "one"]);
}

#[test]
fn breset_loses_them_at_the_next_reset() {
    let text = "SYS\nDIM P(5)\nPROG1\nPROGRAM\nPRINT \"one\"\nENDP\nSYS\nBRESET\nP0 = 7\nPRINT P0\nREBOOT\nRUN PROG1\nPRINT P0\n";
    let ran = Sim::new(text).run();
    assert_eq!(texts(&ran.record), ["7"]);
    assert_eq!(ran.record.faults[0].message, "P0 is outside DIM P(0)");
}

#[test]
fn only_a_power_cycle_connects_the_battery_again() {
    let ran = Sim::new("SYS\nBRESET\nREBOOT\nDIM P(1)\nP0 = 3\n").run().clean();
    let (mut controller, mut record) = (ran.controller, ran.record);
    assert_eq!(controller.saved().memory, None);
    controller.power_cycle(&mut record);
    assert!(controller.parameter(0).is_err(), "the memory was lost when power went off");
    assert!(controller.saved().memory.is_some());
}

#[test]
fn programs_with_pboot_start_after_a_reset() {
    let body = "PBOOT\nP0 = P0 + 1\nPRINT P0\nIF (P0 < 3) THEN REBOOT\nPRINT \"end\"";
    let text = format!("SYS\nDIM P(1)\nPROG3\nPROGRAM\n{body}\nENDP\nPROG4\nPROGRAM\nPRINT \"never\"\nENDP\n");
    assert_eq!(Sim::new(&text).start(&[3]).prints(), ["1", "2", "3", "end"]);
}

#[test]
fn kept_plc_programs_with_pboot_start_at_power_up_and_after_a_reset() {
    let plcs = "SYS\nDIM P(2)\nDIM PLC0(200)\nDIM PLC1(200)\nPLC0\nPROGRAM\nPBOOT\nLD NOT 128\nOUT 40\nENDP\n\
                PLC1\nPROGRAM\nLD NOT 128\nOUT 41\nENDP\n";
    let mut first = Sim::new(plcs).run().clean().controller;
    assert!(first.bit(40).expect("a flag") && !first.bit(41).expect("a flag"));
    let (second, _) = again(&first.saved(), true, "");
    assert!(second.bit(40).expect("a flag") && !second.bit(41).expect("a flag"));
    let reboot = "PROG0\nPROGRAM\nPBOOT\nP0 = P0 + 1\nIF (P0 < 2) THEN HALT PLC0 : CLR 40 : REBOOT\nENDP\n";
    let ran = Sim::new(&format!("{plcs}{reboot}")).start(&[0]).run().clean();
    assert!(ran.bit(40) && ran.bit(1536));
}

#[test]
fn a_reset_ends_programs_and_motion_and_turns_outputs_off() {
    let world = "[[event]]\nat = 0.1\nset = [3]\n";
    let text = format!(
        "{TWO_AXES}PROGRAM\nSET 32\nX10\nINH 128\nENDP\nPROG1\nPROGRAM\nDWL 0.5\nREBOOT\nPRINT \"never\"\nENDP\n"
    );
    let ran = Sim::new(&text).start(&[0, 1]).world(world).run().clean();
    assert_eq!((ran.bit(32), ran.bit(3), ran.position(0)), (false, true, 0.0));
    assert!(ran.record.output.is_empty() && ran.milliseconds() < 600.0);
    assert_eq!(ran.controller.parameter(6916).map(|value| value.to_long()), Ok(Ok(0)));
}

#[test]
fn an_image_in_flash_takes_the_place_of_the_memory() {
    let text = |between: &str| format!("SYS\nDIM P(2)\nP0 = 1\nFLASH IMAGE\nP0 = 2\n{between}\nPRINT P0\n");
    assert_eq!(Sim::new(&text("REBOOT")).prints(), ["1"]);
    assert_eq!(Sim::new(&text("FLASH LOAD")).prints(), ["1"]);
    assert_eq!(Sim::new(&text("FLASH RES\nREBOOT")).prints(), ["2"]);
    assert_eq!(Sim::new(&text("FLASH RES\nREBOOT\nFLASH LOAD")).prints(), ["1"]);
    assert_eq!(Sim::new(&text("FLASH ERASE\nREBOOT")).prints(), ["2"]);
    assert_eq!(Sim::new(&text("BRESET\nREBOOT")).prints(), ["1"]);
}

#[test]
fn flash_save_keeps_programs_and_no_user_parameters() {
    let text = |between: &str| {
        format!(
            "SYS\nDIM P(2)\nP0 = 1\nPROG0\nPROGRAM\nPRINT \"zero\"\nENDP\nSYS\nFLASH SAVE\nP0 = 2\nNEW ALL\n{between}\nRUN PROG0\nPRINT P0\n"
        )
    };
    assert_eq!(Sim::new(&text("REBOOT")).prints(), ["2", "zero"]);
    let lost = Sim::new(&text("BRESET\nREBOOT")).run();
    assert_eq!((texts(&lost.record), lost.record.faults.len()), (vec!["zero"], 1));
}

#[test]
fn what_the_model_does_not_have_is_refused() {
    let refused = |model, text: &str| Sim::new(&format!("SYS\n{text}\n")).model(model).faults();
    assert_eq!(refused("ACR8000", "FLASH SAVE"), ["FLASH SAVE: ACR8000 does not have it"]);
    assert_eq!(refused("ACR9000", "PROM"), ["PROM: ACR9000 does not have it"]);
    assert_eq!(refused("ACR9000", "FLASH LOAD"), ["FLASH LOAD: there is no image in flash memory"]);
    assert_eq!(refused("ACR9000", "FLASH SAVE : FLASH LOAD"), Vec::<String>::new());
}

#[test]
fn prom_sends_the_programs() {
    let ran = Sim::new("PROG0\nPROGRAM\nPRINT 1\nENDP\nSYS\nPROM\n").model("ACR8010").run().clean();
    let text = texts(&ran.record).concat();
    // The first record behind the upper half of the address begins with the magic of an image.
    assert!(text.starts_with(":020000040000FA\r\n:1000000041435258") && text.ends_with(":00000001FF"), "{text}");
    assert!(ran.notes().iter().any(|note| note.contains("unconfirmed")));
}

#[test]
fn the_sequence_of_the_guide_leads_back_to_the_factory() {
    let sequence = "SYS\nHALT ALL\nNEW ALL\nDETACH ALL\nCLEAR\nERASE\nFLASH ERASE\nCONFIG CLEAR\nCLEAR COM1\nCLEAR COM2\nBRESET\nREBOOT\n";
    let text = format!("{TWO_AXES}PROGRAM\nPBOOT\nX1\nENDP\nSYS\nP38912 = 4\nP0 = 2\nESAVE\nFLASH IMAGE\n{sequence}");
    let mut used = Sim::new(&text).run().clean();
    let mut new = Sim::new("SYS\n").run().clean();
    used.controller.power_cycle(&mut used.record);
    new.controller.power_cycle(&mut new.record);
    assert_eq!(used.controller.saved(), new.controller.saved());
}

#[test]
fn what_one_controller_saved_another_one_has() {
    let text = format!("{TWO_AXES}PROGRAM\nPBOOT\nPRINT P1\nX P1\nENDP\nSYS\nP1 = 4\nESAVE\n").replace("X P1", "X(P1)");
    let mut first = Sim::new(&text).run().clean();
    let saved = first.controller.saved();
    let (mut controller, record) = again(&saved, true, "SYS\n");
    assert_eq!(texts(&record), ["4"]);
    assert_eq!(controller.view().position(0), 4.0);
    assert_eq!(controller.saved(), saved, "a run that saves nothing leaves all as it was");

    let (_, record) = again(&Saved { memory: None, ..saved.clone() }, true, "PROG0\nVEL\nPRINT P1\n");
    assert_eq!((texts(&record), record.faults.len()), (vec!["10"], 1), "without memory, the saved parameters are left");
}

#[test]
fn without_a_battery_flash_memory_is_what_is_left() {
    let text = "SYS\nDIM P(2)\nP1 = 4\nP38912 = 5\nP39000 = 6\nPROG0\nPROGRAM\nPBOOT\nPRINT P1\nENDP\nSYS\nFLASH IMAGE\nP1 = 9\n";
    let (mut controller, _) = again(&Saved { model: "ACR9000".into(), ..Saved::default() }, false, text);
    let saved = controller.saved();
    assert_eq!((saved.memory.is_none(), saved.retained.len()), (true, 1));
    let (mut controller, record) = again(&saved, false, "SYS\nPRINT P38912, P39000\nBRESET\n");
    assert_eq!(texts(&record), ["5\t0", "4"]);
    assert_eq!(record.faults[0].message, "BRESET: this controller has no battery");
    assert_eq!(controller.saved().image, saved.image);
}

#[test]
fn kept_programs_and_a_new_download_each_have_their_aliases() {
    let first = "SYS\nDIM P(4)\nDIM DEF(4)\n#DEFINE Other P3\n#DEFINE Count P0\nPROG0\nPROGRAM\nCount = Count + 1\nPRINT Count\nENDP\n";
    let saved = Sim::new(first).run().clean().controller.saved();
    let second = "#DEFINE Count P1\n#DEFINE Other P3\nPROG1\nPROGRAM\nCount = 50 : Other = 9\nPRINT Count, P3\nENDP\nRUN PROG1\nRUN PROG0\n";
    let (mut controller, record) = again(&saved, true, second);
    let mut printed = texts(&record);
    printed.sort_unstable();
    assert_eq!(printed, ["1", "50\t9"], "{:?}", record.faults);
    let aliases = controller.saved().memory.expect("a battery").aliases;
    let names: Vec<&str> = aliases.iter().map(|alias| alias.name.as_str()).collect();
    assert_eq!(names, ["Other", "Count", "Count"]);
}

#[test]
fn what_another_model_saved_is_refused() {
    let saved = Sim::new("SYS\n").model("ACR8020").run().controller.saved();
    let image = Arc::new(Sim::new("SYS\n").image());
    let refused = Controller::with_memory(image, Options::default(), true, Some(&saved)).map(drop);
    assert_eq!(refused, Err(RestoreError::Model { saved: "ACR8020".into(), model: "ACR9000" }));
}

#[test]
fn saved_data_that_contradicts_itself_is_refused() {
    let saved = Sim::new(&format!("{TWO_AXES}PROGRAM\nX1\nENDP\nSYS\nESAVE\n")).run().clean().controller.saved();
    let refuse = |change: fn(&mut Saved)| {
        let mut changed = saved.clone();
        change(&mut changed);
        let image = Arc::new(Sim::new("SYS\n").image());
        let refused = Controller::with_memory(image, Options::default(), true, Some(&changed)).map(drop);
        refused.map_err(|error| error.to_string()).expect_err("refused")
    };
    let mut said = vec![
        refuse(|saved| saved.memory.as_mut().expect("there").user.push(1.0)),
        refuse(|saved| saved.memory.as_mut().expect("there").blocks.clear()),
        refuse(|saved| saved.memory.as_mut().expect("there").programs[0].words[0] = u32::MAX),
        refuse(|saved| saved.parameters.as_mut().expect("there").axes.extend_from_within(..)),
        refuse(|saved| saved.parameters.as_mut().expect("there").axes[0].pulses_per_unit = f64::NAN),
        refuse(|saved| saved.parameters.as_mut().expect("there").masters[0].slaves[1].axis = 0),
        refuse(|saved| saved.parameters.as_mut().expect("there").parameters.push((5, acrc_vm::Value::Long(1)))),
        refuse(|saved| saved.retained.push((12_288, acrc_vm::Value::Long(1)))),
    ];
    said.dedup();
    assert_eq!(said.len(), 8, "each has its own reason: {said:#?}");
}

#[test]
fn loaded_settings_of_objects_are_in_force() {
    // Saved, a pulse of the encoder counts twice.
    let body = "PPU X1000 Y1000\nLIMIT0 SRC ENC0\nLIMIT0 MULT 2\nGEAR SRC Y LIMIT0\nGEAR PPU Y1000\nESAVE\nLIMIT0 MULT 5\nDWL 0.1\nELOAD\n\
                GEAR ON Y\nX1\nINH -516\nDWL 0.1\nPRINT P12550";
    assert_eq!(Sim::program(body).prints(), ["2000"]);
}
