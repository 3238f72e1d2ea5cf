//! Switches, marks and play along the way of an axis (guide, "Homing", "End-of-Travel Limits", "Setpoint Compensation").

use crate::support::Sim;

#[test]
fn switches_follow_the_axis() {
    let world = "[inputs]\nhome = 2\n[axis.0]\nswitches = [\n{ input = \"home\", from = 2, to = 4 },\n{ input = 0, above = 8 },\n\
                 { input = 1, below = -1, normally = \"closed\" },\n]\n";
    let body = "PRINT BIT 0; BIT 1; BIT 2\nX3\nINH -516\nPRINT BIT 0; BIT 1; BIT 2\nX8\nINH -516\nPRINT BIT 0; BIT 1; BIT 2\n\
                JOG VEL X10\nJOG REV X\nINH -1\nPRINT P12290 <= -1; P12290 > -1.1\nJOG OFF X";
    assert_eq!(Sim::program(body).world(world).prints(), ["0-10", "0-1-1", "-1-10", "-1-1"]);
}

#[test]
fn switches_stay_where_they_are_when_the_registers_change() {
    let world = "[axis.0]\nstart = 5\nswitches = [{ input = 3, from = 10, to = 11 }]\n";
    let body = "AXIS0 PPU 1000\nX3\nINH -516\nRES X100\nX101.9\nINH -516\nPRINT BIT 3\nX102\nINH -516\nPRINT BIT 3\nX104\nINH -516\nPRINT BIT 3";
    assert_eq!(Sim::program(body).world(world).prints(), ["0", "-1", "0"]);
}

#[test]
fn an_axis_finds_its_home_and_its_limits() {
    let world = "[axis.0]\nstart = 30\nswitches = [{ input = 0, above = 100 }, { input = 1, below = -1 }, { input = 2, from = 0, to = 5 }]\n";
    let home = "HLBIT X0 : HLIM X3 : HLDEC X1000 : JOG VEL X10 : JOG ACC X100 : JOG DEC X100 : JOG HOMVF X1\nSET 16152 : CLR 16153 : SET 16154\n";
    let body = format!("{home}JOG HOME X-1\nINH 16134\nPRINT P12290\nX-10\nDWL 2\nPRINT BIT 8467; BIT 16133");
    let ran = Sim::program(&body).world(world).run();
    let lines: Vec<&str> = ran.record.output.iter().map(|line| line.text.as_str()).collect();
    assert_eq!(lines, ["0", "-1-1"]);
    // The edge of the home switch is 5, that of the limit -1: six units apart.
    let place = ran.position(0);
    assert!((-6.2..=-6.0).contains(&place), "{place}");
}

#[test]
fn a_switch_sees_the_load_behind_the_play() {
    let world = "[axis.0]\nbacklash = 0.5\nswitches = [{ input = 3, from = 2, to = 3 }]\n";
    let body = "AXIS0 PPU 1000\nX2.4\nINH -516\nPRINT BIT 3\nX2.5\nINH -516\nPRINT BIT 3\nX2\nINH -516\nPRINT BIT 3\nX1.9\nINH -516\nPRINT BIT 3\n\
                BKL X0.5\nX2\nINH -516\nPRINT BIT 3";
    assert_eq!(Sim::program(body).world(world).prints(), ["0", "-1", "-1", "0", "-1"]);
}

#[test]
fn events_and_switches_may_share_an_input() {
    let world = "[axis.0]\nswitches = [{ input = 3, above = 5 }]\n[[event]]\nat = 0.1\nset = [3]\n";
    let body = "X1\nINH -516\nPRINT BIT 3\nX6\nINH -516\nX1\nINH -516\nPRINT BIT 3";
    assert_eq!(Sim::program(body).world(world).prints(), ["-1", "0"]);
}

#[test]
fn backlash_compensation_has_two_readings() {
    let body = "AXIS0 PPU 1000\nBKL X0.5\nX-3\nINH -516\nX-2\nINH -516\nPRINT P12295 - P12294\nX-3\nINH -516\nPRINT P12295 - P12294\nX1\nINH -516\nX0.5\nINH -516\nPRINT P12295 - P12294";
    let sim = Sim::program(body);
    assert_eq!(sim.prints(), ["0", "0", "500"]);
    assert_eq!(sim.travel_backlash().prints(), ["500", "0", "0"]);
}

#[test]
fn axes_that_the_model_lacks_are_noted() {
    let ran = Sim::new("PRINT 1\n")
        .model("ACR9000")
        .world("[axis.9]\nstart = 1\n[[event]]\nat = 0\njam = [12]\n")
        .run()
        .clean();
    assert_eq!(
        ran.notes(),
        [
            "the world describes axis 12: the ACR9000 has axis 0 to 7",
            "the world describes axis 9: the ACR9000 has axis 0 to 7"
        ]
    );
}

#[test]
fn a_machine_stays_where_it_is_over_a_restart() {
    let world = "[axis.0]\nswitches = [{ input = 3, from = 4, to = 5 }]\n";
    let text = "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nACC 100 DEC 100 STP 100 VEL 10\nPROGRAM\nIF (P38912 = 0)\nP38912 = 1\nX4\nINH -516\nREBOOT\nENDIF\nENDP\n";
    let ran = Sim::new(text).start(&[0]).world(world).until(3.0).run();
    assert!(ran.bit(3), "the switch is still closed");
    assert_eq!(ran.position(0), 0.0);
}

#[test]
fn the_examples_of_the_page_are_worlds() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/world.md");
    let page = std::fs::read_to_string(path).expect("docs/world.md");
    let examples: Vec<&str> = page.split("```toml\n").skip(1).filter_map(|rest| rest.split("```").next()).collect();
    assert_eq!(examples.len(), 5);
    for example in examples {
        let world = acrc_controller::world::World::parse(example);
        assert!(world.is_ok(), "{example}\n{world:?}");
    }
}

#[test]
fn the_flags_of_limits_follow_coordinated_moves() {
    let world = "[axis.0]\nswitches = [{ input = 2, from = 2, to = 4 }]\n";
    let body = "X3\nINH -516\nPRINT BIT 2; BIT 16130\nX5\nINH -516\nPRINT BIT 2; BIT 16130";
    assert_eq!(Sim::program(body).world(world).prints(), ["-1-1", "00"]);
}

#[test]
fn a_limit_may_be_wired_to_an_input_of_a_network() {
    let world = "[axis.0]\nswitches = [{ input = 11520, from = 2, to = 4 }]\n";
    let body = "HLBIT X(24, 25, 11520)\nX3\nINH -516\nPRINT BIT 16130\nX5\nINH -516\nPRINT BIT 16130";
    assert_eq!(Sim::program(body).world(world).prints(), ["-1", "0"]);
}

/// A motor whose program restarts the controller after a while.
fn restarting(boot: &str, body: &str) -> Sim {
    let setup = "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPPU X1000\nJOG ACC X100 : JOG DEC X100 : JOG VEL X10\nSYS\nESAVE\nPROG0";
    let text = format!("{setup}\nPROGRAM\nPBOOT\n{boot}\nIF (P38912 = 0)\nP38912 = 1\n{body}\nREBOOT\nENDIF\nENDP\n");
    let motor = "[axis.0]\nplant = { kind = \"motor\", inertia = 2e-5, torque_constant = 0.157, lines = 4000 }\n";
    let faults = "[[event]]\nat = 0.2\nencoder_lost = [0]\nmotion_enable = false\n";
    Sim::new(&text).start(&[0]).world(&format!("{motor}{faults}")).until(1.0)
}

#[test]
fn a_controller_restarts_while_its_motor_turns() {
    let body = "PGAIN X0.01 : DGAIN X0.0001\nDRIVE ON X\nJOG FWD X\nDWL 0.15\nPRINT P12290 > 500";
    let ran = restarting("PRINT P12290; P12294\nDWL 0.01\nPRINT BIT 769", body).run().clean();
    assert_eq!(
        ran.record.output.iter().map(|line| line.text.as_str()).collect::<Vec<_>>(),
        ["00", "-1", "-1", "00", "0"]
    );
}

#[test]
fn faults_that_last_are_seen_after_a_restart() {
    let prints = restarting("PRINT BIT 2561; BIT 5646; BIT 5645", "DWL 0.3").prints();
    assert_eq!(prints, ["000", "-1-1-1"]);
}
