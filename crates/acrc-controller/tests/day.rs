//! A virtual day of sixteen programs and eight PLC programs: nothing grows, and no time is lost.

use std::sync::Arc;

use acrc_compile::{SourceUnit, compile};
use acrc_controller::world::{World, WorldEvent};
use acrc_controller::{Controller, FaultReport, Observer, Options, Sent, State, Stopped, View};
use acrc_syntax::units::Level;
use acrc_vm::Value;

const HOUR: u64 = 3600;
const DAY: u64 = 24 * HOUR;

/// Keeps what is printed, and how much memory the process has at each hour.
#[derive(Default)]
struct Log {
    printed: Vec<String>,
    /// Pages at the ends of the hours, where the system tells.
    pages: Vec<u64>,
}

impl Observer for Log {
    fn output(&mut self, sent: &Sent) {
        self.printed.push(sent.text.trim_end().to_owned());
    }
    fn fault(&mut self, fault: &FaultReport) {
        panic!("{fault}");
    }
    fn event(&mut self, _: f64, _: &WorldEvent, _: &View) {}
    fn tick(&mut self, view: &View) {
        if view.seconds() >= ((self.pages.len() as u64 + 1) * HOUR) as f64 {
            self.pages.push(resident_pages().unwrap_or(0));
        }
    }
    fn watches_every_tick(&self) -> bool {
        false
    }
}

/// Pages of this process in memory; `None` where there is no `/proc`.
fn resident_pages() -> Option<u64> {
    let text = std::fs::read_to_string("/proc/self/statm").ok()?;
    text.split(' ').nth(1)?.parse().ok()
}

/// A PLC program with a clock of its own, a counter and a latch.
fn plc(number: u32) -> String {
    let (pulse, count, latch, preset) = (130 + number, 140 + number, 150 + number, 900_000 + 60_000 * number);
    format!(
        "PLC{number}\nPROGRAM\nPBOOT\nLD NOT {pulse}\nTIM 0 {preset}\nOUT {pulse}\nLD {pulse}\nLD {count}\nCNT 0 5\n\
         OUT {count}\nLD {pulse}\nLD {count}\nKR {latch}\nENDP\n"
    )
}

/// Programs that dwell, poll, call, count and print strings.
fn program(number: u32) -> String {
    let body = match number {
        0..6 => format!("_Again\nDWL {}\nP{number} = P{number} + 1\nGOTO Again", 200 + number),
        6 => "DIM $V(2, 20)\n_Again\nINH 0\n$V0 = STR$(P6916)\n$V1 = \"at \" + $V0\nPRINT $V1\nINH -0\nGOTO Again"
            .to_owned(),
        7 => {
            "DIM LV(1)\nWHILE (NOT BIT 1)\nGOSUB Look\nWEND\nPRINT P6916\nEND\n_Look\nLV0 = 1 - LV0\nRETURN".to_owned()
        }
        // The low ones may not wait: they would hold each other.
        _ => format!("WHILE (NOT BIT 1) : WEND\nP{number} = P6916"),
    };
    format!("PROG{number}\nPROGRAM\n{body}\nENDP\n")
}

fn project() -> String {
    let spaces = (0..16).map(|number| format!("DIM PROG{number}(4000)\n"));
    let spaces = spaces.chain((0..8).map(|number| format!("DIM PLC{number}(1000)\n")));
    let setup = std::iter::once("SYS\nCLEAR\nDIM P(100)\n".to_owned()).chain(spaces);
    setup.chain((0..8).map(plc)).chain((0..16).map(program)).collect()
}

/// Input 0 comes on at every full hour for a minute, input 1 at the end of the day.
fn world() -> World {
    let hours = (0..24).map(|hour| {
        let on = hour * HOUR;
        format!("[[event]]\nat = \"{on}s\"\nset = [0]\n[[event]]\nat = \"{}s\"\nclear = [0]\n", on + 60)
    });
    let text: String = hours.chain([format!("[[event]]\nat = \"{DAY}s\"\nset = [1]\n")]).collect();
    World::parse(&text).expect("a valid world")
}

#[test]
fn a_virtual_day_loses_no_time_and_no_memory() {
    let text = project();
    let tree = acrc_syntax::parse(&text);
    let unit = SourceUnit { name: "day.8K", text: &text, tree: &tree, start: Level::System, implicit_program: false };
    let image = compile(&[unit], "ACR9000").expect("it compiles");
    let mut controller =
        Controller::new(Arc::new(image), Options { world: world(), ..Options::default() }).expect("it loads");
    let mut log = Log::default();
    let programs: Vec<u8> = (0..16).collect();

    let stopped = controller.run(&programs, DAY as f64 + 1.0, &mut log);

    assert_eq!((stopped, controller.seconds()), (Stopped::Until, DAY as f64 + 1.0));
    // Each hour is seen within one round of the slices, whose ten or more programs take as many milliseconds.
    assert_eq!(log.printed.len(), 25, "{:?}", log.printed);
    for (hour, line) in (0..).zip(&log.printed[..24]) {
        let at: u64 = line.trim_start_matches("at ").parse().expect("a time");
        assert!((hour * HOUR * 1000..hour * HOUR * 1000 + 30).contains(&at), "{line} in hour {hour}");
    }
    let value = |number| match controller.parameter(number) {
        Ok(Value::Double(value)) => value,
        other => panic!("P{number} is {other:?}"),
    };
    // A loop takes its dwell, and at most one round of the slices more.
    for (number, dwell) in (0..6).zip(200_u32..) {
        let (most, least) = (DAY as f64 / f64::from(dwell), DAY as f64 / (f64::from(dwell) + 0.02));
        let loops = value(number);
        assert!(loops <= most + 1.0 && loops >= least.floor() - 1.0, "P{number} is {loops}, not {least} to {most}");
    }
    for number in 8..16 {
        let seen = value(number) - (DAY * 1000) as f64;
        assert!((0.0..250.0).contains(&seen), "program {number} saw the end of the day {seen} ms late");
    }
    let states: Vec<_> = controller.programs().iter().map(|program| program.state).collect();
    assert_eq!(states[6..16], [[State::Waiting].as_slice(), &[State::Ended; 9]].concat()[..]);
    assert!(states[16..].iter().all(|state| *state == State::Running), "{states:?}");
    // The first hour fills what is reused from then on.
    let grown = log.pages.last().zip(log.pages.first()).map_or(0, |(last, first)| last.saturating_sub(*first));
    assert!(log.pages.len() == 24 && grown < 256, "{grown} pages more after a day than after an hour");
}
