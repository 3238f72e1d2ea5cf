//! How fast virtual time passes: programs that never wait, and eight axes in coordinated motion.

use std::sync::Arc;
use std::time::{Duration, Instant};

use acrc_compile::{SourceUnit, compile};
use acrc_controller::world::{World, WorldEvent};
use acrc_controller::{Controller, FaultReport, Observer, Options, Sent, View};
use acrc_image::Image;
use acrc_syntax::units::Level;
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

/// Virtual time of each run in seconds.
const SECONDS: f64 = 10.0;

/// Computes and looks at a flag for ever.
const POLLING: &str = "SYS\nDIM P(10)\nPROG0\nDIM LV(1)\nDIM DV(1)\nPROGRAM\nWHILE (NOT BIT 128)\nLV0 = LV0 + 1\n\
                       IF (LV0 MOD 3 = 0) THEN DV0 = DV0 + LV0 * 0.5\nP0 = DV0\nWEND\nENDP\n";

/// Looks at parameters and flags, and writes some, for ever.
const REGISTERS: &str = "PROG0\nPROGRAM\nWHILE (NOT BIT 516)\nIF (P12290 > 100 OR P4096 <> 0) THEN END\nP12304 = P12304 + 0.5\n\
                         BIT 32 = NOT BIT 32\nP38912 = P38912 + 1\nWEND\nENDP\n";

/// Moves eight axes forth and back, each move blended into the next.
const MOVING: &str = "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"A\"\nATTACH SLAVE1 AXIS1 \"B\"\nATTACH SLAVE2 AXIS2 \"C\"\n\
                      ATTACH SLAVE3 AXIS3 \"D\"\nATTACH SLAVE4 AXIS4 \"E\"\nATTACH SLAVE5 AXIS5 \"G\"\nATTACH SLAVE6 AXIS6 \"H\"\n\
                      ATTACH SLAVE7 AXIS7 \"I\"\nACC 500 DEC 500 STP 0 VEL 50\nPROGRAM\n_Again\n\
                      A/10 B/5 C/4 D/3 E/2 G/1 H/7 I/6\nA/-10 B/-5 C/-4 D/-3 E/-2 G/-1 H/-7 I/-6\nGOTO Again\nENDP\n";

/// The same with sixteen axes, each with a motor, a switch and marks, and everything in its loop.
fn motors() -> (String, String) {
    let axes = || (0..16_u8).map(|axis| (axis, format!("A{}", char::from(b'A' + axis))));
    let joined =
        |part: &dyn Fn(u8, &str) -> String| axes().map(|(axis, name)| part(axis, &name)).collect::<Vec<_>>().concat();
    let loops = joined(&|axis, _| {
        let settings = [
            "PPU 4000",
            "PGAIN 0.005",
            "IGAIN 0.01",
            "ILIMIT 1",
            "DGAIN 0.00003",
            "FFVEL 0.000001",
            "FFACC 0.00000001",
            "NOTCH (200, 20)",
            "LOPASS 500",
            "EXC 10",
        ];
        settings.map(|setting| format!("AXIS{axis} {setting}\n")).concat()
    });
    let slaves = joined(&|axis, name| format!("ATTACH SLAVE{axis} AXIS{axis} \"{name}\"\n"));
    let drives = joined(&|_, name| format!("{name} "));
    let forth = joined(&|axis, name| format!("{name}/{} ", axis + 1));
    let back = joined(&|axis, name| format!("{name}/-{} ", axis + 1));
    let profile = "ACC 500 DEC 500 STP 0 VEL 50";
    let text = format!(
        "{loops}PROG0\nATTACH MASTER0\n{slaves}{profile}\nPROGRAM\nDRIVE ON {drives}\n_Again\n{forth}\n{back}\nGOTO Again\nENDP\n"
    );
    let world = joined(&|axis, _| {
        format!(
            "[axis.{axis}]\nplant = {{ kind = \"motor\", inertia = 2e-5, torque_constant = 0.157, lines = 4000, \
             viscous_friction = 4e-4, coulomb_friction = 0.001 }}\nmarker = {{ every = 1 }}\n\
             switches = [{{ input = {axis}, from = 5, to = 6 }}]\n"
        )
    });
    (text, world)
}

/// Waits, mostly.
const WAITING: &str = "PROG0\nPROGRAM\n_Again\nDWL 0.1\nBIT 32 = NOT BIT 32\nGOTO Again\nENDP\n";

/// Polls an input that never comes, as short as it can be written.
const POLL: &str = "PROGRAM\nWHILE (BIT10=0) : WEND\nENDP\n";

/// Changes an output four times a second.
const FLASH: &str = "PROG0\nPROGRAM\n_Again\nBIT 32 = NOT BIT 32\nDWL 0.25\nGOTO Again\nENDP\n";

/// An hour of a controller that waits for something.
fn idle_projects() -> [(&'static str, String, Vec<u8>); 5] {
    let space = |number: u8| format!("DIM PROG{number}(500)\n");
    let poller = |number: u8| format!("PROG{number}\n{POLL}");
    let plc = |number: u8| {
        let rung = format!("LD {number}\nAND NOT 10\nOUT {}", 40 + number);
        format!("SYS\nDIM PLC{number}(500)\nPLC{number}\nPROGRAM\nPBOOT\n{rung}\nENDP\n")
    };
    let (spaces, plcs): (String, String) = ((8..16).map(space).collect(), (0..8).map(plc).collect());
    let (pollers, others): (String, String) = ((0..16).map(poller).collect(), (1..16).map(poller).collect());
    [
        ("one poller", format!("PROG0\n{POLL}"), vec![0]),
        ("16 pollers", format!("SYS\n{spaces}{pollers}"), (0..16).collect()),
        ("16 pollers and 8 PLC programs", format!("SYS\n{spaces}{plcs}{pollers}"), (0..16).collect()),
        ("dwells of 10 ms", "PROG0\nPROGRAM\n_Again\nDWL 0.01\nGOTO Again\nENDP\n".to_owned(), vec![0]),
        ("15 pollers and an output that flashes", format!("SYS\n{spaces}{others}{FLASH}"), (0..16).collect()),
    ]
}

/// Not measured by criterion: an hour each, once.
fn idle_hours() {
    for (name, text, programs) in idle_projects() {
        let image = image(&text, "ACR9000");
        let mut controller = Controller::new(image, Options::default()).expect("it loads");
        let start = Instant::now();
        controller.run(&programs, 3600.0, &mut Blind { every_tick: false });
        println!("an hour of {name}: {:.1} ms", start.elapsed().as_secs_f64() * 1000.0);
    }
}

/// Sees nothing.
struct Blind {
    every_tick: bool,
}

impl Observer for Blind {
    fn output(&mut self, _: &Sent) {}
    fn fault(&mut self, fault: &FaultReport) {
        panic!("{fault}");
    }
    fn event(&mut self, _: f64, _: &WorldEvent, _: &View) {}
    fn tick(&mut self, _: &View) {}
    fn watches_every_tick(&self) -> bool {
        self.every_tick
    }
}

fn image(text: &str, model: &str) -> Arc<Image> {
    let tree = acrc_syntax::parse(text);
    let file = SourceUnit { name: "bench", text, tree: &tree, start: Level::System, implicit_program: false };
    Arc::new(compile(&[file], model).expect("the program compiles"))
}

/// Runs program 0 and gives the number of its statements.
fn run(image: &Arc<Image>, world: &World, every_tick: bool) -> u64 {
    let options = Options { world: world.clone(), ..Options::default() };
    let mut controller = Controller::new(Arc::clone(image), options).expect("it loads");
    controller.run(&[0], SECONDS, &mut Blind { every_tick });
    controller.programs().iter().map(|program| program.statements).sum()
}

/// The best of several runs, as the machine may be busy with other things.
fn best(image: &Arc<Image>, world: &World, every_tick: bool) -> Duration {
    let once = || {
        let start = Instant::now();
        run(image, world, every_tick);
        start.elapsed()
    };
    (0..10).map(|_| once()).min().unwrap_or_default()
}

fn virtual_time(criterion: &mut Criterion) {
    idle_hours();
    let mut group = criterion.benchmark_group("ten_seconds");
    let (motors, world) = motors();
    let runs = [
        ("polling", POLLING, "", false),
        ("registers", REGISTERS, "", false),
        ("moving", MOVING, "", false),
        ("16 motors", &motors, &world, false),
        ("waiting", WAITING, "", true),
    ];
    for (name, text, world, every_tick) in runs {
        let image = image(text, if world.is_empty() { "ACR9000" } else { "ACR8020" });
        let world = World::parse(world).expect("a valid world");
        let (statements, seconds) = (run(&image, &world, every_tick), best(&image, &world, every_tick).as_secs_f64());
        println!(
            "{name}: {:.0} times real time, {:.2} million ticks a second, {:.2} million statements a second",
            SECONDS / seconds,
            SECONDS / 0.0005 / seconds / 1e6,
            statements as f64 / seconds / 1e6,
        );
        group.throughput(Throughput::Elements((SECONDS / 0.0005) as u64));
        group.bench_function(name, |bencher| bencher.iter(|| run(&image, &world, every_tick)));
    }
    group.finish();
}

criterion_group!(benches, virtual_time);
criterion_main!(benches);
