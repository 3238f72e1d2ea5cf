//! The language itself: a program alone, and in a controller with its scheduler.

use std::sync::Arc;

use acrc_compile::{SourceUnit, compile};
use acrc_controller::world::WorldEvent;
use acrc_controller::{Controller, FaultReport, Observer, Options, Sent, Stopped, View};
use acrc_image::Image;
use acrc_syntax::units::Level;
use acrc_vm::{Budget, Call, Code, FaultKind, Frame, Host, Locals, Outcome, Stop, Value, run};

use crate::programs::Program;
use crate::{Contender, timed};

/// Bytes for the variables of the program.
const MEMORY: u64 = 10_000;
/// Virtual time that no loop reaches, in seconds.
const LONG: f64 = 1e9;

fn image(program: &Program) -> Image {
    let text = program.acrobasic();
    let tree = acrc_syntax::parse(&text);
    let file = SourceUnit { name: "peer", text: &text, tree: &tree, start: Level::System, implicit_program: false };
    compile(&[file], "ACR9000").expect("the program compiles")
}

/// The program in the virtual machine, in one go.
pub(crate) fn bare(program: &Program) -> Contender {
    let image = image(program);
    let code = Code::load(&image.programs[0], &image.aliases).expect("the program loads");
    Box::new(move || {
        let (mut frame, mut locals, mut host) = (Frame::new(), Locals::new(MEMORY), Parameters::default());
        timed(|| {
            while run(&code, &mut frame, &mut locals, &mut host, Budget::lines(u32::MAX)).stop != Stop::Ended {}
            host.0[0]
        })
    })
}

/// The program in a controller: slices, ticks, flags.
pub(crate) fn controller(program: &Program) -> Contender {
    let image = Arc::new(image(program));
    Box::new(move || {
        let mut controller = Controller::new(Arc::clone(&image), Options::default()).expect("the image loads");
        timed(|| {
            assert_eq!(controller.run(&[0], LONG, &mut Blind), Stopped::Ended);
            controller.parameter(0).ok().and_then(|value| value.to_f64().ok()).expect("P0 is a number")
        })
    })
}

/// A controller of a few user parameters.
#[derive(Default)]
struct Parameters([f64; 4]);

impl Host for Parameters {
    fn parameter(&mut self, number: i64) -> Result<Value, FaultKind> {
        let place = usize::try_from(number).ok().and_then(|number| self.0.get(number));
        place.map(|value| Value::Double(*value)).ok_or(FaultKind::UnknownParameter(number))
    }

    fn set_parameter(&mut self, number: i64, value: &Value) -> Result<(), FaultKind> {
        let place = usize::try_from(number).ok().and_then(|number| self.0.get_mut(number));
        *place.ok_or(FaultKind::UnknownParameter(number))? = value.to_f64()?;
        Ok(())
    }

    fn bit(&mut self, number: i64) -> Result<bool, FaultKind> {
        Err(FaultKind::UnknownBit(number))
    }

    fn set_bit(&mut self, number: i64, _state: bool) -> Result<(), FaultKind> {
        Err(FaultKind::UnknownBit(number))
    }

    fn command(&mut self, call: &Call) -> Result<Outcome, FaultKind> {
        Err(FaultKind::Unsupported(call.command))
    }

    fn random(&mut self, _below: u32) -> u32 {
        0
    }

    fn take_character(&mut self, _device: i32) -> Result<Option<u8>, FaultKind> {
        Ok(None)
    }

    fn character_waits(&mut self, _device: i32) -> Result<bool, FaultKind> {
        Ok(false)
    }
}

/// Sees nothing, as `acrc sim` without a trace.
struct Blind;

impl Observer for Blind {
    fn output(&mut self, _: &Sent) {}
    fn fault(&mut self, fault: &FaultReport) {
        panic!("{fault}");
    }
    fn event(&mut self, _: f64, _: &WorldEvent, _: &View) {}
    fn tick(&mut self, _: &View) {}
    fn watches_every_tick(&self) -> bool {
        false
    }
}
