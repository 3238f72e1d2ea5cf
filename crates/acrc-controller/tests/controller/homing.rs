//! Homing (guide, "Homing", Figures A to J).

use std::sync::Arc;

use acrc_controller::world::{World, WorldEvent};
use acrc_controller::{Controller, FaultReport, Observer, Options, Sent, View};

use crate::support::{JOGS, Sim, TWO_AXES};

const FOUND: u32 = 16_134;
const FAILED: u32 = 16_135;

/// Where the switches of X are.
#[derive(Clone, Copy)]
struct Machine {
    positive: f64,
    negative: f64,
    home: (f64, f64),
}

/// Home is two units long and 4 units away in both directions; the limits are far.
const AHEAD: Machine = Machine { positive: 50.0, negative: -50.0, home: (4.0, 6.0) };
const BEHIND: Machine = Machine { home: (-6.0, -4.0), ..AHEAD };

impl Machine {
    fn inputs(self, place: f64) -> [bool; 3] {
        [place >= self.positive, place <= self.negative, (self.home.0..=self.home.1).contains(&place)]
    }
}

/// Follows X until it is home.
struct Trip {
    machine: Machine,
    /// Where it was last, from the start.
    end: f64,
    /// Its stretches in one direction, with the greatest speed of each.
    legs: Vec<(char, f64)>,
    found: bool,
    failed: bool,
    seconds: f64,
    faults: Vec<String>,
    /// The first input that was not what it has to be: when, which, what.
    missing: Option<(f64, usize, bool)>,
}

impl Observer for Trip {
    fn output(&mut self, _: &Sent) {}

    fn fault(&mut self, fault: &FaultReport) {
        self.faults.push(fault.message.clone());
    }

    fn event(&mut self, _: f64, _: &WorldEvent, _: &View) {}

    fn tick(&mut self, view: &View) {
        (self.found, self.failed) = (view.bit(FOUND), view.bit(FAILED));
        if self.found || self.failed || self.missing.is_some() {
            return;
        }
        self.seconds = view.seconds();
        let (velocity, _) = view.motion(0);
        if velocity != 0.0 {
            let sign = if velocity > 0.0 { '+' } else { '-' };
            let speed = (velocity.abs() * 1e6).round() / 1e6;
            match self.legs.last_mut() {
                Some((last, fastest)) if *last == sign => *fastest = speed.max(*fastest),
                _ => self.legs.push((sign, speed)),
            }
        }
        self.end = view.position(0);
        let wanted = self.machine.inputs(self.end).into_iter().enumerate();
        let missing = wanted.map(|(input, state)| (view.seconds(), input, state));
        self.missing = missing.into_iter().find(|(_, input, state)| view.bit(*input as u32) != *state);
    }

    fn watches_every_tick(&self) -> bool {
        true
    }

    fn interrupted(&mut self) -> bool {
        self.missing.is_some()
    }
}

impl Trip {
    #[track_caller]
    fn ends_at(&self, place: f64, tolerance: f64) {
        assert!((self.end - place).abs() <= tolerance, "{}, not {place}", self.end);
    }

    fn directions(&self) -> String {
        self.legs.iter().map(|(sign, _)| *sign).collect()
    }
}

/// Runs a program on a machine. The inputs come from outside: the run is made again and again, each time with the change that was missing.
fn trip(setup: &str, body: &str, machine: Machine) -> (Controller, Trip) {
    let sim = Sim::jogging(&format!("JOG HOMVF X0.5\nHLDEC X400\n{setup}"), body);
    let image = Arc::new(sim.image());
    let mut events: Vec<String> = Vec::new();
    loop {
        let world = World::parse(&events.concat()).expect("the world of a test is valid");
        let options = Options { world, ..Options::default() };
        let mut controller = Controller::new(Arc::clone(&image), options).expect("compiled programs load");
        let mut trip = Trip {
            machine,
            end: 0.0,
            legs: Vec::new(),
            found: false,
            failed: false,
            seconds: 0.0,
            faults: Vec::new(),
            missing: None,
        };
        controller.run(&[0], 60.0, &mut trip);
        let Some((at, input, state)) = trip.missing else { return (controller, trip) };
        let key = if state { "set" } else { "clear" };
        events.push(format!("[[event]]\nat = {at:?}\n{key} = [{input}]\n"));
    }
}

/// Setup code that sets the homing bits.
fn bits(bits: &[u32]) -> String {
    bits.iter().map(|bit| format!("SET {bit}")).collect::<Vec<_>>().join("\n")
}

const BACKUP: u32 = 16_152;
const NEGATIVE_EDGE: u32 = 16_153;
const NEGATIVE_FINAL: u32 = 16_154;

/// A tick at JOG VEL, and one at JOG HOMVF.
const FAST: f64 = 10.0 * 0.0005 + 1e-9;
const SLOW: f64 = 0.5 * 0.0005 + 1e-9;

#[test]
fn without_backup_any_edge_ends_the_search() {
    for (body, machine, end) in [("JOG HOME X1", AHEAD, 4.5), ("JOG HOME X-1", BEHIND, -4.5)] {
        // The other two bits mean nothing.
        for flags in [&[][..], &[NEGATIVE_EDGE], &[NEGATIVE_FINAL], &[NEGATIVE_EDGE, NEGATIVE_FINAL]] {
            let (controller, trip) = trip(&bits(flags), body, machine);
            assert!(trip.found && !trip.failed);
            assert_eq!(trip.legs.len(), 1);
            trip.ends_at(end, FAST);
            assert_eq!(controller.view().position(0), 0.0);
        }
    }
    // From inside of the region, the edge on its far side.
    let (_, inside) = trip("", "JOG HOME X1", Machine { home: (-1.0, 3.0), ..AHEAD });
    inside.ends_at(3.5, FAST);
}

#[test]
fn with_backup_the_selected_edge_is_approached_in_the_selected_direction() {
    // Figures C to J.
    for (direction, flags, end, directions) in [
        (1, &[BACKUP][..], 6.0, "+-+"),
        (1, &[BACKUP, NEGATIVE_EDGE], 4.0, "+-+"),
        (1, &[BACKUP, NEGATIVE_FINAL], 6.0, "+-"),
        (1, &[BACKUP, NEGATIVE_EDGE, NEGATIVE_FINAL], 4.0, "+-"),
        (-1, &[BACKUP, NEGATIVE_EDGE, NEGATIVE_FINAL], -6.0, "-+-"),
        (-1, &[BACKUP, NEGATIVE_FINAL], -4.0, "-+-"),
        (-1, &[BACKUP, NEGATIVE_EDGE], -6.0, "-+"),
        (-1, &[BACKUP], -4.0, "-+"),
    ] {
        let machine = if direction > 0 { AHEAD } else { BEHIND };
        let (controller, trip) = trip(&bits(flags), &format!("JOG HOME X{direction}"), machine);
        assert!(trip.found && !trip.failed, "{direction} {flags:?}");
        assert_eq!(trip.directions(), directions, "{direction} {flags:?}");
        let speeds: Vec<f64> = trip.legs.iter().map(|(_, speed)| *speed).collect();
        assert!(speeds[0] == 10.0 && speeds[1..].iter().all(|speed| *speed == 0.5), "{speeds:?}");
        trip.ends_at(end, SLOW);
        assert_eq!(controller.view().position(0), 0.0);
    }
}

#[test]
fn a_search_that_begins_on_the_switch_begins_towards_the_selected_edge() {
    let machine = Machine { home: (-1.0, 1.0), ..AHEAD };
    for (direction, flags, end, directions) in [
        (1, &[BACKUP][..], 1.0, "+-+"),
        (-1, &[BACKUP], 1.0, "+-+"),
        (1, &[BACKUP, NEGATIVE_EDGE], -1.0, "-+"),
        (-1, &[BACKUP, NEGATIVE_EDGE, NEGATIVE_FINAL], -1.0, "-+-"),
    ] {
        // The input is there from the start.
        let body = format!("DWL 0.01\nJOG HOME X{direction}");
        let (_, trip) = trip(&bits(flags), &body, machine);
        assert_eq!(trip.directions(), directions, "{direction} {flags:?}");
        trip.ends_at(end, SLOW);
    }
}

#[test]
fn homing_uses_the_jog_profile() {
    let (_, trip) = trip("JOG VEL X20\nJOG DEC X50\nJOG ACC X400", "JOG HOME X1", AHEAD);
    assert_eq!(trip.legs, [('+', 20.0)]);
    trip.ends_at(4.0 + 4.0, 2.0 * FAST);
    // 0.05 s and 0.5 units up, 3.5 units, 0.4 s down.
    assert!((trip.seconds - (0.05 + 3.5 / 20.0 + 0.4)).abs() < 0.0021, "{}", trip.seconds);
}

#[test]
fn the_home_input_can_be_inverted() {
    let machine = Machine { home: (f64::NEG_INFINITY, 4.0), ..AHEAD };
    let (_, trip) = trip("SET 16146", "DWL 0.01\nJOG HOME X1", machine);
    assert!(trip.found);
    trip.ends_at(4.5, FAST);
}

#[test]
fn success_zeroes_every_register() {
    let (controller, trip) = trip("", "X3\nINH -516\nJOG HOME X1", AHEAD);
    assert!(trip.found);
    for register in [12_288, 12_289, 12_290, 12_294, 12_295, 12_297] {
        assert_eq!(controller.parameter(register), Ok(acrc_vm::Value::Long(0)), "P{register}");
    }
    assert_eq!(controller.bit(792), Ok(false));
}

#[test]
fn home_is_found_while_the_master_moves_other_axes() {
    let (controller, trip) = trip("", "X3\nINH -516\nJOG HOME X1\nY20", AHEAD);
    assert!(trip.found);
    assert_eq!(controller.parameter(12_294), Ok(acrc_vm::Value::Long(0)));
    assert_eq!(controller.view().position(1), 20.0);
}

#[test]
fn a_limit_reverses_the_search() {
    for flags in [&[][..], &[BACKUP]] {
        let machine = Machine { positive: 3.0, ..BEHIND };
        let (controller, trip) = trip(&format!("HLIM X3\n{}", bits(flags)), "JOG HOME X1", machine);
        assert!(trip.found && !trip.failed);
        assert_eq!(trip.legs[..2], [('+', 10.0), ('-', 10.0)]);
        assert_eq!((controller.bit(8467), controller.bit(522)), (Ok(false), Ok(false)));
        assert_eq!(controller.bit(16_132), Ok(false), "it is no limit that has stopped the axis");
    }
}

#[test]
fn a_second_limit_ends_the_search() {
    let machine = Machine { positive: 3.0, negative: -3.0, home: (20.0, 21.0) };
    let (controller, trip) = trip("HLIM X3", "JOG HOME X1", machine);
    assert!(trip.failed && !trip.found);
    assert_eq!(trip.directions(), "+-");
    // 10 units/s with HLDEC 400.
    trip.ends_at(-3.0 - 0.125, FAST);
    assert!((controller.view().position(0) + 3.125).abs() < FAST, "it stays there");
}

#[test]
fn a_limit_that_is_not_enabled_does_not_reverse() {
    let machine = Machine { positive: 3.0, ..AHEAD };
    let (_, trip) = trip("", "JOG HOME X1", machine);
    assert_eq!((trip.found, trip.directions()), (true, "+".to_owned()));
}

#[test]
fn homing_is_refused_in_motion() {
    for motion in ["X10", "Y10", "JOG FWD X", "JOG HOME X1"] {
        let faults = Sim::jogging("", &format!("{motion}\nDWL 0.1\nJOG HOME X1")).until(1.0).faults();
        assert_eq!(faults, ["Not valid while in motion"], "{motion}");
    }
    let other_axis = Sim::jogging("", "JOG FWD Y\nDWL 0.1\nJOG HOME X1").until(1.0).run().clean();
    assert_eq!(other_axis.velocity(0), 10.0);
}

#[test]
fn several_axes_home_at_once() {
    let world = "[[event]]\nat = 1\nset = [2]\n[[event]]\nat = 2\nset = [5]\n";
    let sim = Sim::jogging("", "JOG HOME X1 Y-1\nINH 16134\nPRINT BIT 16166, P12550\nINH 16166\nPRINT P12294, P12550");
    // X has 0.1 s of ramp; Y is then at -10.5.
    assert_eq!(sim.world(world).timed(), ["1100 0\t-10500", "2100 0\t0"]);
}

#[test]
fn a_new_homing_clears_the_flags_of_the_last() {
    let body = "JOG HOME X1\nINH 16134\nJOG HOME X1\nPRINT BIT 16134; BIT 16135; BIT 792";
    let ran = Sim::jogging("", body).world("[[event]]\nat = 1\nset = [2]\n").until(3.0).run().clean();
    assert_eq!(ran.record.output[0].text, "00-1");
}

#[test]
fn flags_start_homing() {
    let (_, forward) = trip("", "SET 17160\nPRINT BIT 17160", AHEAD);
    assert!(forward.found && forward.directions() == "+");
    let (_, backward) = trip("", "SET 17161\nSET 17160", BEHIND);
    assert!(backward.found && backward.directions() == "-");
}

#[test]
fn a_kill_ends_homing_without_home() {
    let (controller, trip) = trip("", "JOG HOME X1\nDWL 0.3\nSET 8467", AHEAD);
    assert!(trip.failed && !trip.found);
    // 2.5 units, and 0.125 of ramp.
    assert!((controller.view().position(0) - 2.625).abs() < 1e-6);
    assert_eq!(controller.bit(792), Ok(false));
}

#[test]
fn another_jog_ends_homing_without_home() {
    for (statement, end) in [("JOG OFF X", 3.0), ("JOG ABS X1", 1.0), ("JOG INC X-2.5", 0.0)] {
        let (controller, trip) = trip("", &format!("JOG HOME X1\nDWL 0.3\n{statement}"), AHEAD);
        assert!(trip.failed && !trip.found, "{statement}");
        assert!((controller.view().position(0) - end).abs() < 1e-9, "{statement}");
    }
}

#[test]
fn a_search_without_a_switch_goes_on() {
    let ran = Sim::jogging("", "JOG HOME X1").until(5.0).run().clean();
    assert_eq!((ran.position(0), ran.bit(16_134), ran.bit(16_135)), (49.5, false, false));
}

#[test]
fn homing_outlasts_its_program_and_ends_the_run() {
    let text = format!("{TWO_AXES}{JOGS}PROGRAM\nJOG HOME X1\nENDP\n");
    let ran = Sim::new(&text).start(&[0]).world("[[event]]\nat = 2\nset = [2]\n").run().clean();
    assert_eq!((ran.milliseconds(), ran.bit(16_134)), (2100.0, true));
}

#[test]
fn software_limits_do_not_stop_homing() {
    let (_, trip) = trip("SLM X2\nSLIM X3", "JOG HOME X1", AHEAD);
    assert!(trip.found);
    trip.ends_at(4.5, FAST);
}
