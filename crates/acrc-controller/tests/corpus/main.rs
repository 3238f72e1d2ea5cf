//! The guide's own programs on a virtual controller: which of them a dry run can execute, and what they must show. The files are read where they
//! lie, and nothing is compared when they are not there.

mod bench;
mod check;
mod devices;
mod flow;
mod guide;
mod hardware;
mod homing;
mod jogs;
mod marks;
mod moves;
mod recovery;
mod setup;
mod values;

use std::panic::{AssertUnwindSafe, catch_unwind};

use acrc_controller::Controller;

use bench::Bench;
use check::Check;
use guide::Listing;

/// The files that a dry run refuses, and the commands that it does not execute.
const REFUSED: &[(u8, &[&str])] = &[];

/// The files with a mistake that keeps them from being compiled.
const BROKEN: &[u8] = &[63];

/// The checks of some files.
type Checks = &'static [(u8, &'static [Check])];

/// The checks of all files, by topic.
const TOPICS: [Checks; 10] = [
    flow::CHECKS,
    hardware::CHECKS,
    setup::CHECKS,
    moves::CHECKS,
    jogs::CHECKS,
    homing::CHECKS,
    marks::CHECKS,
    values::CHECKS,
    devices::CHECKS,
    recovery::CHECKS,
];

fn checks(number: u8) -> Option<&'static [Check]> {
    TOPICS.iter().flat_map(|topic| topic.iter()).find(|(file, _)| *file == number).map(|(_, checks)| *checks)
}

#[test]
fn only_the_listed_commands_are_refused() {
    let all: Vec<u8> = (0..16).collect();
    for listing in Listing::all() {
        let image = bench::image(&listing.project(), &listing.model);
        assert_eq!(image.is_err(), BROKEN.contains(&listing.number), "{}: {:?}", listing.name, image.err());
        let Ok(image) = image else { continue };
        let unsupported = Controller::unsupported(&image, &all, &[]);
        let mut names: Vec<&str> = unsupported.iter().map(|refused| refused.command.info().name).collect();
        names.sort_unstable();
        names.dedup();
        let expected = REFUSED.iter().find(|(file, _)| *file == listing.number).map_or(&[][..], |(_, names)| names);
        assert_eq!(names, expected, "{}", listing.name);
    }
}

#[test]
fn every_fact_of_a_file_that_runs_has_a_check() {
    for listing in Listing::all() {
        let runs = !BROKEN.contains(&listing.number) && REFUSED.iter().all(|(file, _)| *file != listing.number);
        let count = checks(listing.number).map_or(0, <[Check]>::len);
        assert!(count == listing.facts.len() || !runs && count == 0, "{}: {count} checks", listing.name);
    }
}

#[test]
fn files_without_facts_are_executed() {
    for listing in Listing::all().iter().filter(|listing| listing.facts.is_empty()) {
        let mut bench = Bench::of(listing);
        bench.pass(1.0);
        // A file that erases the flash memory loads from it on its next line.
        let refused = usize::from(listing.text.contains("FLASH ERASE\nFLASH LOAD"));
        assert_eq!(bench.record.faults.len(), refused, "{}: {:?}", listing.name, bench.record.faults);
    }
}

#[test]
fn flow_is_shown() {
    show(flow::CHECKS);
}

#[test]
fn hardware_is_shown() {
    show(hardware::CHECKS);
}

#[test]
fn setup_is_shown() {
    show(setup::CHECKS);
}

#[test]
fn moves_are_shown() {
    show(moves::CHECKS);
}

#[test]
fn jogs_are_shown() {
    show(jogs::CHECKS);
}

#[test]
fn homing_is_shown() {
    show(homing::CHECKS);
}

#[test]
fn marks_are_shown() {
    show(marks::CHECKS);
}

#[test]
fn values_are_shown() {
    show(values::CHECKS);
}

#[test]
fn devices_are_shown() {
    show(devices::CHECKS);
}

#[test]
fn recovery_is_shown() {
    show(recovery::CHECKS);
}

/// Runs the checks of a topic, and says which facts are not shown.
fn show(topic: Checks) {
    let mut failed = 0;
    for listing in Listing::all() {
        let Some((_, checks)) = topic.iter().find(|(file, _)| *file == listing.number) else { continue };
        for (check, fact) in checks.iter().zip(&listing.facts) {
            match check {
                Check::Later(reason) => println!("{}: {}: later, {reason}", listing.name, fact.fact),
                Check::Shows(check) => {
                    if catch_unwind(AssertUnwindSafe(|| check(&listing, fact))).is_err() {
                        eprintln!("not shown: {}: {}", listing.name, fact.fact);
                        failed += 1;
                    }
                }
            }
        }
    }
    assert_eq!(failed, 0, "facts that are not shown");
}
