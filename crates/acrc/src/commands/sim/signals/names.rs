//! From the names of `--signals` to what they stand for.

use std::collections::BTreeMap;

use acrc_analysis::nearest;
use acrc_catalog::{
    BitInfo, Known, Model, ObjectKind, OperandClass, Space, ValueType, bit, default_model, model, parameter,
};
use acrc_controller::world::World;
use acrc_image::{Alias, Image, Node};
use anyhow::bail;

use super::attachments::{self, Attached};
use super::{Column, quantities};

/// What `--signals` calls the signals that are recorded without it.
const USUAL: &str = "usual";
/// So many names are listed in a message.
const FEW: usize = 8;
/// The objects whose quantities have names.
const OWNERS: [Space; 8] =
    [Space::Axis, Space::Master, Space::Encoder, Space::Dac, Space::Adc, Space::Cmt, Space::Program, Space::Plc];

/// The names of one project.
pub(super) struct Names<'i> {
    model: &'static Model,
    aliases: &'i [Alias],
    inputs: Vec<(&'i str, u32)>,
    /// What the signals of the axes that are attached somewhere are called, by axis.
    axes: BTreeMap<u8, String>,
    /// All names of axes, each with an axis.
    attached: Vec<(String, u8)>,
    /// The first two axes of every master.
    planes: Vec<(u8, u8)>,
}

impl<'i> Names<'i> {
    pub(super) fn new(image: &'i Image, world: &'i World) -> Self {
        let attached = attachments::of(image);
        let mut axes: BTreeMap<u8, String> = BTreeMap::new();
        for Attached { axis, name, .. } in &attached {
            axes.entry(*axis).or_insert_with(|| name.clone());
        }
        // Two programs may call different axes by one name.
        let taken = axes.clone();
        for (axis, name) in &mut axes {
            if taken.iter().any(|(other, known)| other != axis && known == name) {
                *name = format!("AXIS{axis}");
            }
        }
        let model = model(&image.model).unwrap_or_else(default_model);
        Self {
            model,
            aliases: &image.aliases,
            inputs: world.inputs().collect(),
            axes,
            planes: attachments::planes(&attached),
            attached: attached.into_iter().map(|Attached { axis, name, .. }| (name, axis)).collect(),
        }
    }

    /// The axes with their names, ascending.
    pub(super) fn axes(&self) -> impl Iterator<Item = (u8, &str)> {
        self.axes.iter().map(|(axis, name)| (*axis, name.as_str()))
    }

    /// The first two axes of every master.
    pub(super) fn planes(&self) -> impl Iterator<Item = (u8, u8)> {
        self.planes.iter().copied()
    }

    /// The name of a flag: of the world, else of the project.
    pub(super) fn of_bit(&self, bit: u32) -> Option<&str> {
        let input = self.inputs.iter().find(|(_, number)| *number == bit).map(|(name, _)| *name);
        input.or_else(|| {
            self.aliases.iter().find(|alias| bit_of(&alias.target) == Some(bit)).map(|alias| alias.name.as_str())
        })
    }

    /// The signals that a name stands for. `usual` gives those that are recorded when nobody chooses.
    pub(super) fn find(&self, name: &str, usual: impl Fn() -> Vec<Column>) -> anyhow::Result<Vec<Column>> {
        let name = name.trim();
        if let Some(alias) = self.aliases.iter().find(|alias| alias.name == name) {
            return of_alias(alias).map(|column| vec![column]);
        }
        if let Some((_, bit)) = self.inputs.iter().find(|(input, _)| *input == name) {
            return Ok(vec![Column::bit(*bit, name)]);
        }
        if let Some(column) = numbered(name)? {
            return Ok(vec![column]);
        }
        if name == USUAL {
            return Ok(usual());
        }
        if let Some((owner, quantity)) = name.split_once('.') {
            return self.quantity(name, owner, quantity).map(|column| vec![column]);
        }
        match self.owner(name)? {
            Some((Space::Axis, axis, owner)) => Ok(quantities::main_columns(axis as u8, &owner)),
            Some((_, _, owner)) => bail!("--signals {name}: say which quantity of it, as in {owner}.FIELD"),
            None => bail!("--signals: nothing is named `{name}`{}", self.suggestion(name)),
        }
    }

    fn quantity(&self, name: &str, owner: &str, quantity: &str) -> anyhow::Result<Column> {
        let Some((space, index, owner)) = self.owner(owner)? else {
            bail!("--signals {name}: no axis is named `{owner}`; {}", self.known_axes());
        };
        if let Some(column) = quantities::column(space, index, &owner, quantity) {
            return Ok(column);
        }
        let known = quantities::names(space);
        let lower = quantity.to_ascii_lowercase();
        if known.contains(&lower.as_str()) {
            bail!("--signals {name}: no controller has {owner}");
        }
        let hint = match nearest(&lower, known.iter().copied()) {
            Some(meant) => format!("did you mean `{owner}.{meant}`?"),
            None if known.len() <= FEW => format!("it has {}", known.join(", ")),
            None => "docs/reference has the fields of its parameters and flags".to_owned(),
        };
        bail!("--signals {name}: {owner} has no `{quantity}`; {hint}")
    }

    /// The object that a name stands for, with the name that its signals get: an axis by the name of a program, or `AXIS0`, `MASTER1`, ...
    fn owner(&self, name: &str) -> anyhow::Result<Option<(Space, u32, String)>> {
        let upper = name.to_ascii_uppercase();
        if let Some((axis, name)) = self.axes().find(|(axis, known)| *known == upper || self.is_only(&upper, *axis)) {
            return Ok(Some((Space::Axis, u32::from(axis), name.to_owned())));
        }
        let digits = upper.trim_start_matches(|letter: char| letter.is_ascii_alphabetic());
        let kind = ObjectKind::from_name(&upper[..upper.len() - digits.len()]);
        let space = OWNERS.into_iter().find(|space| kind.is_some() && space.object_kind() == kind);
        let (Some(space), Ok(index)) = (space, digits.parse::<u32>()) else { return Ok(None) };
        let count = match space {
            Space::Axis => self.model.axes,
            Space::Master => self.model.masters,
            Space::Program => self.model.programs,
            Space::Plc => self.model.plcs,
            _ => u8::MAX,
        };
        if index >= u32::from(count) {
            let (kind, last) = (space.name(), count.saturating_sub(1));
            bail!("--signals {name}: the {} has {kind} 0 to {last}", self.model.name);
        }
        // Whatever name was asked for, an axis that has one is called by it.
        let known = u8::try_from(index).ok().filter(|_| space == Space::Axis).and_then(|axis| self.axes.get(&axis));
        Ok(Some((space, index, known.cloned().unwrap_or(upper))))
    }

    /// Whether a name is another one of an axis, and of no other.
    fn is_only(&self, name: &str, axis: u8) -> bool {
        let mut named = self.attached.iter().filter(|(known, _)| known == name).peekable();
        named.peek().is_some() && named.all(|(_, other)| *other == axis)
    }

    fn known_axes(&self) -> String {
        match self.axes.len() {
            0 => "no program attaches one".to_owned(),
            _ => format!("there are {}", self.axes.values().cloned().collect::<Vec<_>>().join(", ")),
        }
    }

    fn suggestion(&self, name: &str) -> String {
        let aliases = self.aliases.iter().map(|alias| alias.name.as_str());
        let known: Vec<&str> = aliases.chain(self.inputs.iter().map(|(name, _)| *name)).chain([USUAL]).collect();
        let same = known.iter().find(|known| known.eq_ignore_ascii_case(name)).copied();
        match same.or_else(|| nearest(name, known)) {
            Some(meant) => format!("; did you mean `{meant}`?"),
            None => {
                ": write P12288, BIT32, an alias, an input of the world, an axis such as X, or X.position".to_owned()
            }
        }
    }
}

/// A parameter or flag by number; nothing when the name is no such thing.
fn numbered(name: &str) -> anyhow::Result<Option<Column>> {
    let upper = name.to_ascii_uppercase();
    let number = |digits: &str| {
        let is_number = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
        is_number.then(|| digits.parse::<u32>().unwrap_or(u32::MAX))
    };
    if let Some(number) = upper.strip_prefix("BIT").and_then(number) {
        let BitInfo { known, .. } = bit(number);
        if known == Known::OutOfSpace {
            bail!("--signals {name}: no controller has this flag");
        }
        return Ok(Some(Column::bit(number, &upper)));
    }
    let Some(number) = upper.strip_prefix('P').and_then(number) else { return Ok(None) };
    let info = parameter(number);
    if info.known == Known::OutOfSpace {
        bail!("--signals {name}: no controller has this parameter");
    }
    if info.ty == Some(ValueType::String) {
        bail!("--signals {name}: it holds text, which is no signal");
    }
    Ok(Some(Column::parameter(number, &upper)))
}

fn of_alias(alias: &Alias) -> anyhow::Result<Column> {
    let name = alias.name.as_str();
    if let Some(bit) = bit_of(&alias.target) {
        return Ok(Column::bit(bit, name));
    }
    match parameter_of(&alias.target) {
        Some(number) => Ok(Column::parameter(number, name)),
        None => {
            bail!("--signals {name}: the alias stands for no parameter or flag by number, so it cannot be recorded")
        }
    }
}

/// The flag that an expression names by number.
pub(super) fn bit_of(node: &Node) -> Option<u32> {
    scalar(node, OperandClass::Bit)
}

fn parameter_of(node: &Node) -> Option<u32> {
    scalar(node, OperandClass::Parameter)
}

fn scalar(node: &Node, asked: OperandClass) -> Option<u32> {
    match node {
        Node::Scalar { class, index, .. } if *class == asked => match **index {
            Node::Long(number) => u32::try_from(number).ok(),
            _ => None,
        },
        _ => None,
    }
}
