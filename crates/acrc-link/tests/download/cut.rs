//! Downloads that are cut off, and run again.

use acrc_link::download::{Fate, Script, Settings};

use crate::bench::{Ended, Notes, bring, download, look, project, script};
use crate::support::Machine;

/// Setup of several kinds, two programs, one with numbered lines.
const MACHINE: &str = "SYS\nCLEAR\nDIM PROG0(900)\nDIM PROG1(600)\nDIM P(4) : DIM DEF(3)\n#DEFINE Lamp BIT32\n#DEFINE Count P0\n\
                       AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nDIM LV(2)\nACC 100 DEC 100 STP 100 VEL 5\n\
                       PROGRAM\nREM to and fro\n_Again\nSET Lamp\nX1 : X0\nCount = Count + 1\nIF (Count < 3)\nGOTO Again\nENDIF\nENDP\n\
                       PROG1\nNEW\n20 DWL 2\n10 DWL 1\nSYS\n";

/// An older version of it: other memory, another meaning of a name, another text, and a program more.
const BEFORE: &str = "SYS\nCLEAR\nDIM PROG0(700)\nDIM PROG1(600)\nDIM PROG2(300)\nDIM P(9) : DIM DEF(3)\n#DEFINE Lamp BIT33\n\
                      PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS1 \"X\"\nPROGRAM\nSET Lamp\nENDP\nPROG1\nPROGRAM\nDWL 9\nENDP\n\
                      PROG2\nPROGRAM\nDWL 8\nENDP\n";

/// What a download to a fresh controller leaves, but for what nobody sees.
fn clean(script: &Script) -> String {
    let machine = Machine::new();
    bring(&machine, script);
    seen(&machine)
}

fn seen(machine: &Machine) -> String {
    let mut survey = look(machine);
    survey.alias_lines.clear();
    format!("{survey:#?}")
}

/// The bytes that a whole download to a machine sends.
fn bytes(machine: &Machine, script: &Script) -> usize {
    let line = machine.line();
    let sent = line.counted();
    download(line, script, &Settings::default(), &mut Notes::default()).well();
    sent.get()
}

/// Cuts the download off behind every `stride`-th byte and runs it again.
fn cut_everywhere(prepare: &dyn Fn() -> Machine, script: &Script, stride: usize) {
    let expected = clean(script);
    let total = bytes(&prepare(), script);
    for lives in (0..total).step_by(stride) {
        let machine = prepare();
        let cut = download(machine.line().breaking_after(lives), script, &Settings::default(), &mut Notes::default());
        assert!(matches!(cut, Ended::Failed(_) | Ended::Early(_)), "{lives} of {total}: {cut:#?}");
        let (state, _) = bring(&machine, script);
        assert!(script.units().all(|unit| state.programs[&unit.name] == Fate::Verified), "{lives}: {state}");
        assert_eq!(seen(&machine), expected, "cut off behind {lives} of {total} bytes");
    }
}

#[test]
fn cut_off_anywhere_on_a_fresh_controller() {
    cut_everywhere(&Machine::new, &script(&project(MACHINE)), 11);
}

#[test]
fn cut_off_anywhere_over_an_older_version() {
    let before = script(&project(BEFORE));
    let prepare = || {
        let machine = Machine::new();
        bring(&machine, &before);
        machine
    };
    cut_everywhere(&prepare, &script(&project(MACHINE)), 17);
}

#[test]
fn cut_off_again_and_again() {
    let script = script(&project(MACHINE));
    let (expected, total) = (clean(&script), bytes(&Machine::new(), &script));
    let machine = Machine::new();
    for lives in (total / 2..total).step_by(total / 40) {
        download(machine.line().breaking_after(lives), &script, &Settings::default(), &mut Notes::default());
    }
    bring(&machine, &script);
    assert_eq!(seen(&machine), expected);
}

#[test]
fn a_partial_project_cut_off_anywhere() {
    let before = script(&project(BEFORE));
    let part = script(&project("#DEFINE Lamp BIT34\nPROG0\nPROGRAM\nSET Lamp\nENDP\nPROG1\nPROGRAM\nDWL 3\nENDP\n"));
    let prepare = || {
        let machine = Machine::new();
        bring(&machine, &before);
        machine
    };
    let whole = prepare();
    bring(&whole, &part);
    let (expected, total) = (seen(&whole), bytes(&prepare(), &part));
    for lives in (0..total).step_by(13) {
        let machine = prepare();
        download(machine.line().breaking_after(lives), &part, &Settings::default(), &mut Notes::default());
        let (_, _) = bring(&machine, &part);
        assert_eq!(seen(&machine), expected, "cut off behind {lives} of {total} bytes");
        machine.connect_and_type("RUN PROG0");
        machine.pass(0.1);
        assert!(machine.look(|controller| controller.bit(34).expect("a flag")), "{lives}: an old name is in use");
    }
}

#[test]
fn whoever_gives_up_leaves_no_program_half_entered() {
    let script = script(&project(MACHINE));
    let expected = clean(&script);
    let mut notes = Notes::default();
    let lines = download(Machine::new().line(), &script, &Settings::default(), &mut notes).well().lines;
    for number in 1..=lines {
        let machine = Machine::new();
        let mut notes = Notes { give_up_at: Some(number), ..Notes::default() };
        let failure = download(machine.line(), &script, &Settings::default(), &mut notes).failure();
        assert!(failure.state.open.is_none(), "{number}: {failure:#?}");
        assert_eq!(failure.state.with(Fate::Partial).count(), 0, "{number}: {}", failure.state);
        let survey = look(&machine);
        for (unit, listing) in &survey.programs {
            let names = acrc_link::download::Names::new(&script.image.aliases, &[]);
            let whole = script.unit(*unit).expect("one of the project");
            assert!(listing.compare(whole, &names).is_ok(), "{number}: {unit} is there in part");
        }
        bring(&machine, &script);
        assert_eq!(seen(&machine), expected, "given up before line {number}");
    }
}
