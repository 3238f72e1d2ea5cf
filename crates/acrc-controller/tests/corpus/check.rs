//! What stands beside a fact of the guide.

use crate::guide::{Fact, Listing};

/// How a fact is shown.
pub(crate) enum Check {
    /// By a run.
    Shows(fn(&Listing, &Fact)),
    /// Not yet: why.
    Later(&'static str),
}
