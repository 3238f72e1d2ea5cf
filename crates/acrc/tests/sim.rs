//! `acrc sim`: whole programs in virtual time.

mod common;

use common::{Bench, Csv, gantry};
use serde_json::json;

/// A single-file project with one axis of 4000 pulses a revolution.
fn one_axis(body: &str) -> String {
    format!(
        "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nMULT X4\nPPU X4000\nACC 10 DEC 10 STP 10 VEL 20\n\
         PROGRAM\n{body}\nENDP\n"
    )
}

#[test]
fn two_hundred_revolutions_take_twelve_seconds() {
    let bench = Bench::new();
    bench.file("move.8K", one_axis("MOV X200"));
    let report = bench.sim("move.8K --run PROG0 --until 100s --trace t.csv --rate 0.5ms --read P12288,P12290,BIT516");
    assert_eq!(report["stopped"], "ended");
    assert_eq!(report["moves"][0]["motion_seconds"], 12.0);
    assert_eq!(report["axes"][0]["position"], 200.0);
    assert_eq!(report["axes"][0]["peak_velocity"], 20.0);
    assert_eq!(report["axes"][0]["peak_acceleration"], 10.0);
    assert_eq!(report["values"], json!({ "P12288": 800_000, "P12290": 800_000, "BIT516": 0 }));

    let trace = Csv::read(&bench.path("t.csv"));
    let (time, position) = (trace.column("time_s"), trace.column("X.position"));
    let start = position.iter().position(|value| *value > 0.0).expect("it moves") - 1;
    let end = position.iter().position(|value| *value == 200.0).expect("it arrives");
    assert!((time[end] - time[start] - 12.0).abs() < 0.0005 + 1e-9, "{}", time[end] - time[start]);
}

#[test]
fn axes_of_one_statement_start_and_stop_together() {
    let bench = Bench::new();
    let setup =
        "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \"Y\"\nACC 750 DEC 750 VEL 75 STP 750\n";
    bench.file("two.8K", format!("{setup}PROGRAM\nX25 Y15\nENDP\n"));
    let report = bench.sim("two.8K --run PROG0 --trace t.csv --rate 0.5ms");
    let trace = Csv::read(&bench.path("t.csv"));
    let (x, y) = (trace.column("X.position"), trace.column("Y.position"));
    let moving = |values: &[f64], end: f64| {
        let first = values.iter().position(|value| *value > 0.0);
        (first, values.iter().position(|value| *value == end))
    };
    assert_eq!(moving(&x, 25.0), moving(&y, 15.0));
    // sqrt(25^2 + 15^2) / 75 + 75 / 750
    let seconds = report["moves"][0]["motion_seconds"].as_f64().expect("a number");
    assert!((seconds - 0.488_730).abs() <= 0.0005, "{seconds}");
    let peak = report["axes"][0]["peak_velocity"].as_f64().expect("a number");
    assert!((peak - 64.311).abs() < 0.001, "{peak}");
}

#[test]
fn the_peak_of_a_short_move_lies_between_two_ticks() {
    let bench = Bench::new();
    bench.file("short.8K", one_axis("X1"));
    let report = bench.sim("short.8K --run PROG0");
    // Half of 1 unit up with 10 units/s^2: sqrt(2 * 0.5 * 10)
    let peak = report["axes"][0]["peak_velocity"].as_f64().expect("a number");
    assert!((peak - 10_f64.sqrt()).abs() < 1e-9, "{peak}");
}

#[test]
fn angles_are_what_the_project_or_the_command_line_says() {
    let bench = Bench::new();
    bench.file("turn/Prog0.8K", "SYS\nDIM P(1)\nPROG0\nPROGRAM\nP0 = SIN(90)\nENDP\n");
    bench.file("turn/acrc.toml", "[sim]\nangles = \"degrees\"\n");
    let value = |flags: &str| bench.sim(&format!("turn --run PROG0 --read P0 {flags}"))["values"]["P0"].clone();
    assert_eq!(value(""), json!(1));
    assert!((value("--angles radians").as_f64().expect("a number") - 90_f64.sin()).abs() < 1e-12);
    assert_eq!(value("--angles degrees"), json!(1));
}

#[test]
fn what_is_unconfirmed_is_said_once() {
    let bench = Bench::new();
    bench.file("angle.8K", one_axis("CLEAR\nDIM DV(1)\nDV0 = SIN(1) + SIN(2)"));
    let notes = bench.sim("angle.8K --run PROG0")["notes"].to_string();
    assert_eq!(notes.matches("radians").count(), 1, "{notes}");
}

#[test]
fn the_last_row_of_a_trace_is_the_state_at_the_end() {
    let bench = Bench::new();
    bench.file("end.8K", one_axis("X1\nSET 34\nINH -516\nCLR 34"));
    let report = bench.sim("end.8K --run PROG0 --trace t.csv --rate 30ms --read BIT34");
    let trace = Csv::read(&bench.path("t.csv"));
    let (time, position, output) = (trace.column("time_s"), trace.column("X.position"), trace.column("BIT34"));
    assert_eq!((output.first(), output.last(), &report["values"]["BIT34"]), (Some(&1.0), Some(&0.0), &json!(0)));
    assert_eq!((time.last().copied(), position.last().copied()), (report["virtual_seconds"].as_f64(), Some(1.0)));
}

#[test]
fn an_axis_that_the_model_does_not_have_is_a_fault_and_no_more() {
    let bench = Bench::new();
    bench.file("far.8K", "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS12 \"X\"\nPROGRAM\nPRINT \"on\"\nENDP\n");
    let run = bench.acrc(["sim", "far.8K", "--run", "PROG0", "--trace", "t.csv", "--plot", "p.svg"]).expect(1);
    assert!(run.stdout.contains("AXIS12 does not exist"), "{}", run.stdout);
    let report = bench.sim("far.8K --run PROG0");
    assert_eq!(report["stopped"], "ended", "the program itself went well");
}

#[test]
fn moves_without_stop_ramp_merge() {
    let bench = Bench::new();
    bench.file("blend.8K", one_axis("STP 0\nX20\nX60\nSTP 10\nX80"));
    let report = bench.sim("blend.8K --run PROG0 --trace t.csv --rate 0.5ms");
    // 2 s up to 20 over 20 units, 40 units at 20, 2 s down over 20 units.
    assert_eq!(report["moves"][0]["motion_seconds"], 6.0);
    assert_eq!(report["moves"][0]["moves"], 3);
    let trace = Csv::read(&bench.path("t.csv"));
    let velocity = trace.column("X.velocity");
    let steps = velocity.windows(2).map(|pair| (pair[1] - pair[0]).abs());
    assert!(steps.fold(0.0, f64::max) <= 10.0 * 0.0005 + 1e-9, "velocity is continuous");
    assert!(
        report["notes"].as_array().is_some_and(|notes| notes.iter().all(|note| !note.to_string().contains("STP 0")))
    );
}

#[test]
fn a_move_that_nothing_follows_without_stop_ramp_is_noted() {
    let bench = Bench::new();
    bench.file("drop.8K", one_axis("STP 0\nX20"));
    let report = bench.sim("drop.8K --run PROG0");
    assert!(report["notes"].to_string().contains("velocity dropped to zero at once"), "{}", report["notes"]);
}

#[test]
fn jerk_limits_the_change_of_acceleration() {
    let bench = Bench::new();
    bench.file("jerk.8K", one_axis("JRK 20\nX200"));
    let report = bench.sim("jerk.8K --run PROG0 --trace t.csv --rate 0.5ms");
    // Each ramp takes v/a + a/j.
    assert_eq!(report["moves"][0]["motion_seconds"], 12.5);
    let acceleration = Csv::read(&bench.path("t.csv")).column("X.acceleration");
    let steps = acceleration.windows(2).map(|pair| (pair[1] - pair[0]).abs());
    assert!(steps.fold(0.0, f64::max) <= 20.0 * 0.0005 + 1e-9);
}

#[test]
fn the_gantry_lifts_its_camera_while_the_curtain_is_broken() {
    let bench = Bench::new();
    let trace = bench.path("t.csv");
    let arguments = format!("{} --trace {}", gantry().display(), trace.display());
    let report = bench.sim(&arguments);
    assert_eq!(report["stopped"], "until");
    assert_eq!(report["faults"], json!([]));
    let trace = Csv::read(&trace);
    let column = |name: &str| trace.column(name);
    let (time, x, z, curtain) = (column("time_s"), column("X.position"), column("Z.position"), column("BIT10"));
    let retract = 0.48; // 40 mm at 120 mm/s with ramps of 800 mm/s^2: 40/120 + 120/800
    let latency = 0.01; // program slices
    for (row, time) in time.iter().enumerate() {
        let since =
            |state: f64| curtain[..=row].iter().rev().take_while(|value| **value == state).count() as f64 * 0.001;
        if since(1.0) > retract + latency {
            assert_eq!(z[row], 40.0, "the camera is up at {time}");
        }
        if since(0.0) > retract + latency {
            assert_eq!(z[row], 0.0, "the camera is down at {time}");
        }
    }
    let broken: Vec<usize> = (0..time.len()).filter(|row| curtain[*row] == 1.0).collect();
    let travel = broken.windows(2).map(|pair| (x[pair[1]] - x[pair[0]]).abs()).sum::<f64>();
    assert!(travel > 50.0, "X goes on while the curtain is broken: {travel}");
    assert!(report["output"].to_string().contains("scan complete: 12 exposures"));
}

#[test]
fn a_run_can_be_repeated_to_the_byte() {
    let bench = Bench::new();
    let run = |name: &str| {
        let arguments = format!("{} --trace {name}", gantry().display());
        let report = bench.sim(&arguments);
        (report, std::fs::read(bench.path(name)).expect("a trace"))
    };
    assert!(run("first.csv") == run("second.csv"));
}

#[test]
fn a_program_that_never_ends_stops_at_until() {
    let bench = Bench::new();
    bench.file("loop.8K", one_axis("_again\nDWL 0.5\nGOTO again"));
    let run = bench.acrc(["sim", "loop.8K", "--run", "PROG0", "--until", "3s"]).expect(0);
    assert!(run.stdout.contains("stopped at --until 3s"), "{}", run.stdout);
}

#[test]
fn a_run_time_error_names_program_line_and_statement() {
    let bench = Bench::new();
    bench.file("bad.8K", one_axis("DIM LV(1)\nLV0 = 5\nLV0 = 1 : LV0 = LV0 / (LV0 - 1)"));
    let run = bench.acrc(["sim", "bad.8K", "--run", "PROG0"]).expect(1);
    assert!(run.stdout.contains("PROG0 bad.8K line 10 statement 2: division by zero"), "{}", run.stdout);
    let report = bench.sim("bad.8K --run PROG0");
    assert_eq!(report["stopped"], "fault");
    let fault = &report["faults"][0];
    assert_eq!((&fault["program"], &fault["line"], &fault["statement"]), (&json!("PROG0"), &json!(10), &json!(2)));
    assert_eq!(report["programs"][0]["state"], "fault");
}

#[test]
fn flow_expressions_and_output_work_together() {
    let bench = Bench::new();
    let body = "CLEAR\nDIM LV(3)\nDIM $V(1,20)\n\
        FOR LV0 = 1 TO 3 STEP 1\nLV1 = LV1 + LV0\nNEXT\n\
        WHILE (LV2 < 10)\nLV2 = LV2 + 4\nIF (LV2 = 8)\nBREAK\nENDIF\nWEND\n\
        IF (LV1 = 6) THEN PRINT \"six\" : GOSUB Say\n\
        IF (LV1 > 6)\nPRINT \"more\"\nELSEIF (LV1 = 6)\nPRINT \"equal\"\nELSE\nPRINT \"less\"\nENDIF\n\
        $V0 = \"a\" + \"b\"\nPRINT $V0; LV2, BIT10\nEND\n\
        _Say\nOPEN \"COM1:\" AS #1\nPRINT #1, \"said \";\nPRINT #1, 2 + 6 / 3 * 5 - 9\nRETURN";
    bench.file("flow.8K", one_axis(body));
    let report = bench.sim("flow.8K --run PROG0");
    assert_eq!(report["faults"], json!([]));
    let lines: Vec<(i64, &str)> = report["output"]
        .as_array()
        .expect("a list")
        .iter()
        .map(|line| (line["device"].as_i64().expect("a device"), line["text"].as_str().expect("text")))
        .collect();
    assert_eq!(lines, [(0, "six"), (1, "said 3"), (0, "equal"), (0, "ab8\t0")]);
}

#[test]
fn inputs_of_the_world_release_inhibited_programs() {
    let bench = Bench::new();
    bench.file(
        "world.toml",
        "[inputs]\ndoor = 4\n[[event]]\nat = 1.5\nset = [\"door\"]\n[[event]]\nat = 3\nclear = [4]\n",
    );
    bench.file("wait.8K", "PROG1\nPROGRAM\nINH 4\nSET 40\nINH -4\nCLR 40\nPRINT \"door closed\"\nENDP\n");
    let report = bench.sim("wait.8K --run PROG1 --world world.toml --trace t.csv");
    assert_eq!(report["stopped"], "ended");
    let trace = Csv::read(&bench.path("t.csv"));
    let (time, output) = (trace.column("time_s"), trace.column("BIT40"));
    let on: Vec<f64> = time.iter().zip(&output).filter(|(_, state)| **state == 1.0).map(|(time, _)| *time).collect();
    assert!((on[0] - 1.5).abs() < 0.005 && (on[on.len() - 1] - 3.0).abs() < 0.005, "{} {}", on[0], on[on.len() - 1]);
}

#[test]
fn an_hour_of_waiting_equals_stepping_through_it() {
    let bench = Bench::new();
    bench.file("wait.8K", one_axis("DWL 3600\nX20\nPRINT \"moved\"\nDWL 0.3"));
    bench.file("wait9.8K", "PROG9\nPROGRAM\nDWL 1.7\nPRINT \"nine\"\nENDP\n");
    // A trace looks at every tick, so nothing is jumped over.
    let stepped = bench.sim("wait.8K --run PROG0 --until 2h --trace t.csv --rate 1s");
    let jumped = bench.sim("wait.8K --run PROG0 --until 2h");
    assert_eq!(stepped, jumped);
    assert_eq!(jumped["stopped"], "ended");
}

#[test]
fn commands_that_are_not_simulated_are_refused_before_the_run() {
    let bench = Bench::new();
    bench.file("match.8K", one_axis("PRINT \"never\"\nPM ON X"));
    let run = bench.acrc(["sim", "match.8K", "--run", "PROG0"]).expect(2);
    assert!(run.stderr.contains("match.8K:9: PM ON"), "{}", run.stderr);
    assert!(run.stdout.is_empty(), "{}", run.stdout);
}

#[test]
fn setup_code_goes_on_after_a_refused_statement() {
    let bench = Bench::new();
    bench.file("setup.8K", format!("DIM PROG0(100)\n{}", one_axis("PRINT \"still here\"")));
    let run = bench.acrc(["sim", "setup.8K", "--run", "PROG0"]).expect(1);
    assert!(run.stdout.contains("setup setup.8K line 1 statement 1: Re-dimensioned block"), "{}", run.stdout);
    assert!(run.stdout.contains("still here"));
}

#[test]
fn a_program_that_does_not_fit_is_not_stored() {
    let bench = Bench::new();
    bench.file("small.8K", format!("CLEAR\nDIM PROG0(12)\n{}", one_axis("PRINT \"never\"")));
    let run = bench.acrc(["sim", "small.8K", "--run", "PROG0"]).expect(1);
    assert!(run.stdout.contains("bytes but DIM PROG0 gives 12"), "{}", run.stdout);
    assert!(!run.stdout.contains("never"));
}

#[test]
fn programs_start_by_pboot_or_by_run_and_else_the_user_is_told() {
    let bench = Bench::new();
    bench.file("pboot.8K", one_axis("PBOOT\nPRINT \"booted\""));
    assert!(bench.acrc(["sim", "pboot.8K"]).expect(0).stdout.contains("booted"));
    bench.file("plain.8K", one_axis("PRINT \"run\""));
    let refused = bench.acrc(["sim", "plain.8K"]).expect(2);
    assert!(refused.stderr.contains("--run PROG0"), "{}", refused.stderr);
    bench.file("setup.8K", format!("{}RUN PROG0\n", one_axis("PRINT \"run\"")));
    assert!(bench.acrc(["sim", "setup.8K"]).expect(0).stdout.contains("run"));
    let missing = bench.acrc(["sim", "plain.8K", "--run", "PROG3"]).expect(2);
    assert!(missing.stderr.contains("PROG3 has no text"), "{}", missing.stderr);
}

#[test]
fn statements_outside_program_are_executed_as_typed() {
    let bench = Bench::new();
    let typed = one_axis("").replace("PROGRAM\n\nENDP\n", "X20\nINH -516\n?P12290\n");
    bench.file("typed.8K", typed);
    let report = bench.sim("typed.8K --run PROG0");
    assert_eq!(report["output"][0]["text"], "80000");
    assert_eq!(report["moves"][0]["motion_seconds"], 2.828_5);
    assert!(report["notes"].to_string().contains("no PROGRAM .. ENDP"), "{}", report["notes"]);
}

#[test]
fn aliases_are_defined_before_what_they_name_exists() {
    let bench = Bench::new();
    bench.file(
        "alias.8K",
        one_axis("DIM LV(1)\nCount = 3\nPRINT Count; P0").replacen(
            "PROG0\n",
            "CLEAR\nDIM PROG0(1000)\nDIM P(1)\n#DEFINE Count LV0\nPROG0\n",
            1,
        ),
    );
    let report = bench.sim("alias.8K --run PROG0");
    assert_eq!(report["faults"], json!([]));
    assert_eq!(report["output"][0]["text"], "30");
}

#[test]
fn plc_programs_scan_beside_the_programs() {
    let bench = Bench::new();
    bench.file("acrc.toml", "[sim]\nrun = [\"PROG0\", \"PLC1\"]\n");
    bench.file("Setup.8K", "SYS\nDIM PLC0(200)\nDIM PLC1(200)\n");
    bench.file("Prog0.8K", "PROGRAM\nSET 128\nINH 40\nPRINT \"timer\"\nINH 41\nPRINT \"both\"\nENDP\n");
    bench.file("PLC0.8K", "PROGRAM\nPBOOT\nLD 128\nTIM 0 500\nOUT 40\nENDP\n");
    bench.file("PLC1.8K", "PROGRAM\nLD 40\nOUT 41\nENDP\n");
    let report = bench.sim(".");
    let texts: Vec<_> = report["output"].as_array().expect("lines").iter().map(|line| &line["text"]).collect();
    assert_eq!(texts, ["timer", "both"]);
    let programs: Vec<_> = report["programs"].as_array().expect("programs").iter().map(|row| &row["program"]).collect();
    assert_eq!(programs, ["PROG0", "PLC0", "PLC1"]);
    assert_eq!(report["programs"][1]["state"], "running");
    assert!(report["virtual_seconds"].as_f64().expect("a number") < 0.6, "nothing keeps the run going");
}

#[test]
fn a_plc_program_without_text_is_not_started() {
    let bench = Bench::new();
    bench.file("acrc.toml", "[sim]\nrun = [\"PLC1\"]\n");
    bench.file("Prog0.8K", "PROGRAM\nPBOOT\nSET 128\nENDP\n");
    let run = bench.acrc(["sim", "."]).expect(2);
    assert!(run.stderr.contains("PLC1 has no text, so it cannot be started"), "{}", run.stderr);
}

/// A PLC program that counts its scans.
const SCANS: &str = "SYS\nDIM PLC1(400)\nDIM P(1)\nPLC1\nPROGRAM\nP0 = P0 + 1\nENDP\n";

#[test]
fn the_project_says_how_often_plc_programs_scan() {
    let bench = Bench::new();
    bench.file("plc/Setup.8K", SCANS);
    let scans = |config: &str| {
        bench.file("plc/acrc.toml", format!("[sim]\nrun = [\"PLC1\"]\nuntil = \"99ms\"\n{config}"));
        bench.sim("plc --read P0")["values"]["P0"].clone()
    };
    assert_eq!(scans(""), json!(100));
    assert_eq!(scans("plc-scan = \"10ms\"\n"), json!(10));
    assert_eq!(scans("plc-scan = 0.0001\n"), json!(199), "a period of the servo loop is 0.5 ms");
}

#[test]
fn a_plc_program_of_the_project_that_cannot_be_simulated_is_refused() {
    let bench = Bench::new();
    let text =
        format!("{SCANS}SYS\nDIM PLC2(400)\nPLC2\nPROGRAM\nSET 32\nDTALK AXIS0\nENDP\nPROG0\nPROGRAM\nSET 33\nENDP\n");
    bench.file("plc/Setup.8K", text);
    for (run, refused) in [("\"PROG0\"", false), ("\"PROG0\", \"PLC2\"", true)] {
        bench.file("plc/acrc.toml", format!("[sim]\nrun = [{run}]\n"));
        let run = bench.acrc(["sim", "plc"]);
        assert_eq!(run.status, Some(if refused { 2 } else { 0 }), "{}", run.stderr);
        assert_eq!(run.stderr.contains("Setup.8K:13: DTALK"), refused, "{}", run.stderr);
    }
}
