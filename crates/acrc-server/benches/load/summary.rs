//! The table.

use std::time::Duration;

use crate::clients::Measured;
use crate::status::Arrivals;

/// A measurement beside that of the bare server.
pub(crate) struct Row<'a> {
    name: &'a str,
    measured: &'a Measured,
    bare: &'a Measured,
    goal: Option<f64>,
}

impl<'a> Row<'a> {
    pub(crate) fn rate(name: &'a str, measured: &'a Measured, bare: &'a Measured, goal: Option<f64>) -> Self {
        Self { name, measured, bare, goal }
    }
}

fn micros(duration: Duration) -> f64 {
    duration.as_secs_f64() * 1e6
}

/// Rates and latencies; the latency of pipelined reads is that of a whole window.
pub(crate) fn print(rows: &[Row]) {
    println!(
        "{:36} {:>10} {:>10} {:>8} {:>8} {:>8} {:>7}",
        "", "a second", "goal", "p50 us", "p99 us", "p99.9 us", "bare"
    );
    for Row { name, measured, bare, goal } in rows {
        println!(
            "{name:36} {:>10.0} {:>10} {:>8.0} {:>8.0} {:>8.0} {:>7}",
            measured.rate(),
            goal.map_or_else(String::new, |goal| format!("{goal:.0}")),
            micros(measured.quantile(0.5)),
            micros(measured.quantile(0.99)),
            micros(measured.quantile(0.999)),
            format!("{:.2}x", measured.rate() / bare.rate()),
        );
        println!(
            "{:36} {:>10.0} {:>10} {:>8.0} {:>8.0} {:>8.0}",
            "    bare tokio server",
            bare.rate(),
            "",
            micros(bare.quantile(0.5)),
            micros(bare.quantile(0.99)),
            micros(bare.quantile(0.999)),
        );
    }
}

/// Fast status.
pub(crate) fn print_status(rows: &[(&str, &Arrivals)]) {
    println!("{:36} {:>10} {:>10} {:>10} {:>12}", "", "due", "late", "share", "longest us");
    for (name, arrivals) in rows {
        println!(
            "{name:36} {:>10} {:>10} {:>9.3}% {:>12.0}",
            arrivals.due,
            arrivals.late,
            100.0 * arrivals.share(),
            micros(arrivals.longest),
        );
    }
}
