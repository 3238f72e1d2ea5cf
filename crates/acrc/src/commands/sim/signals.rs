//! Which signals of a run are recorded: every axis that the image attaches, the inputs that the world drives, and the flags that programs switch.

use std::collections::{BTreeMap, BTreeSet};

use acrc_catalog::{ObjectKind, OperandClass, command, law};
use acrc_controller::View;
use acrc_controller::world::World;
use acrc_image::{Image, Instruction, Node};
use acrc_trace::Signal;

/// The signals of a run, in the order of the columns.
#[derive(Debug)]
pub(super) struct Signals {
    axes: Vec<(u8, String)>,
    bits: Vec<(u32, String)>,
}

/// Values recorded of each axis.
const AXIS_VALUES: usize = 3;

impl Signals {
    /// Reads them off an image and its world.
    pub(super) fn new(image: &Image, world: &World) -> Self {
        let mut axes = BTreeMap::new();
        let mut bits: BTreeSet<u32> = world.driven_inputs().into_iter().collect();
        for unit in std::iter::once(&image.boot).chain(&image.programs) {
            for instruction in unit.decode().unwrap_or_default() {
                if let Some((axis, name)) = attached_axis(&instruction) {
                    axes.entry(axis).or_insert(name);
                }
                bits.extend(switched_bit(&instruction, image).filter(|bit| is_shown(*bit)));
            }
        }
        let bit_name = |bit: u32| {
            let alias = image.aliases.iter().find(|alias| bit_of(&alias.target) == Some(bit));
            let name = world.input_name(bit).or(alias.map(|alias| alias.name.as_str()));
            name.map_or_else(|| format!("BIT{bit}"), |name| format!("BIT{bit} {name}"))
        };
        Self { axes: axes.into_iter().collect(), bits: bits.into_iter().map(|bit| (bit, bit_name(bit))).collect() }
    }

    /// The columns of a trace. Its names are plain: `X.position`, `BIT10`.
    pub(super) fn columns(&self) -> Vec<Signal> {
        self.build(|bit, _| format!("BIT{bit}"))
    }

    /// The columns of a plot, whose flags carry their names.
    pub(super) fn plotted(&self) -> Vec<Signal> {
        self.build(|_, name| name.to_owned())
    }

    fn build(&self, bit_name: impl Fn(u32, &str) -> String) -> Vec<Signal> {
        let axes = self.axes.iter().flat_map(|(_, name)| {
            [
                Signal::continuous(format!("{name}.position"), "units", "position"),
                Signal::continuous(format!("{name}.velocity"), "units/s", "velocity"),
                Signal::continuous(format!("{name}.acceleration"), "units/s²", "acceleration"),
            ]
        });
        let bits = self.bits.iter().map(|(bit, name)| Signal::bit(bit_name(*bit, name), "bits"));
        axes.chain(bits).collect()
    }

    /// Samples all signals.
    pub(super) fn sample(&self, view: &View, row: &mut Vec<f64>) {
        row.clear();
        row.reserve(self.axes.len() * AXIS_VALUES + self.bits.len());
        for (axis, _) in &self.axes {
            let (velocity, acceleration) = view.motion(*axis);
            row.extend([view.position(*axis), velocity, acceleration]);
        }
        row.extend(self.bits.iter().map(|(bit, _)| f64::from(u8::from(view.bit(*bit)))));
    }
}

/// Axis and name of `ATTACH SLAVEn AXISm "name"`.
fn attached_axis(instruction: &Instruction) -> Option<(u8, String)> {
    if instruction.command != command::ATTACH_SLAVE {
        return None;
    }
    let mut items = instruction.items.iter().map(|item| &item.node);
    let axis = items.find_map(|node| match node {
        Node::Object { kind: ObjectKind::Axis, index: Some(index), .. } => u8::try_from(*index).ok(),
        _ => None,
    })?;
    let name = items.find_map(|node| match node {
        Node::String { bytes, .. } => Some(bytes.iter().map(|byte| char::from(byte.to_ascii_uppercase())).collect()),
        _ => None,
    })?;
    Some((axis, name))
}

/// The flag that `SET`, `CLR` or an assignment switches, when its number is written down.
fn switched_bit(instruction: &Instruction, image: &Image) -> Option<u32> {
    let target = &instruction.items.first()?.node;
    let target = match target {
        Node::Alias { index, .. } => &image.aliases.get(usize::from(*index))?.target,
        _ => target,
    };
    match (instruction.command, target) {
        (command::SET | command::CLR, Node::Long(number)) => u32::try_from(*number).ok(),
        (command::SET | command::CLR | command::ASSIGNMENT, _) => bit_of(target),
        _ => None,
    }
}

fn bit_of(node: &Node) -> Option<u32> {
    match node {
        Node::Scalar { class: OperandClass::Bit, index, .. } => match **index {
            Node::Long(number) => u32::try_from(number).ok(),
            _ => None,
        },
        _ => None,
    }
}

/// Outputs and user flags; settings such as limit levels are not worth a lane.
fn is_shown(bit: u32) -> bool {
    let laws = [law::ONBOARD_INPUT, law::ONBOARD_OUTPUT, law::USER_FLAG_1_4, law::USER_FLAG_5];
    laws.iter().any(|law| law.index_of(bit).is_some())
}
