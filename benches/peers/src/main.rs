//! Loops of the language beside the same loops in Lua 5.4 and Python 3, timed in one run and printed as ratios.
//!
//! `acrc-vm` is the program alone; `controller` is the same program in a controller with its scheduler, four lines a
//! slice, as `acrc sim` runs it. Every loop ends with one result, and all must agree on it.

mod acrobasic;
mod lua;
mod programs;
mod python;

use std::time::{Duration, Instant};

use programs::{ITERATIONS, PROGRAMS, Program};

/// Times each loop runs. The best counts, because the machine may be busy with other things.
const ROUNDS: usize = 25;

/// One implementation of a loop: runs it once, and gives its result and how long it took.
type Contender = Box<dyn FnMut() -> (f64, Duration)>;

/// Runs something that gives a result, and times it.
fn timed(run: impl FnOnce() -> f64) -> (f64, Duration) {
    let start = Instant::now();
    let result = run();
    (result, start.elapsed())
}

/// Nanoseconds an iteration; `None` for what is not installed.
fn contest(program: &Program) -> Vec<Option<f64>> {
    let mut contenders: Vec<Option<Contender>> = vec![
        Some(acrobasic::bare(program)),
        Some(acrobasic::controller(program)),
        Some(lua::contender(program)),
        python::contender(program),
    ];
    let mut best = vec![None; contenders.len()];
    let mut results = Vec::new();
    for _ in 0..ROUNDS {
        for (contender, best) in contenders.iter_mut().zip(&mut best) {
            let Some(contender) = contender else { continue };
            let (result, time) = contender();
            results.push(result);
            let nanoseconds = time.as_nanos() as f64 / ITERATIONS as f64;
            *best = Some(best.map_or(nanoseconds, |best: f64| best.min(nanoseconds)));
        }
    }
    assert!(results.iter().all(|result| *result == results[0]), "{}: results differ: {results:?}", program.name);
    best
}

fn main() {
    let wanted = std::env::args().nth(1);
    println!("nanoseconds an iteration, best of {ROUNDS} runs of {ITERATIONS} iterations");
    println!("{:16}{:>10}{:>12}{:>10}{:>10}   controller against", "", "acrc-vm", "controller", "Lua 5.4", "Python 3");
    for program in PROGRAMS.iter().filter(|program| wanted.as_ref().is_none_or(|name| name == program.name)) {
        let times = contest(program);
        let shown: Vec<String> =
            times.iter().map(|time| time.map_or("-".to_owned(), |time| format!("{time:.1}"))).collect();
        let [vm, controller, lua, python] = &shown[..] else { unreachable!("four contenders") };
        let ratio = |peer: usize| match (times[1], times[peer]) {
            (Some(own), Some(peer)) => format!("{:.2}x", peer / own),
            _ => "-".to_owned(),
        };
        println!(
            "{:16}{vm:>10}{controller:>12}{lua:>10}{python:>10}   Lua {}, Python {}",
            program.name,
            ratio(2),
            ratio(3)
        );
    }
}
