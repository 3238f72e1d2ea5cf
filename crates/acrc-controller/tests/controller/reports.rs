//! Commands without their argument report (guide, "Omitted arguments").

use crate::support::Sim;

#[test]
fn master_settings_report_their_value() {
    assert_eq!(
        Sim::program("ACC 10\nACC\nSTP\nFOV\nVECTOR 2.5\nVECTOR\nTMOV").prints(),
        ["10", "100", "1", "2.5", "0"]
    );
}

#[test]
fn axis_settings_report_a_line_for_each_axis() {
    assert_eq!(Sim::program("PPU X100 Y200\nPPU X Y\nPPU Y").prints(), ["100", "200", "200"]);
    assert_eq!(Sim::program("PGAIN X0.25\nPGAIN X Y").prints(), ["0.25", "0.002441406"]);
    assert_eq!(Sim::program("EXC X(2,-1)\nEXC X").prints(), ["2", "-1"]);
}

#[test]
fn objects_report_at_the_system_prompt() {
    assert_eq!(Sim::new("SYS\nAXIS0 PPU 4000\nAXIS0 PPU\nENC1 MULT -4\nENC1 MULT\n").prints(), ["4000", "-4"]);
}

#[test]
fn values_that_make_no_sense_are_refused() {
    for (statement, fault) in [
        ("ACC -5", "ACC: -5 is negative"),
        ("FOV -1", "FOV: -1 is negative"),
        ("VECDEF X-1", "VECDEF: -1 is negative"),
        ("PPU X(1,2)", "PPU expects one ratio an axis"),
    ] {
        assert_eq!(Sim::program(statement).faults(), [fault]);
    }
}

#[test]
fn limits_report_what_is_enabled() {
    assert_eq!(Sim::program("HLIM X3\nHLIM X\nSLIM Y2\nSLIM Y").prints(), ["3", "2"]);
}

#[test]
fn prints_say_where_they_come_from() {
    let ran = Sim::program("OPEN \"COM1:\" AS #1\nPRINT #1, \"one\"\nPRINT \"a\"; \"b\", 1.5").run().clean();
    let lines: Vec<_> = ran.record.output.iter().map(|line| (line.program, line.device, &*line.text)).collect();
    assert_eq!(lines, [(Some(0), 1, "one"), (Some(0), 0, "ab\t1.5")]);
}
