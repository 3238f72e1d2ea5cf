//! What the bytes of a text go to, as an object of JSON.

use acrc_image::TextCost;
use serde::{Serialize, Serializer};

/// A field for each kind of bytes.
pub(crate) struct Kinds(pub(crate) TextCost);

impl Serialize for Kinds {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.kinds())
    }
}
