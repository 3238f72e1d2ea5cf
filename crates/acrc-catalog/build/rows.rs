//! The rows of the data files, as written. What the keys mean is in `data/README.md`.

use serde::Deserialize;

use crate::address::AddressLaw;
use crate::vocabulary::Space;

/// Everything in `data/`.
#[derive(Clone, Debug, Default)]
pub struct Catalogue {
    pub commands: Vec<CommandRow>,
    pub functions: Vec<FunctionRow>,
    pub operators: Vec<OperatorRow>,
    pub unary_operators: Vec<OperatorRow>,
    pub operands: Vec<OperandRow>,
    pub parameters: Vec<NumberRow>,
    pub blocks: Vec<BlockRow>,
    pub bits: Vec<NumberRow>,
    pub words: Vec<WordRow>,
    pub models: Vec<ModelRow>,
    pub messages: Vec<MessageRow>,
    pub memory: MemoryFile,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CommandFile {
    pub group: String,
    pub command: Vec<CommandRow>,
}

#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(clippy::struct_excessive_bools, reason = "independent yes-or-no keys of a row")]
pub struct CommandRow {
    pub opcode: u16,
    pub name: String,
    pub constant: Option<String>,
    pub parent: Option<String>,
    pub belongs_to: Option<String>,
    #[serde(default)]
    pub clause: bool,
    #[serde(default = "yes")]
    pub word: bool,
    #[serde(skip)]
    pub group: String,
    pub summary: String,
    #[serde(default)]
    pub note: String,
    pub signature: String,
    #[serde(default)]
    pub arguments: Vec<ArgumentRow>,
    pub shape: String,
    #[serde(default)]
    pub min_args: u8,
    pub max_args: Option<u8>,
    #[serde(default)]
    pub tuple: [u8; 2],
    #[serde(default)]
    pub bare_axis: bool,
    #[serde(default)]
    pub setting: bool,
    pub levels: Vec<String>,
    #[serde(default)]
    pub report: String,
    #[serde(default)]
    pub prefixes: Vec<String>,
    #[serde(default)]
    pub takes_axes: bool,
    #[serde(default)]
    pub daughter_required: bool,
    #[serde(default)]
    pub models: String,
    pub source: String,
    pub confidence: String,
}

fn yes() -> bool {
    true
}

impl CommandRow {
    /// Name of the generated constant.
    pub fn constant(&self) -> String {
        self.constant.clone().unwrap_or_else(|| self.name.to_uppercase().replace(' ', "_"))
    }

    /// The largest number of items; shapes without items of their own have none.
    pub fn max_args(&self) -> u8 {
        let none = matches!(self.shape.as_str(), "None" | "Parent" | "Object");
        self.max_args.unwrap_or(if none { 0 } else { u8::MAX })
    }

    /// The last word of the name.
    pub fn last_word(&self) -> &str {
        self.name.rsplit(' ').next().unwrap_or(&self.name)
    }
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ArgumentRow {
    pub name: String,
    #[serde(default)]
    pub kind: String,
    #[serde(default)]
    pub unit: String,
    #[serde(default)]
    pub range: String,
    #[serde(default)]
    pub default: String,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FunctionFile {
    pub function: Vec<FunctionRow>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FunctionRow {
    pub id: u8,
    pub name: String,
    pub summary: String,
    pub min_args: Option<u8>,
    pub arguments: Vec<String>,
    pub result: String,
    #[serde(default)]
    pub domain: String,
    #[serde(default)]
    pub note: String,
    pub source: String,
    pub confidence: String,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OperatorFile {
    pub operator: Vec<OperatorRow>,
    pub unary: Vec<OperatorRow>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OperatorRow {
    pub symbol: String,
    #[serde(default)]
    pub alternative: String,
    pub precedence: u8,
    pub summary: String,
    pub operands: String,
    pub result: String,
    #[serde(default)]
    pub note: String,
    pub source: String,
    pub confidence: String,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OperandFile {
    pub operand: Vec<OperandRow>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OperandRow {
    pub name: String,
    pub class: Option<String>,
    pub summary: String,
    #[serde(default)]
    pub index: String,
    #[serde(default)]
    pub storage: String,
    #[serde(default)]
    pub note: String,
    pub source: String,
    pub confidence: String,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NumberFile {
    pub object: String,
    #[serde(default)]
    pub parameter: Vec<NumberRow>,
    #[serde(default)]
    pub bit: Vec<NumberRow>,
}

/// A row of parameters or of flags.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NumberRow {
    pub first: u32,
    #[serde(default)]
    pub stride: u32,
    #[serde(default = "one")]
    pub count: u32,
    #[serde(default)]
    pub first_index: u32,
    pub per_object: Option<u32>,
    #[serde(skip)]
    pub object: String,
    pub field: String,
    pub title: String,
    #[serde(default)]
    pub also: Vec<String>,
    #[serde(rename = "type")]
    pub value_type: Option<String>,
    pub kind: Option<String>,
    pub access: Option<String>,
    pub range: Option<[i32; 2]>,
    pub command: Option<String>,
    pub part: Option<u8>,
    #[serde(default)]
    pub default: DefaultRow,
    #[serde(default)]
    pub unit: String,
    #[serde(default)]
    pub note: String,
    pub source: String,
    pub confidence: String,
}

/// Values at power-up: none stated, one for every object, or one for each.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(untagged)]
pub enum DefaultRow {
    #[default]
    None,
    All(f64),
    Each(Vec<f64>),
}

fn one() -> u32 {
    1
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BlockFile {
    pub block: Vec<BlockRow>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BlockRow {
    pub first: u32,
    pub last: u32,
    #[serde(default)]
    pub stride: u32,
    #[serde(default = "one")]
    pub count: u32,
    pub object: String,
    #[serde(default)]
    pub first_index: u32,
    pub group_code: Option<u8>,
    #[serde(default)]
    pub note: String,
    pub source: String,
    pub confidence: String,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WordFile {
    pub word: Vec<WordRow>,
}

/// A run of flag words.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WordRow {
    pub first: u32,
    #[serde(default = "one")]
    pub count: u32,
    pub object: String,
    pub first_index: Option<u32>,
    pub per_object: Option<u32>,
    pub group: String,
    #[serde(default)]
    pub note: String,
    pub source: String,
    pub confidence: String,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ModelFile {
    pub model: Vec<ModelRow>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ModelRow {
    pub name: String,
    #[serde(default)]
    pub default: bool,
    pub programs: u8,
    pub plcs: u8,
    pub masters: u8,
    pub axes: u8,
    pub slaves: u8,
    pub streams: Vec<String>,
    pub user_memory: u32,
    pub servo_period: f64,
    pub plc_last_flag: Option<u32>,
    pub system_pointer: Option<u32>,
    #[serde(default)]
    pub note: String,
    pub source: String,
    pub confidence: String,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MessageFile {
    pub message: Vec<MessageRow>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MessageRow {
    pub id: u8,
    pub name: String,
    pub text: String,
    pub meaning: String,
    pub source: String,
    pub confidence: String,
}

#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MemoryFile {
    pub factory: FactoryRow,
    pub cost: Vec<CostRow>,
}

#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FactoryRow {
    pub program_bytes: u32,
    pub programs: u8,
    pub stream_bytes: u32,
    pub source: String,
    pub confidence: String,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CostRow {
    pub constant: String,
    pub name: String,
    pub unit: String,
    #[serde(default)]
    pub each: u32,
    #[serde(default)]
    pub once: u32,
    #[serde(default)]
    pub character: u32,
    pub most: Option<u32>,
    pub level: String,
    #[serde(default)]
    pub note: String,
    pub source: String,
    pub confidence: String,
}

impl DefaultRow {
    /// The values; none, one for every object, or one for each.
    pub fn values(&self) -> &[f64] {
        match self {
            Self::None => &[],
            Self::All(value) => std::slice::from_ref(value),
            Self::Each(values) => values,
        }
    }
}

impl ArgumentRow {
    /// The value of the default text where that is a number, which a remark in parentheses may follow.
    pub fn default_value(&self) -> Option<f64> {
        self.default.split(" (").next()?.parse().ok()
    }

    /// Left out, it is the first value with its sign turned.
    pub fn is_opposite(&self) -> bool {
        self.default == "-value1"
    }
}

impl NumberRow {
    /// The address law of the row. Without `per_object` it is a law over objects where those are numbered, and over elements elsewhere.
    pub fn law(&self) -> AddressLaw {
        let numbered = Space::from_name(&self.object).is_some_and(Space::is_numbered);
        AddressLaw {
            first: self.first,
            stride: self.stride,
            count: self.count,
            first_index: self.first_index,
            per_object: self.per_object.unwrap_or(u32::from(numbered)),
        }
    }

    /// The numbers of the row.
    pub fn numbers(&self) -> impl Iterator<Item = u32> {
        let law = self.law();
        (0..self.count).filter_map(move |place| law.number(place))
    }
}

impl WordRow {
    /// The words as a law over objects.
    pub fn law(&self) -> AddressLaw {
        let per_object = self.per_object.unwrap_or(u32::from(self.first_index.is_some()));
        AddressLaw {
            first: self.first,
            stride: 1,
            count: self.count,
            first_index: self.first_index.unwrap_or(0),
            per_object,
        }
    }
}
