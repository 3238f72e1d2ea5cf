//! States to save.

use std::sync::Arc;

use acrc_compile::{SourceUnit, compile};
use acrc_controller::nonvolatile::{Memory, Saved, SystemParameters};
use acrc_controller::{Controller, FaultReport, Observer, Options, Sent, View};
use acrc_syntax::units::Level;
use acrc_vm::Value;

/// What a controller has kept that executed a text at its system prompt.
pub(crate) fn after(text: &str) -> Saved {
    let tree = acrc_syntax::parse(text);
    let unit = SourceUnit { name: "test.8K", text, tree: &tree, start: Level::System, implicit_program: false };
    let image = compile(&[unit], "ACR9000").unwrap_or_else(|errors| panic!("{errors:#?}"));
    let mut controller = Controller::new(Arc::new(image), Options::default()).expect("compiled programs load");
    controller.run(&[], 1.0, &mut Strict);
    controller.saved()
}

/// A controller in which something of everything is kept.
pub(crate) fn full() -> Saved {
    after(
        "SYS\nCLEAR\nDIM PROG0(4096)\nDIM P(4)\nDIM DEF(4)\n#DEFINE Speed P1\nP0 = 0.1\nP3 = -1E300\nP38913 = -7\nP39170 = 0.1\n\
         PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS2 \"X\"\nATTACH SLAVE3 AXIS0 \"LIFT\"\nACC 750 DEC 740 STP 730 VEL 75 FOV 0.5\n\
         VECDEF LIFT0.25\nPPU X4000\nPGAIN X0.0025\nEXC LIFT(1,-2)\nGEAR SRC X ENC2\nPROGRAM\nPBOOT\nREM \"text\"\nX(Speed)\nENDP\nSYS\nESAVE\nFLASH IMAGE\n",
    )
}

/// A state whose parts all say the same number, so that a mixture of two shows.
pub(crate) fn numbered(number: u32) -> Saved {
    Saved {
        model: "ACR9000".to_owned(),
        memory: Some(Memory { user: vec![f64::from(number); 50], ..Memory::default() }),
        retained: vec![(38_912, Value::Long(number as i32))],
        parameters: Some(SystemParameters { period: f64::from(number), ..SystemParameters::default() }),
        image: None,
    }
}

/// Nothing goes wrong.
struct Strict;

impl Observer for Strict {
    fn output(&mut self, _: &Sent) {}

    fn fault(&mut self, fault: &FaultReport) {
        panic!("{fault}");
    }

    fn event(&mut self, _: f64, _: &acrc_controller::world::WorldEvent, _: &View) {}

    fn tick(&mut self, _: &View) {}
}
