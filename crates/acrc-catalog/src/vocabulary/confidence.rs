//! How far a row of the catalogue can be trusted.

named_enum! {
    /// How well a row is attested. What rests on a [`Confidence::Low`] row is reported as a warning at most.
    pub enum Confidence {
        /// Stated by a document or by working client code.
        High = "high",
        /// The thing is attested; details, span or base are partly reasoned.
        Medium = "medium",
        /// In no document at hand, or a lone and doubtful claim.
        Low = "low",
    }
}

impl Confidence {
    /// The word that reports use.
    pub const fn label(self) -> &'static str {
        match self {
            Self::High => "confirmed",
            Self::Medium => "partly confirmed",
            Self::Low => "unconfirmed",
        }
    }
}
