//! How fast programs run: nanoseconds an iteration of small loops, statements a second, and the same loop in Python
//! where that is installed.

use std::hint::black_box;
use std::process::Command;
use std::time::{Duration, Instant};

use acrc_compile::{SourceUnit, compile};
use acrc_syntax::units::Level;
use acrc_vm::{Budget, Call, Code, FaultKind, Frame, Host, Locals, Outcome, Stop, Value, run};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};

/// Iterations of each loop.
const ITERATIONS: u64 = 100_000;

/// Memory of the program.
const MEMORY: u64 = 100_000;

/// Loops by name; each makes [`ITERATIONS`] iterations.
const LOOPS: &[(&str, &str)] = &[
    (
        "while_sum",
        "DIM LV(1)\nDIM DV(1)\nWHILE (LV0 < 100000)\nLV0 = LV0 + 1\n\
            IF (LV0 MOD 3 = 0) THEN DV0 = DV0 + LV0 * 0.5\nWEND",
    ),
    (
        "for_array",
        "DIM LV(2)\nDIM LA(1)\nDIM LA0(1000)\nFOR LV1 = 1 TO 100\nFOR LV0 = 0 TO 999\n\
            LA0(LV0) = LA0(LV0) + LV0\nNEXT\nNEXT",
    ),
    ("gosub", "DIM LV(1)\nWHILE (LV0 < 100000)\nGOSUB Count\nWEND\nEND\n_Count\nLV0 = LV0 + 1\nRETURN"),
    ("parameters", "WHILE (P0 < 100000)\nP0 = P0 + 1\nP1 = P0 * 0.5\nWEND"),
    ("flags", "DIM LV(1)\nWHILE (LV0 < 100000)\nIF (NOT BIT 33) THEN LV0 = LV0 + 1\nBIT 32 = NOT BIT 32\nWEND"),
];

/// A controller of sixteen parameters and 64 flags.
#[derive(Default)]
struct Bench {
    parameters: [f64; 16],
    bits: u64,
}

impl Host for Bench {
    fn parameter(&mut self, number: i64) -> Result<Value, FaultKind> {
        let place = usize::try_from(number).ok().and_then(|number| self.parameters.get(number));
        place.map(|value| Value::Double(*value)).ok_or(FaultKind::UnknownParameter(number))
    }

    fn set_parameter(&mut self, number: i64, value: &Value) -> Result<(), FaultKind> {
        let place = usize::try_from(number).ok().and_then(|number| self.parameters.get_mut(number));
        *place.ok_or(FaultKind::UnknownParameter(number))? = value.to_f64()?;
        Ok(())
    }

    fn bit(&mut self, number: i64) -> Result<bool, FaultKind> {
        Ok(self.bits >> (number & 63) & 1 == 1)
    }

    fn set_bit(&mut self, number: i64, state: bool) -> Result<(), FaultKind> {
        let mask = 1 << (number & 63);
        self.bits = if state { self.bits | mask } else { self.bits & !mask };
        Ok(())
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

fn load(text: &str) -> Code {
    let tree = acrc_syntax::parse(text);
    let file = SourceUnit { name: "bench", text, tree: &tree, start: Level::Program(0), implicit_program: true };
    let image = compile(&[file], "ACR9000").expect("the program compiles");
    let program = image.programs.first().expect("it has a stored program");
    Code::load(program, &image.aliases).expect("it loads")
}

/// Runs a program to its end and gives the number of statements.
fn finish(code: &Code) -> u64 {
    let (mut frame, mut locals, mut bench) = (Frame::new(), Locals::new(MEMORY), Bench::default());
    let finished = run(code, &mut frame, &mut locals, &mut bench, Budget::statements(u32::MAX));
    assert_eq!(finished.stop, Stop::Ended);
    black_box(&bench.parameters);
    u64::from(finished.statements)
}

/// Nanoseconds an iteration of the first loop in Python; `None` when it is not installed.
fn python() -> Option<f64> {
    let script = "import time\nt=time.perf_counter()\ni=0\ns=0.0\nwhile i<1000000:\n    i=i+1\n\
            if i%3==0: s=s+i*0.5\nprint((time.perf_counter()-t)*1000)";
    let output = Command::new("python3").args(["-c", script]).output().ok()?;
    String::from_utf8(output.stdout).ok()?.trim().parse().ok()
}

/// The best of several runs, as the machine may be busy with other things.
fn best(code: &Code) -> Duration {
    let once = || {
        let start = Instant::now();
        finish(code);
        start.elapsed()
    };
    (0..20).map(|_| once()).min().unwrap_or_default()
}

fn loops(criterion: &mut Criterion) {
    for (name, text) in LOOPS {
        let code = load(text);
        let (statements, time) = (finish(&code), best(&code));
        let nanoseconds = time.as_nanos() as f64;
        println!(
            "{name}: {:.1} ns an iteration, {:.0} million statements a second",
            nanoseconds / ITERATIONS as f64,
            statements as f64 * 1000.0 / nanoseconds
        );
    }
    if let (Some((_, text)), Some(python)) = (LOOPS.first(), python()) {
        let own = best(&load(text)).as_nanos() as f64 / ITERATIONS as f64;
        println!("python3: {python:.1} ns an iteration of the first loop, {:.1} times as long", python / own);
    }
    let mut group = criterion.benchmark_group("loops");
    group.throughput(Throughput::Elements(ITERATIONS));
    for (name, text) in LOOPS {
        let code = load(text);
        group.bench_with_input(BenchmarkId::from_parameter(name), &code, |bencher, code| bencher.iter(|| finish(code)));
    }
    group.finish();
}

/// Four lines at a time, as a controller's scheduler runs a program.
fn slices(criterion: &mut Criterion) {
    let code = load(LOOPS.first().map_or("", |(_, text)| text));
    criterion.bench_function("slices_of_four_lines", |bencher| {
        bencher.iter(|| {
            let (mut frame, mut locals, mut bench) = (Frame::new(), Locals::new(MEMORY), Bench::default());
            while run(&code, &mut frame, &mut locals, &mut bench, Budget::lines(4)).stop == Stop::Budget {}
        });
    });
}

criterion_group!(benches, loops, slices);
criterion_main!(benches);
