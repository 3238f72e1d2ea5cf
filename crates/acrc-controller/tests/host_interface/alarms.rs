//! Alarms.

use acrc_controller::{AlarmKind, HostAlarm, Options};

use crate::support::{Bench, TWO_AXES};

fn controller_alarm(kind: AlarmKind, object: u32, count: u32) -> HostAlarm {
    HostAlarm::Controller { kind, object, count }
}

#[test]
fn codes_are_one_bit_each() {
    let codes = AlarmKind::ALL.map(AlarmKind::code);
    assert_eq!(codes, [1, 2, 4, 8, 16, 32, 64, 128]);
}

#[test]
fn a_quiet_controller_has_no_alarms() {
    let mut bench = Bench::new(TWO_AXES);
    bench.ask("PROG0");
    bench.ask("X 10");
    bench.pass(5.0);
    assert_eq!(bench.controller.take_alarms(), []);
}

#[test]
fn killed_axes_are_alarms() {
    let mut bench = Bench::new(TWO_AXES);
    bench.controller.take_alarms();
    for count in 1..3 {
        bench.set_flag(8467, true).expect("a flag");
        let killed = [0, 1].map(|axis| controller_alarm(AlarmKind::MotionKilled, axis, count));
        assert_eq!(bench.controller.take_alarms(), killed);
        assert_eq!(bench.controller.take_alarms(), []);
        for flag in [8467, 8499, 522] {
            bench.set_flag(flag, false).expect("a flag");
        }
        assert_eq!(bench.controller.take_alarms(), []);
    }
}

#[test]
fn faults_of_programs_are_counted() {
    let mut bench = Bench::new(&format!("{TWO_AXES}PROG3\nPROGRAM\nP1 = 1 / P0\nENDP\n"));
    bench.ask("PROG3");
    bench.ask("RUN");
    bench.ask("RUN");
    let faults = [1, 2].map(|count| controller_alarm(AlarmKind::ProgramFault, 3, count));
    assert_eq!(bench.controller.take_alarms(), faults);
}

#[test]
fn a_program_raises_alarms_by_a_parameter() {
    let options = Options { user_alarm: Some(5), ..Options::default() };
    let setup = format!("{TWO_AXES}PROGRAM\nP5 = 7\nDWL 0.1\nP5 = 7\nDWL 0.1\nP5 = -1\nENDP\n");
    let mut bench = Bench::with(&setup, options);
    bench.ask("PROG0");
    bench.ask("RUN");
    bench.pass(1.0);
    let raised = [HostAlarm::User { value: 7 }, HostAlarm::User { value: u32::MAX }];
    assert_eq!(bench.controller.take_alarms(), raised);
}

#[test]
fn without_a_parameter_programs_raise_none() {
    let mut bench = Bench::new(&format!("{TWO_AXES}PROGRAM\nP5 = 7\nENDP\nRUN\n"));
    bench.pass(1.0);
    assert_eq!(bench.controller.take_alarms(), []);
}
