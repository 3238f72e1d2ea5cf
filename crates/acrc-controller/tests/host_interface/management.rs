//! Configuration file and reboot.

use crate::support::{Bench, TWO_AXES};

#[test]
fn the_configuration_file_is_text() {
    let mut bench = Bench::new(TWO_AXES);
    let file = bench.controller.configuration_file();
    let text = file.split(|byte| *byte == 0).next().expect("text in front of the zeros");
    let text = String::from_utf8(text.to_vec()).expect("ASCII");
    let version = bench.ask("VER");
    let boards = bench.ask("CONFIG");
    assert_eq!(
        text,
        format!(
            "model=ACR9000\r\nfirmware={version}\r\naxes=8\r\nmasters=8\r\nprograms=16\r\nplcs=8\r\nmemory=1048576\r\nboards={}\r\n",
            boards.trim_start_matches("CONFIG ")
        )
    );
}

#[test]
fn a_reboot_is_the_command() {
    let mut bench = Bench::new(TWO_AXES);
    bench.ask("P1 = 5");
    bench.ask("SET 32");
    bench.ask("PROG0");
    bench.ask("X 100");
    bench.pass(1.0);
    bench.controller.reboot(&mut bench.log);
    bench.pass(0.1);
    assert!(!bench.flag(516) && !bench.flag(32));
    // The battery has kept the user parameters.
    assert_eq!(bench.controller.parameter_long(1), Some(5));
    assert_eq!(bench.log.faults, [""; 0]);
}
