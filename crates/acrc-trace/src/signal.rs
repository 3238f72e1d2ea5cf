//! What is recorded: the name, unit and kind of one column of samples.

/// What values a signal takes, and so how it is written and drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Kind {
    /// Any real number, such as a position or a velocity.
    Continuous,
    /// On or off: 0 is off, any other number is on. A value holds until the next sample.
    Bit,
}

/// One recorded quantity.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Signal {
    /// Name, as in `X.position`. Signals whose names agree up to the first dot share a colour in a plot.
    pub name: String,
    /// Unit of the values, as in `mm/s`; empty if there is none.
    pub unit: String,
    /// What values it takes.
    pub kind: Kind,
    /// The plot panel it is drawn in, as in `velocity`.
    pub group: String,
    /// Where its values come from, as in `P12288 / P12375`; empty if nothing is to be said.
    pub source: String,
}

impl Signal {
    /// A signal that takes any real number.
    #[must_use]
    pub fn continuous(name: impl Into<String>, unit: impl Into<String>, group: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            unit: unit.into(),
            kind: Kind::Continuous,
            group: group.into(),
            source: String::new(),
        }
    }

    /// A signal that is on or off.
    #[must_use]
    pub fn bit(name: impl Into<String>, group: impl Into<String>) -> Self {
        Self { name: name.into(), unit: String::new(), kind: Kind::Bit, group: group.into(), source: String::new() }
    }

    /// The same with the place where its values come from.
    #[must_use]
    pub fn with_source(self, source: impl Into<String>) -> Self {
        Self { source: source.into(), ..self }
    }
}

impl Signal {
    /// What the signal is a quantity of: its name up to the first dot.
    pub(crate) fn owner(&self) -> &str {
        self.name.split('.').next().unwrap_or_default()
    }
}

/// Whether a bit with this value is on. What is not a number is off.
pub(crate) fn is_on(value: f64) -> bool {
    value != 0.0 && !value.is_nan()
}
