//! What the axes are connected to.

use crate::bench::{Bench, Plan};
use crate::check::{
    Check,
    Check::{Later, Shows},
};
use crate::guide::{Fact, Listing};

pub(crate) const CHECKS: &[(u8, &[Check])] = &[
    (3, &[Shows(config_of_the_factory), Shows(config_reports)]),
    (4, &[Shows(limit_inputs), Shows(default_limit_inputs), Later("nothing reads the inputs of limits yet")]),
    (5, &[Shows(default_attachments)]),
    (6, &[Shows(last_attachment), Shows(single_loop)]),
    (66, &[Shows(all_steppers), Shows(two_signals)]),
    (67, &[Shows(servos_and_steppers)]),
    (68, &[Shows(commutation)]),
    (72, &[Shows(dac_and_stepper)]),
];

fn config_of_the_factory(listing: &Listing, _: &Fact) {
    let first = listing.text.lines().next().expect("a line");
    assert_eq!(Bench::setup("").ask("CONFIG").trim_end(), first);
    let (_, answers) = Bench::typed(listing);
    assert_eq!(answers, [String::new(), format!("{first}\n")]);
}

fn config_reports(_: &Listing, _: &Fact) {
    let mut bench = Bench::setup("CONFIG ENC4 DAC2 NONE NONE\n");
    assert_eq!(bench.ask("CONFIG"), "CONFIG ENC4 DAC2 NONE NONE\n");
    assert_eq!(bench.ask("CONFIG"), "CONFIG ENC4 DAC2 NONE NONE\n");
}

fn limit_inputs(listing: &Listing, fact: &Fact) {
    let (mut bench, _) = Bench::typed(listing);
    assert_eq!(bench.number("HLBIT Y"), fact.numbers()[0]);
}

fn default_limit_inputs(listing: &Listing, _: &Fact) {
    let mut bench = Bench::terminal(listing);
    for axis in 0..8 {
        assert_eq!(bench.number(&format!("AXIS{axis} HLBIT")), f64::from(3 * axis));
    }
}

fn default_attachments(listing: &Listing, _: &Fact) {
    let before = Bench::setup("").ask("ATTACH");
    assert_eq!(before, listing.text);
    let mut bench = Bench::planned(listing, &Plan { idle: true, ..Plan::default() });
    assert_eq!(bench.ask("ATTACH"), before);
}

fn attached_axes(listing: &Listing) -> Vec<String> {
    let mut bench = Bench::planned(listing, &Plan { idle: true, ..Plan::default() });
    bench.clean();
    bench.ask("ATTACH").lines().map(str::to_owned).collect()
}

fn last_attachment(listing: &Listing, _: &Fact) {
    assert_eq!(attached_axes(listing)[4], "ATTACH AXIS4 ENC4 DAC4 ENC9");
}

fn single_loop(listing: &Listing, _: &Fact) {
    assert_eq!(attached_axes(listing)[0], "ATTACH AXIS0 ENC0 DAC0 ENC0");
}

/// What `ATTACH` and `CONFIG` report behind the file.
fn hardware(listing: &Listing) -> (String, Vec<String>) {
    let attached = attached_axes(listing);
    let mut bench = Bench::planned(listing, &Plan { idle: true, ..Plan::default() });
    (bench.ask("CONFIG"), attached)
}

fn all_steppers(listing: &Listing, _: &Fact) {
    let (config, attached) = hardware(listing);
    assert_eq!(config, "CONFIG NONE STEPPER4 STEPPER4 NONE\n");
    for (axis, line) in attached.iter().enumerate() {
        assert!(line.starts_with(&format!("ATTACH AXIS{axis} STEPPER{axis} STEPPER{axis}")), "{line}");
    }
}

fn two_signals(listing: &Listing, _: &Fact) {
    let attached = attached_axes(listing);
    // Without its third argument the source of the position serves for the velocity too.
    let entered: Vec<&str> = listing.text.lines().filter(|line| line.starts_with("ATTACH")).collect();
    assert_eq!(attached.len(), entered.len());
    assert!(attached.iter().zip(&entered).all(|(attached, entered)| attached.starts_with(entered)));
}

fn servos_and_steppers(listing: &Listing, _: &Fact) {
    let (config, attached) = hardware(listing);
    assert_eq!(config, "CONFIG ENC4 DAC4 STEPPER4 NONE\n");
    for (axis, line) in attached.iter().enumerate() {
        let signals = if axis < 4 { format!("ENC{axis} DAC{axis}") } else { format!("STEPPER{axis} STEPPER{axis}") };
        assert!(line.starts_with(&format!("ATTACH AXIS{axis} {signals}")), "{line}");
    }
}

fn commutation(listing: &Listing, _: &Fact) {
    let (_, attached) = hardware(listing);
    assert_eq!(&attached[..2], ["ATTACH AXIS0 ENC0 CMT0 ENC0", "ATTACH AXIS1 ENC2 CMT1 ENC2"]);
    let mut bench = Bench::planned(listing, &Plan { idle: true, ..Plan::default() });
    assert_eq!((bench.ask("CMT0 ENC"), bench.ask("CMT0 DAC")), ("ENC0\nENC1\n".into(), "DAC0\nDAC1\n".into()));
    assert_eq!((bench.ask("CMT1 ENC"), bench.ask("CMT1 DAC")), ("ENC2\nENC3\n".into(), "DAC2\nDAC3\n".into()));
}

fn dac_and_stepper(listing: &Listing, _: &Fact) {
    let (config, attached) = hardware(listing);
    assert_eq!(config, "CONFIG ENC3 DACSTEP2 NONE ADC8\n");
    assert!(
        attached[0].starts_with("ATTACH AXIS0 ENC0 DAC0") && attached[1].starts_with("ATTACH AXIS1 STEPPER0 STEPPER0")
    );
}
