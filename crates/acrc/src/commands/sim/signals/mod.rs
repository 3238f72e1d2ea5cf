//! Which signals of a run are recorded, and how each is read from the controller.

mod attachments;
mod names;
mod quantities;
mod usual;

use acrc_catalog::{Known, Space, law, parameter};
use acrc_controller::View;
use acrc_controller::world::World;
use acrc_image::Image;
use acrc_trace::Signal;

use self::names::Names;
use self::quantities::Quantity;

/// The names of the axes that the text of a project attaches.
pub(super) fn attached_axes(image: &Image) -> Vec<(String, u8)> {
    attachments::of(image).into_iter().map(|attached| (attached.name, attached.axis)).collect()
}

/// A signal with the way to its values.
#[derive(Clone, Debug)]
struct Column {
    signal: Signal,
    /// What a plot calls it, where that is more than its name.
    label: Option<String>,
    reading: Reading,
}

/// How a value is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Reading {
    /// What the motion of an axis is computed from; finer than the registers, which count whole pulses.
    Motion(u8, Quantity),
    Parameter(u32),
    /// A parameter in pulses of an axis, in units.
    Pulses(u32, u8),
    Bit(u32),
}

/// The signals of a run, in the order of the columns.
#[derive(Debug)]
pub(super) struct Signals {
    columns: Vec<Column>,
    /// Nobody has chosen them.
    usual: bool,
    /// Pairs of columns by name that are the path of a tool.
    paths: Vec<[String; 2]>,
}

impl Signals {
    /// The signals of `--signals`, else those that show what most people want to see.
    pub(super) fn new(asked: &[String], image: &Image, world: &World) -> anyhow::Result<Self> {
        let names = Names::new(image, world);
        let mut columns: Vec<Column> = Vec::new();
        let chosen = if asked.is_empty() {
            usual::columns(&names, image, world)
        } else {
            let found = asked.iter().map(|name| names.find(name, || usual::columns(&names, image, world)));
            found.collect::<anyhow::Result<Vec<_>>>()?.concat()
        };
        for column in chosen {
            if !columns.iter().any(|known| known.reading == column.reading) {
                columns.push(column);
            }
        }
        let name = |axis: u8| {
            let position = Reading::Motion(axis, Quantity::Position);
            let column = columns.iter().find(|column| column.reading == position);
            column.map(|column| column.signal.name.clone())
        };
        let paths = names.planes().filter_map(|(across, up)| Some([name(across)?, name(up)?])).collect();
        Ok(Self { columns, usual: asked.is_empty(), paths })
    }

    /// The columns of a trace. Its names are those that were asked for, or plain: `X.position`, `BIT10`.
    pub(super) fn columns(&self) -> Vec<Signal> {
        self.columns.iter().map(|column| column.signal.clone()).collect()
    }

    /// The columns of a plot, whose flags carry their names.
    pub(super) fn plotted(&self) -> Vec<Signal> {
        let named = self.columns.iter().map(|Column { signal, label, .. }| {
            let name = label.as_ref().unwrap_or(&signal.name).clone();
            Signal { name, ..signal.clone() }
        });
        named.collect()
    }

    /// Which columns a plot can do without as long as they are 0: nobody has asked for them.
    pub(super) fn dispensable(&self) -> Vec<bool> {
        let following = |column: &Column| column.signal.group == quantities::FOLLOWING_ERROR_GROUP;
        self.columns.iter().map(|column| self.usual && following(column)).collect()
    }

    /// Pairs of columns by name that are the path of a tool: the positions of the first two axes of a master.
    pub(super) fn paths(&self) -> Vec<[String; 2]> {
        self.paths.clone()
    }

    /// Samples all signals. What cannot be read, such as a user parameter before its `DIM P`, is no number.
    pub(super) fn sample(&self, view: &View, row: &mut Vec<f64>) {
        row.clear();
        row.extend(self.columns.iter().map(|column| column.reading.value(view)));
    }
}

impl Reading {
    fn value(self, view: &View) -> f64 {
        match self {
            Self::Motion(axis, quantity) => quantity.value(view, axis),
            Self::Parameter(number) => view.parameter(number).unwrap_or(f64::NAN),
            Self::Pulses(number, axis) => {
                let read = |number| view.parameter(number).unwrap_or(f64::NAN);
                read(number) / read(law::PPU.at(u32::from(axis)))
            }
            Self::Bit(number) => f64::from(u8::from(view.bit(number))),
        }
    }
}

impl Column {
    /// A parameter under a name that somebody gave it.
    fn parameter(number: u32, name: &str) -> Self {
        let info = parameter(number);
        // Parameters of one kind share a panel; what users keep in theirs has nothing to do with each other.
        let is_kind = info.known == Known::Row && !matches!(info.object, Space::User | Space::Flags);
        let group = if is_kind { info.title } else { name };
        let signal = Signal::continuous(name, info.unit, group).with_source(format!("P{number}"));
        Self { signal, label: None, reading: Reading::Parameter(number) }
    }

    /// A flag under a name that somebody gave it.
    fn bit(number: u32, name: &str) -> Self {
        let plain = format!("BIT{number}");
        let label = (name != plain).then(|| format!("{plain} {name}"));
        Self { signal: Signal::bit(name, "bits").with_source(plain), label, reading: Reading::Bit(number) }
    }
}
