//! `acrc sim --signals` and `--rate`: what is recorded, and how often.

mod common;

use common::{Bench, Csv, gantry};

/// Records signals of the gantry.
fn record(signals: &str) -> Csv {
    let bench = Bench::new();
    bench.sim(&format!("{} --trace t.csv --signals {signals}", gantry().display()));
    Csv::read(&bench.path("t.csv"))
}

/// What is said about signals that cannot be recorded.
fn refusal(signals: &str) -> String {
    let bench = Bench::new();
    let gantry = gantry();
    let run = bench.acrc(["sim", gantry.to_str().expect("plain"), "--trace", "t.csv", "--signals", signals]).expect(2);
    assert!(!bench.path("t.csv").exists(), "no run, no file");
    run.stderr
}

#[test]
fn parameters_flags_aliases_inputs_and_quantities_are_signals() {
    let signals = "P12288,BIT34,Camera,Exposures,light_curtain,x.position,X.CP,AXIS1.target_position,\
                   MASTER0.vector_velocity,PROG0.program_running,Z.KAMR";
    let trace = record(signals);
    // `Camera` is BIT34, which is there already.
    let names = "time_s,P12288,BIT34,Exposures,light_curtain,X.position,X.current_position,Y.target_position,\
                 MASTER0.vector_velocity,PROG0.program_running,Z.kill_all_motion_request";
    assert_eq!(trace.names.join(","), names);
    let last = |name: &str| trace.column(name).last().copied();
    assert_eq!((last("Exposures"), last("light_curtain")), (Some(12.0), Some(0.0)));
    assert!(trace.column("light_curtain").contains(&1.0) && trace.column("BIT34").contains(&1.0));
    // The register counts whole pulses of 1/800 mm; the position does not.
    let (pulses, fine, register) =
        (trace.column("P12288"), trace.column("X.position"), trace.column("X.current_position"));
    for ((pulses, fine), register) in pulses.iter().zip(fine).zip(register) {
        assert_eq!(pulses / 800.0, register);
        assert!((register - fine).abs() <= 0.5 / 800.0 + 1e-9, "{register} {fine}");
    }
    assert_eq!(trace.column("Y.target_position").into_iter().fold(0.0, f64::max), 90.0);
    assert!((trace.column("MASTER0.vector_velocity").into_iter().fold(0.0, f64::max) - 200.0).abs() < 1e-3);
}

#[test]
fn an_axis_stands_for_what_is_worth_seeing_of_it() {
    let usual = "X.position,X.velocity,X.acceleration,X.following_error";
    assert_eq!(record("X").names.join(","), format!("time_s,{usual}"));
    assert_eq!(record("axis0").names.join(","), format!("time_s,{usual}"));
    let names = record("usual,P0").names.join(",");
    assert!(names.starts_with(&format!("time_s,{usual},Y.position")) && names.ends_with(",BIT10,BIT34,P0"), "{names}");
}

#[test]
fn a_user_parameter_is_no_number_before_it_exists() {
    let bench = Bench::new();
    bench.file("late.8K", "PROG0\nPROGRAM\nDWL 0.01\nP0 = 3\nENDP\nDWL 0.005\nSYS\nDIM P(1)\n");
    bench.sim("late.8K --run PROG0 --trace t.csv --signals P0");
    let values = Csv::read(&bench.path("t.csv")).column("P0");
    assert!(values.first().is_some_and(|value| value.is_nan()), "{values:?}");
    assert_eq!(values.last(), Some(&3.0));
}

#[test]
fn what_is_no_signal_is_named() {
    for (signals, expected) in [
        ("camera", "nothing is named `camera`; did you mean `Camera`?"),
        ("Exposure", "nothing is named `Exposure`; did you mean `Exposures`?"),
        ("light_curtian", "did you mean `light_curtain`?"),
        ("X,nothing", "nothing is named `nothing`: write P12288, BIT32, an alias"),
        ("X.psition", "X has no `psition`; did you mean `X.position`?"),
        ("X.zzz", "X has no `zzz`; docs/reference has the fields"),
        ("PROG0.zzz", "PROG0 has no `zzz`; it has halt_request, program_pause, program_running, run_request"),
        ("Q.position", "no axis is named `Q`; there are X, Y, Z"),
        ("AXIS9.position", "the ACR9000 has axis 0 to 7"),
        ("MASTER0", "say which quantity of it, as in MASTER0.FIELD"),
        ("ENC99.encoder_position", "no controller has ENC99"),
        ("P999999", "no controller has this parameter"),
        ("BIT65536", "no controller has this flag"),
        ("P99999999999", "no controller has this parameter"),
    ] {
        let message = refusal(signals);
        assert!(message.contains(expected), "{signals}: {message}");
    }
}

#[test]
fn an_alias_of_a_variable_is_no_signal() {
    let bench = Bench::new();
    bench.file("alias.8K", "#DEFINE Count LV0\nPROG0\nPROGRAM\nCLEAR\nDIM LV(1)\nCount = 1\nENDP\n");
    let run = bench.acrc(["sim", "alias.8K", "--run", "PROG0", "--trace", "t.csv", "--signals", "Count"]).expect(2);
    assert!(run.stderr.contains("the alias stands for no parameter or flag by number"), "{}", run.stderr);
}

#[test]
fn axes_of_one_name_are_told_apart_by_number() {
    let bench = Bench::new();
    let setup = "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nENDP\n\
                 PROG1\nATTACH MASTER1\nATTACH SLAVE0 AXIS3 \"X\"\nPROGRAM\nENDP\n";
    bench.file("two.8K", setup);
    bench.sim("two.8K --run PROG0 --trace t.csv");
    let names = Csv::read(&bench.path("t.csv")).names.join(",");
    assert!(names.contains(",AXIS0.position,") && names.contains(",AXIS3.position,"), "{names}");
}

#[test]
fn an_axis_goes_by_each_of_its_names() {
    let bench = Bench::new();
    let setup = "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nENDP\n\
                 PROG1\nATTACH MASTER1\nATTACH SLAVE0 AXIS0 \"TOOL\"\nPROGRAM\nENDP\n";
    bench.file("two.8K", setup);
    bench.sim("two.8K --run PROG0 --trace t.csv --signals tool.position,X.position,AXIS0.velocity");
    assert_eq!(Csv::read(&bench.path("t.csv")).names, ["time_s", "X.position", "X.velocity"]);
}

#[test]
fn the_rate_is_a_multiple_of_the_servo_period() {
    let bench = Bench::new();
    bench.file("wait.8K", "PERIOD 0.00025\nPROG0\nPROGRAM\nDWL 0.01\nENDP\n");
    let run = |rate: &str| bench.acrc(["sim", "wait.8K", "--run", "PROG0", "--trace", "t.csv", "--rate", rate]);
    run("250us").expect(0);
    let times = Csv::read(&bench.path("t.csv")).column("time_s");
    assert_eq!(times[..3], [0.0, 0.000_25, 0.000_5]);
    let refused = run("0.9ms").expect(2);
    let expected = "--rate 900us is no multiple of the servo period, which is 250us; 750us and 1ms are";
    assert!(refused.stderr.contains(expected), "{}", refused.stderr);
    assert!(run("0s").expect(2).stderr.contains("--rate: the time between two samples must be above 0"));
}

#[test]
fn a_trace_is_parquet_when_its_name_says_so() {
    let bench = Bench::new();
    bench.sim(&format!("{} --trace t.parquet --rate 10ms", gantry().display()));
    let bytes = bench.read("t.parquet");
    assert!(bytes.starts_with(b"PAR1") && bytes.ends_with(b"PAR1"));
    let text = String::from_utf8_lossy(&bytes);
    assert!(text.contains("unit:X.position") && text.contains("P12288 / P12375"));
}

#[test]
fn a_plot_shows_the_path_and_leaves_out_an_error_that_is_always_zero() {
    let bench = Bench::new();
    bench.sim(&format!("{} --plot p.svg", gantry().display()));
    let picture = String::from_utf8(bench.read("p.svg")).expect("text");
    assert!(picture.contains(">X.position [units]<") && picture.contains(">BIT10 light_curtain<"));
    assert!(!picture.contains("following error"));
    bench.sim(&format!("{} --plot p.svg --signals X", gantry().display()));
    let picture = String::from_utf8(bench.read("p.svg")).expect("text");
    assert!(picture.contains(">following error [units]<"), "who asks for it sees it");
    assert!(!picture.contains(">start<"), "one axis has no path");
}
