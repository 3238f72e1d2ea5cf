//! The TOML of a state. These types belong to the file; the controller's are in [`acrc_controller::nonvolatile`].

mod memory;

use acrc_catalog::{CommandId, Keyword, ObjectKind, OperandClass, all_commands};
use acrc_controller::nonvolatile::{
    AxisParameters, FlashImage, MasterParameters, Memory, Saved, Setting, SettingValue, Slave, SystemParameters,
};
use acrc_image::EncodeError;
use acrc_motion::MoveSettings;
use acrc_vm::{Reference, Source, Value};
use serde::{Deserialize, Serialize};

use self::memory::WireMemory;

/// A state.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct State {
    model: String,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    retained: Vec<Register>,
    memory: Option<WireMemory>,
    image: Option<WireImage>,
    parameters: Option<WireParameters>,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct WireImage {
    in_use: bool,
    everything: bool,
    memory: WireMemory,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct WireParameters {
    period: f64,
    axes: Vec<WireAxis>,
    /// Flags that are set.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    flags: Vec<u32>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    registers: Vec<Register>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    settings: Vec<WireSetting>,
    masters: Vec<WireMaster>,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct WireAxis {
    ppu: f64,
    signals: Option<String>,
}

/// A parameter.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Register {
    number: u32,
    value: Number,
}

/// A number of the language.
#[derive(Debug, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Number {
    Long(i32),
    Single(f32),
    Double(f64),
}

/// A value of a setting.
#[derive(Debug, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum WireValue {
    Long(i32),
    Single(f32),
    Double(f64),
    Object { kind: String, number: Option<u16> },
    Word { word: String, number: Option<u16> },
    Parameter(i64),
    Bit(i64),
    Variable { class: String, number: i64 },
    Element { class: String, array: i64, number: i64 },
    Array { class: String, array: i64 },
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct WireSetting {
    command: String,
    object: u16,
    values: Vec<WireValue>,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct WireMaster {
    program: Option<u8>,
    vel: f64,
    acc: f64,
    dec: f64,
    stp: f64,
    fvel: f64,
    ivel: f64,
    jrk: f64,
    tmov: f64,
    vector: f64,
    fov: f64,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    slaves: Vec<WireSlave>,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct WireSlave {
    slot: u8,
    axis: u8,
    name: String,
    weight: f64,
}

impl State {
    /// The form of a state in a file.
    pub(crate) fn new(saved: &Saved) -> Result<Self, EncodeError> {
        let memory = |memory: &Memory| WireMemory::new(&saved.model, memory);
        let image = |image: &FlashImage| {
            let memory = memory(&image.memory)?;
            Ok::<_, EncodeError>(WireImage { in_use: image.in_use, everything: image.everything, memory })
        };
        Ok(Self {
            model: saved.model.clone(),
            retained: saved.retained.iter().map(Register::new).collect(),
            memory: saved.memory.as_ref().map(memory).transpose()?,
            image: saved.image.as_ref().map(image).transpose()?,
            parameters: saved.parameters.as_ref().map(WireParameters::new),
        })
    }

    /// The state, or what makes no sense in it.
    pub(crate) fn read(self) -> Result<Saved, String> {
        let image = |image: WireImage| {
            let memory = image.memory.read()?;
            Ok::<_, String>(FlashImage { in_use: image.in_use, everything: image.everything, memory })
        };
        Ok(Saved {
            model: self.model,
            memory: self.memory.map(WireMemory::read).transpose()?,
            retained: self.retained.into_iter().map(Register::read).collect(),
            parameters: self.parameters.map(WireParameters::read).transpose()?,
            image: self.image.map(image).transpose()?,
        })
    }
}

impl WireParameters {
    fn new(saved: &SystemParameters) -> Self {
        let axis = |axis: &AxisParameters| WireAxis { ppu: axis.pulses_per_unit, signals: axis.signals.clone() };
        let setting = |setting: &Setting| WireSetting {
            command: setting.command.info().name.to_owned(),
            object: setting.object,
            values: setting.values.iter().map(WireValue::new).collect(),
        };
        Self {
            period: saved.period,
            axes: saved.axes.iter().map(axis).collect(),
            flags: saved.flags.clone(),
            registers: saved.parameters.iter().map(Register::new).collect(),
            settings: saved.settings.iter().map(setting).collect(),
            masters: saved.masters.iter().map(WireMaster::new).collect(),
        }
    }

    fn read(self) -> Result<SystemParameters, String> {
        let setting = |setting: WireSetting| {
            let command = command(&setting.command)?;
            let values = setting.values.into_iter().map(WireValue::read).collect::<Result<_, _>>()?;
            Ok::<_, String>(Setting { command, object: setting.object, values })
        };
        let axis = |axis: WireAxis| AxisParameters { pulses_per_unit: axis.ppu, signals: axis.signals };
        Ok(SystemParameters {
            period: self.period,
            axes: self.axes.into_iter().map(axis).collect(),
            flags: self.flags,
            masters: self.masters.into_iter().map(WireMaster::read).collect::<Result<_, _>>()?,
            settings: self.settings.into_iter().map(setting).collect::<Result<_, _>>()?,
            parameters: self.registers.into_iter().map(Register::read).collect(),
        })
    }
}

impl Register {
    fn new((number, value): &(u32, Value)) -> Self {
        Self { number: *number, value: Number::new(value) }
    }

    fn read(self) -> (u32, Value) {
        (self.number, self.value.read())
    }
}

impl Number {
    fn new(value: &Value) -> Self {
        match value {
            Value::Long(long) => Self::Long(*long),
            Value::Single(single) => Self::Single(*single),
            Value::Double(double) => Self::Double(*double),
            // Neither parameters nor settings hold texts.
            Value::Text(_) => Self::Long(0),
        }
    }

    fn read(self) -> Value {
        match self {
            Self::Long(long) => Value::Long(long),
            Self::Single(single) => Value::Single(single),
            Self::Double(double) => Value::Double(double),
        }
    }
}

impl WireValue {
    fn new(value: &SettingValue) -> Self {
        match value {
            SettingValue::Number(number) => match Number::new(number) {
                Number::Long(long) => Self::Long(long),
                Number::Single(single) => Self::Single(single),
                Number::Double(double) => Self::Double(double),
            },
            SettingValue::Source(source) => match *source {
                Source::Object(kind, number) => Self::Object { kind: kind.name().to_owned(), number },
                Source::Word(word, number) => Self::Word { word: word.name().to_owned(), number },
                Source::Reference(Reference::Parameter(number)) => Self::Parameter(number),
                Source::Reference(Reference::Bit(number)) => Self::Bit(number),
                Source::Reference(Reference::Variable { class, index }) => {
                    Self::Variable { class: class.name().to_owned(), number: index }
                }
                Source::Reference(Reference::Array { class, array }) => {
                    Self::Array { class: class.name().to_owned(), array }
                }
                Source::Reference(Reference::Element { class, array, element }) => {
                    Self::Element { class: class.name().to_owned(), array, number: element }
                }
            },
        }
    }

    fn read(self) -> Result<SettingValue, String> {
        let unknown = |name: &str| format!("`{name}` is no source of a signal");
        let operand = |name: &str| OperandClass::from_name(name).ok_or_else(|| unknown(name));
        let source = match self {
            Self::Long(long) => return Ok(SettingValue::Number(Value::Long(long))),
            Self::Single(single) => return Ok(SettingValue::Number(Value::Single(single))),
            Self::Double(double) => return Ok(SettingValue::Number(Value::Double(double))),
            Self::Object { kind, number } => {
                Source::Object(ObjectKind::from_name(&kind).ok_or_else(|| unknown(&kind))?, number)
            }
            Self::Word { word, number } => {
                Source::Word(Keyword::from_name(&word).ok_or_else(|| unknown(&word))?, number)
            }
            Self::Parameter(number) => Source::Reference(Reference::Parameter(number)),
            Self::Bit(number) => Source::Reference(Reference::Bit(number)),
            Self::Variable { class, number } => {
                Source::Reference(Reference::Variable { class: operand(&class)?, index: number })
            }
            Self::Array { class, array } => Source::Reference(Reference::Array { class: operand(&class)?, array }),
            Self::Element { class, array, number } => {
                Source::Reference(Reference::Element { class: operand(&class)?, array, element: number })
            }
        };
        Ok(SettingValue::Source(source))
    }
}

impl WireMaster {
    fn new(saved: &MasterParameters) -> Self {
        let MoveSettings { velocity, acceleration, deceleration, stop, final_velocity, initial_velocity, jerk, time } =
            saved.settings;
        let slave = |slave: &Slave| WireSlave {
            slot: slave.slot,
            axis: slave.axis,
            name: slave.name.to_string(),
            weight: slave.weight,
        };
        Self {
            program: saved.program,
            vel: velocity,
            acc: acceleration,
            dec: deceleration,
            stp: stop,
            fvel: final_velocity,
            ivel: initial_velocity,
            jrk: jerk,
            tmov: time,
            vector: saved.vector,
            fov: saved.feedrate_override,
            slaves: saved.slaves.iter().map(slave).collect(),
        }
    }

    fn read(self) -> Result<MasterParameters, String> {
        let slave = |slave: WireSlave| match slave.name.parse() {
            Ok(name) => Ok(Slave { slot: slave.slot, axis: slave.axis, name, weight: slave.weight }),
            Err(_) => Err(format!("`{}` is no name of an axis", slave.name)),
        };
        Ok(MasterParameters {
            program: self.program,
            slaves: self.slaves.into_iter().map(slave).collect::<Result<_, _>>()?,
            settings: MoveSettings {
                velocity: self.vel,
                acceleration: self.acc,
                deceleration: self.dec,
                stop: self.stp,
                final_velocity: self.fvel,
                initial_velocity: self.ivel,
                jerk: self.jrk,
                time: self.tmov,
            },
            vector: self.vector,
            feedrate_override: self.fov,
        })
    }
}

fn command(name: &str) -> Result<CommandId, String> {
    let known = all_commands().find(|command| command.name == name);
    known.map(|command| command.id).ok_or_else(|| format!("`{name}` is no command"))
}
