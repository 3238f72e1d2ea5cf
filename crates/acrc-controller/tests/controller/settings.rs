//! Settings: what a command sets, it reports, and the number that belongs to it holds the same value (guide, "Parametric Evaluation").

use crate::support::Sim;

#[test]
fn a_command_and_its_number_are_one_value() {
    let sim = Sim::program(
        "PGAIN X 0.5\nPRINT P12304\nP12304 = 1\nPGAIN X\nAXIS1 JOG VEL 3\nPRINT P12604\nP12604 = 4\nJOG VEL Y",
    );
    assert_eq!(sim.prints(), ["0.5", "1", "3", "4"]);
    let sim = Sim::new(
        "SYS\nDIM DEF(2)\n#DEFINE Gain P12304\n#DEFINE Gate BIT16148\nGain = 2\nAXIS0 PGAIN\nSET Gate\nAXIS0 HLIM\nPRINT Gain\n",
    );
    assert_eq!(sim.prints(), ["2", "1", "2"]);
    let sim = Sim::program("DAC1 GAIN -3276.8\nADC2 OFFSET 0.25\nPRINT P6418, P6443\nP6418 = 1\nDAC1 GAIN");
    assert_eq!(sim.prints(), ["-3276.8\t0.25", "1"]);
}

#[test]
fn one_value_of_a_pair_is_both_sides() {
    let sim =
        Sim::program("EXC X 2\nEXC X\nPRINT P12328, P12329\nTLM Y(5,-1)\nPRINT P12592, P12593\nP12593 = -2\nTLM Y");
    assert_eq!(sim.prints(), ["2", "-2", "2\t-2", "5\t-1", "5", "-2"]);
    assert_eq!(Sim::program("SLM X 3\nSLM X\nSLM Y").prints(), ["3", "-3", "0"]);
}

#[test]
fn limits_are_flags() {
    let sim = Sim::program("HLIM X3\nPRINT BIT(16148), BIT(16149)\nCLR 16148\nHLIM X\nSET 16151\nSLIM X\nSLIM Y");
    assert_eq!(sim.prints(), ["-1\t-1", "2", "2", "0"]);
    assert_eq!(Sim::program("HLIM X4").faults(), ["HLIM: 4 is not between 0 and 3"]);
}

#[test]
fn settings_without_a_number_are_kept_by_object() {
    let sim = Sim::program(
        "GEAR RATIO X5 Y-2.5\nGEAR RATIO X Y\nGEAR PPU X\nMULT Y -4\nENC1 MULT 2\nMULT Y\nENC1 MULT\nENC0 MULT\nNOTCH X(60, 5)\nNOTCH X",
    );
    assert_eq!(sim.prints(), ["5", "-2.5", "1", "-4", "2", "1", "60", "5"]);
    assert_eq!(
        Sim::program("HLBIT Y\nHLBIT Y 24\nHLBIT Y\nADC MODE\nADC MODE 0\nADC MODE").prints(),
        ["3", "24", "1", "0"]
    );
    assert_eq!(Sim::program("LOPASS X 0.1\nLOPASS X\nCAM DIM X 2.9\nCAM DIM X").prints(), ["0.1", "2"]);
}

#[test]
fn sources_are_kept_and_reported_as_they_are_written() {
    let sim = Sim::program(
        "GEAR SRC X\nGEAR SRC X ENC2\nGEAR SRC X\nCAM SRC X P12290 Y NONE\nCAM SRC X Y\nAXIS1 JOG SRC CLOCK\nJOG SRC Y\n\
         RATCH1 SRC P6160\nRATCH1 SRC\nRATCH1 MODE 3\nRATCH1 MODE\nLIMIT0 SRC RATCH1\nLIMIT0 SRC",
    );
    assert_eq!(sim.prints(), ["NONE", "ENC2", "P12290", "NONE", "CLOCK", "P6160", "3", "RATCH1"]);
}

#[test]
fn objects_keep_sources_arrays_and_pairs() {
    let sim = Sim::program(
        "DIM LA(1)\nDIM LA0(4)\nPLS0 SRC P12288\nPLS0 BASE LA0\nPLS0 DST\nPLS0 DST P4097\nPLS0 MASK\nPLS0 MASK 255\n\
         PLS0 SRC\nPLS0 BASE\nPLS0 DST\nPLS0 MASK\nPLS1 MASK\nFSTAT0 (48, 2)\nCMT0 ENC0 ENC1\nCMT0 PPR 4000\nCMT0 PPR",
    );
    assert_eq!(sim.prints(), ["P4097", "-1", "P12288", "LA0", "P4097", "255", "-1", "4000"]);
}

#[test]
fn segments_of_a_table_are_kept_until_they_are_cleared() {
    let sim = Sim::program(
        "DIM LA(2)\nDIM LA0(4)\nDIM LA1(4)\nCAM DIM X2\nCAM SEG X(1, 500, LA1)\nCAM SEG X(0, 250, LA0)\nCAM SEG X\nCAM CLEAR X\nCAM DIM X",
    );
    assert_eq!(sim.prints(), ["0", "250", "LA0", "1", "500", "LA1", "0"]);
}

#[test]
fn settings_that_act_by_themselves_are_noted() {
    assert_eq!(Sim::program("BKL X0\nSLIM X0\nJOG VEL X5\nGEAR RATIO X2").run().clean().notes(), Vec::<String>::new());
    let notes = Sim::program("ENC0 ROTARY 0.1\nENC1 ROTARY 0.1").run().clean().notes();
    assert_eq!(notes, ["ENC ROTARY was set: the dry run does not fold encoder positions"]);
}

#[test]
fn an_object_that_no_controller_has_is_refused() {
    assert_eq!(Sim::new("SYS\nDAC8 GAIN 1\n").faults(), ["DAC8 does not exist: this controller has DAC0 to DAC7"]);
    assert_eq!(Sim::new("SYS\nPLS8 MASK 1\n").faults(), ["PLS8 does not exist: this controller has PLS0 to PLS7"]);
    assert_eq!(Sim::new("SYS\nENC16 MULT 4\n").faults(), ["ENC16 does not exist: this controller has ENC0 to ENC15"]);
    assert_eq!(Sim::new("SYS\nAXIS9 PGAIN 1\n").faults(), ["AXIS9 does not exist: this controller has AXIS0 to AXIS7"]);
}
