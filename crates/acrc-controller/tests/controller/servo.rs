//! The servo loop and what it drives, as the world describes it (guide, "Servo Loop Fundamentals", "Servo Tuning - Tutorial").

use acrc_controller::Controller;

use crate::support::{Record, Sim, TWO_AXES};

/// A motor with an encoder of 4000 lines, of which the guide's tuning example says no more than what its load is.
fn motor(load: f64, more: &str) -> String {
    let inertia = 2e-5 * (1.0 + load);
    format!(
        "[axis.0]\nplant = {{ kind = \"motor\", inertia = {inertia}, torque_constant = 0.157, lines = 4000, {more} }}\n"
    )
}

const FRICTION: &str = "viscous_friction = 4e-4";

/// How the motor answered a step.
#[derive(Clone, Copy, Debug)]
struct Response {
    /// Time to nine tenths of the step, s.
    rise: f64,
    /// How far it went beyond, as a part of the step.
    overshoot: f64,
    /// When it was within a twentieth of the step for good, s.
    settled: f64,
}

/// The guide's tuning: a step of 100 pulses with two gains.
fn step(proportional: &str, derivative: &str, load: f64) -> Response {
    let gains = format!("AXIS0 PGAIN {proportional}\nAXIS0 DGAIN {derivative}\nENC0 MULT 4\n");
    let program = "PROGRAM\nDRIVE ON X\nP12288 = 100\nDWL 2\nENDP\n";
    let sim = Sim::new(&format!("{gains}{TWO_AXES}{program}")).start(&[0]).world(&motor(load, FRICTION));
    let mut controller = sim.controller();
    controller.start_after_setup(&[0]);
    let mut response = Response { rise: f64::INFINITY, overshoot: 0.0, settled: 0.0 };
    while controller.seconds() < 2.0 {
        controller.step(1, &mut Record::default());
        let (time, part) = (controller.seconds(), controller.view().position(0) / 100.0);
        if part >= 0.9 {
            response.rise = response.rise.min(time);
        }
        response.overshoot = response.overshoot.max(part - 1.0);
        if (part - 1.0).abs() > 0.05 {
            response.settled = time;
        }
    }
    response
}

#[test]
fn raising_pgain_is_faster_and_rings_and_dgain_damps() {
    let stages = [("0.0003", "0"), ("0.0005", "0"), ("0.0005", "0.00001"), ("0.001", "0.00001"), ("0.005", "0.00001")];
    let [first, second, third, fourth, fifth] = stages.map(|(p, d)| step(p, d, 0.0));
    assert!(second.rise < 0.9 * first.rise && second.overshoot > 0.5, "{first:?} {second:?}");
    assert!(third.overshoot == 0.0 && third.settled < second.settled / 2.0, "{third:?}");
    assert!(fourth.rise < third.rise && fourth.settled < third.settled && fourth.overshoot < 0.1, "{fourth:?}");
    assert!(fifth.rise < fourth.rise && fifth.overshoot > 3.0 * fourth.overshoot, "{fifth:?}");
    let sixth = step("0.005", "0.00003", 0.0);
    assert!(sixth.overshoot < fifth.overshoot / 3.0 && sixth.settled < fourth.settled.min(fifth.settled), "{sixth:?}");

    let seventh = step("0.005", "0.00003", 9.0);
    assert!(seventh.rise > 1.4 * sixth.rise && seventh.overshoot > 2.0 * sixth.overshoot, "{seventh:?}");
    let eighth = step("0.02", "0.00003", 9.0);
    assert!(eighth.rise < 0.7 * seventh.rise && eighth.overshoot > seventh.overshoot, "{eighth:?}");
    let ninth = step("0.02", "0.00015", 9.0);
    assert!(ninth.overshoot < eighth.overshoot / 3.0 && ninth.settled < eighth.settled / 3.0, "{ninth:?}");
}

/// A turn of the motor is a unit. Gains are those of the sixth stage.
const TUNED: &str =
    "ENC0 MULT 4\nAXIS0 PPU 16000\nAXIS0 PGAIN 0.005\nAXIS0 DGAIN 0.00003\nAXIS0 IPB 0.001\nAXIS0 EXC 1\n";

fn tuned(body: &str, world: &str) -> Sim {
    Sim::new(&format!("{TUNED}{TWO_AXES}PROGRAM\n{body}\nENDP\n")).start(&[0]).world(world)
}

#[test]
fn the_actual_position_follows_with_an_error() {
    let body = "DRIVE ON X\nX20\nDWL 1\nPRINT P12295, P12290, P12291; P6144 = P12290; BIT 769\nINH -768\nPRINT P12290";
    let ran = tuned(body, &motor(0.0, FRICTION)).run().clean();
    let lines: Vec<&str> = ran.record.output.iter().map(|line| line.text.as_str()).collect();
    assert_eq!(lines[0], "152000\t151968\t32-1-1");
    let end: f64 = lines[1].parse().expect("a number");
    assert!((end - 320_000.0).abs() <= 16.0, "within the band of IPB: {end}");
    assert!(ran.notes().is_empty(), "{:?}", ran.notes());
}

#[test]
fn an_axis_is_in_position_when_its_motor_is() {
    let time = |world: &str| tuned("DRIVE ON X\nX1\nINH -768\nPRINT P6916", world).prints()[0].parse::<f64>().unwrap();
    let (ideal, real) = (time(""), time(&motor(9.0, FRICTION)));
    assert!(real > ideal + 3.0, "{ideal} {real}");
}

#[test]
fn a_motor_whose_drive_is_off_has_no_torque() {
    let body = "X1\nINH -516\nPRINT P12295, P12290, P12291\nDRIVE OFF X\nDWL 0.5\nPRINT P12290";
    let ran = tuned(body, &motor(0.0, FRICTION)).run().clean();
    let lines: Vec<&str> = ran.record.output.iter().map(|line| line.text.as_str()).collect();
    assert_eq!(lines, ["16000\t0\t16000", "0"]);
}

#[test]
fn without_torque_limit_there_is_no_torque() {
    let run = |limit: &str| {
        tuned(&format!("TLM X{limit}\nDRIVE ON X\nX1\nDWL 1\nPRINT P12290 > 0"), &motor(0.0, FRICTION)).prints()
    };
    assert_eq!([run("0"), run("1")], [["0"], ["-1"]]);
}

#[test]
fn the_integral_takes_the_error_of_a_weight_away() {
    let world = motor(0.0, "viscous_friction = 4e-4, coulomb_friction = 0.001, load_torque = -0.05");
    let run = |gains: &str| {
        let ran = tuned(&format!("{gains}\nDRIVE ON X\nDWL 4\nPRINT P12291"), &world).run().clean();
        ran.record.output[0].text.parse::<f64>().expect("a number")
    };
    // 0.05 N m take 0.3185 V, which is an error of 63 or 64 pulses.
    let without = run("");
    assert!((60.0..70.0).contains(&without), "{without}");
    let with = run("IGAIN X0.05 ILIMIT X1");
    assert!(with.abs() <= 2.0, "{with}");
    assert!((60.0..70.0).contains(&run("IGAIN X0.05")), "an ILIMIT of 0 leaves nothing of it");
}

#[test]
fn an_encoder_that_counts_the_wrong_way_lets_the_motor_run_away() {
    let body = "ENC0 MULT -4\nSET 8469\nDRIVE ON X\nX1\nDWL 1\nPRINT BIT 8479; BIT 8465; BIT 8467";
    assert_eq!(tuned(body, &motor(0.0, FRICTION)).prints(), ["-1-1-1".replacen("-1-1", "-10", 1)]);
}

#[test]
fn the_output_is_at_the_analog_output() {
    let world = motor(0.0, "viscous_friction = 4e-4, load_torque = -0.157");
    let body = "DRIVE ON X\nDWL 3\nPRINT USING \"#.##\", P6400\nDRIVE OFF X\nDWL 0.01\nPRINT P6400";
    assert_eq!(tuned(body, &world).prints(), ["1.00", "0"], "1 V for 0.157 N m");
    let swapped = format!("ATTACH AXIS0 ENC0 DAC3 ENC0\nDAC3 GAIN -3276.8\n{body}").replace("P6400", "P6448");
    let reversed = "kind = \"motor\", amplifier_gain = -1,";
    let prints = tuned(&swapped, &world.replace("kind = \"motor\",", reversed)).prints();
    assert_eq!(prints, ["-1.00", "0"], "both turned round");
}

#[test]
fn registers_that_take_other_numbers_move_no_motor() {
    let after = |command: &str| {
        let body = format!(
            "X1\nINH -516\nPRINT P12290; \" \"; P12291\n{command}\nPRINT P12290; \" \"; P12291\nDRIVE ON X\nDWL 1\nPRINT P12290; \" \"; P12291"
        );
        tuned(&body, &motor(0.0, FRICTION)).prints()
    };
    // The drive was off, so the setpoint is a unit ahead.
    assert_eq!(after("REN X"), ["0 16000", "0 0", "0 0"]);
    assert_eq!(after("RES X5"), ["0 16000", "80000 0", "80000 0"]);
    assert_eq!(after("P12290 = 7"), ["0 16000", "7 0", "7 0"]);
    assert_eq!(after("JOG RES X2"), ["0 16000", "0 16000", "16000 0"]);
    assert_eq!(after("RES X5 : AXIS0 PPU 8000"), ["0 16000", "80000 0", "80000 0"]);
}

#[test]
fn a_run_lasts_until_its_motors_stand() {
    let world = motor(9.0, "coulomb_friction = 0.0005, viscous_friction = 4e-4");
    let ran = tuned("DRIVE ON X\nX1", &world).run().clean();
    assert!(ran.milliseconds() > 250.0, "the profile alone takes 200 ms: {}", ran.milliseconds());
    assert!((ran.position(0) - 1.0).abs() < 0.05, "{}", ran.position(0));
}

#[test]
fn a_stepper_makes_its_steps_and_loses_those_that_are_too_many() {
    let run = |plant: &str, body: &str| {
        let text = format!("AXIS0 PPU 1000\n{TWO_AXES}PROGRAM\nDRIVE ON X\n{body}\nENDP\n");
        Sim::new(&text).start(&[0]).world(&format!("[axis.0]\nplant = {plant}\n")).prints()
    };
    let body = "X10\nINH -516\nPRINT P12290; \" \"; P12291";
    assert_eq!(run("\"stepper\"", body), ["10000 0"]);
    let slow = "{ kind = \"stepper\", greatest_rate = 8000 }";
    let lost = run(slow, body);
    assert!(lost[0].ends_with(" 0") && !lost[0].starts_with("10000") || lost[0] != "10000 0", "{lost:?}");
    // RES and REN take no steps.
    let renamed =
        format!("{body}\nREN X\nPRINT P12291\nDWL 0.1\nPRINT P12291\nRES X\nVEL 5\nX/1\nINH -516\nPRINT P12291");
    assert_eq!(run(slow, &renamed)[1..], ["0", "0", "0"]);
}

#[test]
fn time_that_is_skipped_is_time_that_was_stepped() {
    let worlds = [
        motor(0.0, "viscous_friction = 4e-4, coulomb_friction = 0.0005"),
        motor(0.0, "viscous_friction = 4e-4, coulomb_friction = 0.01, load_torque = 0.02"),
        "[axis.0]\nplant = { kind = \"stepper\", greatest_rate = 150000 }\nbacklash = 0.1\nmarker = { every = 0.5 }\n"
            .to_owned(),
        "[axis.0]\nswitches = [{ input = 4, from = 0.2, to = 0.4 }]\n".to_owned(),
    ];
    let events =
        "[[event]]\nat = 3\njam = [0]\n[[event]]\nat = 5.5003\nfree = [0]\n[[event]]\nat = 7\nencoder_lost = [0]\n";
    let body = "IGAIN X0.1 ILIMIT X1 IDELAY X0.3 DWIDTH X0.001\nSET 8469\nDRIVE ON X\nX1\nINH -516\nDWL 1\nIDELAY X0 DWIDTH X0\nX/1\nDWL 1.5\n\
                PRINT P12290\nDRIVE OFF X\nDWL 1\nREN X\nDRIVE ON X\nPRINT P12290; \" \"; P12291\nX/1\nINH -516\nPRINT P12290\nDWL 3\nPRINT P12290; \" \"; BIT 8467; BIT 4";
    for world in worlds {
        let sim = tuned(body, &format!("{world}{events}"));
        let (watched, skipped) = (sim.run(), sim.watched(false).run());
        assert_eq!(watched.record.output, skipped.record.output, "{world}");
        assert_eq!(watched.milliseconds(), skipped.milliseconds(), "{world}");
        assert_eq!(watched.position(0).to_bits(), skipped.position(0).to_bits(), "{world}");
    }
}

#[test]
fn a_motor_at_rest_costs_no_time() {
    let world = motor(0.0, "viscous_friction = 4e-4, coulomb_friction = 0.0005");
    let ran = tuned("DRIVE ON X\nX1\nINH -516\nDWL 1\nDWL 100000", &world).until(1e5).watched(false).run().clean();
    assert!(ran.record.ticks < 20_000, "{} ticks", ran.record.ticks);
}

/// Sixteen motors in coordinated motion, with everything that a loop has.
#[test]
fn ticks_of_sixteen_motors_allocate_nothing() {
    let motors = (0..16).map(|axis| motor(0.0, FRICTION).replace("axis.0", &format!("axis.{axis}")));
    let world: String = motors.collect();
    let names: Vec<String> = (b'A'..=b'P').map(|letter| format!("X{}", char::from(letter))).collect();
    let slaves = (0..16).zip(&names).map(|(axis, name)| format!("ATTACH SLAVE{axis} AXIS{axis} \"{name}\"\n"));
    let slaves = slaves.collect::<Vec<_>>().concat();
    let settings =
        ["PPU 4000", "IGAIN 0.01", "ILIMIT 1", "FFVEL 0.00001", "NOTCH (200, 20)", "LOPASS 500", "KVP 0.001"];
    let settings = settings.iter().flat_map(|setting| (0..16).map(move |axis| format!("AXIS{axis} {setting}\n")));
    let settings: String = settings.collect();
    let moves = format!("{}/1", names.join("/1 "));
    let drives = names.join(" ");
    let text = format!(
        "{settings}PROG0\nATTACH MASTER0\n{slaves}ACC 10 DEC 10 STP 10 VEL 1\nPROGRAM\nDRIVE ON {drives}\n_A\n{moves}\nGOTO A\nENDP\n"
    );
    let mut controller: Controller = Sim::new(&text).start(&[0]).model("ACR8020").world(&world).controller();
    controller.start_after_setup(&[0]);
    let mut record = Record::default();
    controller.step(4000, &mut record);
    let counts = allocation_counter::measure(|| drop(Sim::new(&text)));
    assert!(counts.count_total > 0, "allocations are counted");
    let measured = allocation_counter::measure(|| controller.step(1000, &mut record));
    assert_eq!(measured.count_total, 0);
}
