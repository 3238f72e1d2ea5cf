//! Dwell, inhibit, slices and the groups of programs that share one (guide, "Logic Function", "INH").

use crate::support::{Sim, TWO_AXES};

#[test]
fn a_dwell_ends_in_the_first_slice_after_its_time() {
    assert_eq!(
        Sim::program("DWL 0.1\nPRINT 1\nDWL 0.0101\nPRINT 2\nDWL 0\nPRINT 3").timed(),
        ["100 1", "112 2", "112 3"]
    );
}
