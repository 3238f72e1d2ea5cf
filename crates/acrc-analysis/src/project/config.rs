//! `acrc.toml`: the description of a project.

use std::time::Duration;

use acrc_syntax::units::Level;
use camino::Utf8PathBuf;
use serde::de::Error as _;
use serde::{Deserialize, Deserializer};

use super::{FileGlob, LintConfig};

/// The file name of a project description.
pub const CONFIG_NAME: &str = "acrc.toml";

/// The contents of `acrc.toml`; every part may be missing.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Config {
    /// What the project is.
    pub project: ProjectConfig,
    /// How it is simulated.
    pub sim: SimConfig,
    /// How it is checked.
    pub lint: LintConfig,
    /// How its files are formatted.
    pub fmt: FmtConfig,
}

/// `[project]`
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields, default, rename_all = "kebab-case")]
pub struct ProjectConfig {
    /// Its name; the name of the directory when absent.
    pub name: Option<String>,
    /// The controller model, a name of the catalogue.
    pub model: Option<String>,
    /// The files in the order in which they are sent, relative to `acrc.toml`. Absent: found by their names.
    pub files: Option<Vec<Utf8PathBuf>>,
}

/// `[sim]`
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields, default, rename_all = "kebab-case")]
pub struct SimConfig {
    /// Description of the machine around the controller, relative to `acrc.toml`.
    pub world: Option<Utf8PathBuf>,
    /// Programs that are started after the setup.
    pub run: Option<Vec<RunTarget>>,
    /// Length of a simulated run.
    pub until: Option<SimTime>,
    /// What the angle functions take.
    pub angles: Option<Angles>,
    /// Time from one scan of the PLC programs to the next; above zero.
    #[serde(deserialize_with = "scan_time")]
    pub plc_scan: Option<SimTime>,
    /// When `BKL` is added.
    pub backlash: Option<Backlash>,
}

fn scan_time<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<SimTime>, D::Error> {
    let time = SimTime::deserialize(deserializer)?;
    let above_zero = Some(time).filter(|time| !time.0.is_zero());
    above_zero
        .map(Some)
        .ok_or_else(|| D::Error::custom("`plc-scan` is the time from one scan to the next, so it is above 0"))
}

/// When backlash compensation is added to the setpoint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Backlash {
    /// While the primary setpoint is positive, as the guide words it.
    Position,
    /// While the axis travels, or has travelled last, in the positive direction.
    Travel,
}

/// Unit of angles in functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Angles {
    /// As in the library of most languages.
    Radians,
    /// As in `SINE` and `ROTATE`.
    Degrees,
}

/// `[fmt]`. What is absent is as the formatter has it by itself.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields, default, rename_all = "kebab-case")]
pub struct FmtConfig {
    /// The case of the words of the language.
    pub keyword_case: Option<KeywordCase>,
    /// Blanks by which a block is indented.
    #[serde(deserialize_with = "indent")]
    pub indent: Option<u8>,
    /// Where the statement stands that closes a block.
    pub block_ends: Option<BlockEnds>,
    /// Remarks behind statements stand in columns.
    pub align_remarks: Option<bool>,
    /// Tables of `#DEFINE` and `DIM` stand in columns.
    pub align_tables: Option<bool>,
    /// Files that are left alone.
    pub exclude: Vec<FileGlob>,
}

/// The most blanks that a block is indented by.
const WIDEST_INDENT: i64 = 16;

fn indent<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<u8>, D::Error> {
    let blanks = i64::deserialize(deserializer)?;
    let fits = u8::try_from(blanks).ok().filter(|_| blanks <= WIDEST_INDENT);
    let refuse = || D::Error::custom(format!("{blanks} is no indentation: it is 0 to {WIDEST_INDENT} blanks"));
    fits.map(Some).ok_or_else(refuse)
}

/// The case of the words of the language.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum KeywordCase {
    /// `SET 32`
    Upper,
    /// `set 32`
    Lower,
    /// As written.
    Keep,
}

/// Where the statement stands that closes a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum BlockEnds {
    /// Indented as the body.
    Body,
    /// Below the statement that opens the block.
    Opener,
}

/// A program to start: `PROG0` .. `PROG15`, `PLC0` .. `PLC7`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(try_from = "String")]
pub struct RunTarget(pub Level);

impl TryFrom<String> for RunTarget {
    type Error = String;

    fn try_from(text: String) -> Result<Self, Self::Error> {
        match crate::FileRole::of(&format!("{text}.8K")).start() {
            Level::System => Err(format!("`{text}` is no program: expected PROG0 to PROG15 or PLC0 to PLC7")),
            level => Ok(Self(level)),
        }
    }
}

/// A stretch of simulated time: `"60s"`, `"500ms"`, `"2min"`, `"1h"`; a bare number is seconds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(try_from = "WrittenTime")]
pub struct SimTime(pub Duration);

/// A time as `acrc.toml` may have it.
#[derive(Deserialize)]
#[serde(untagged, expecting = "expected a time: seconds, or a text such as \"60s\", \"500ms\", \"2min\" or \"1h\"")]
enum WrittenTime {
    /// Seconds; a whole number is one of these too.
    Seconds(f64),
    /// A number with its unit.
    Text(String),
}

impl TryFrom<WrittenTime> for SimTime {
    type Error = String;

    fn try_from(written: WrittenTime) -> Result<Self, Self::Error> {
        match written {
            WrittenTime::Seconds(seconds) => Duration::try_from_secs_f64(seconds)
                .map(Self)
                .map_err(|_| format!("{seconds} is no time: seconds are not negative and not beyond all measure")),
            WrittenTime::Text(text) => Self::try_from(text),
        }
    }
}

/// Units of [`SimTime`] in seconds; the longer suffix first where one ends like another.
const TIME_UNITS: [(&str, f64); 4] = [("ms", 0.001), ("min", 60.0), ("s", 1.0), ("h", 3600.0)];

impl TryFrom<String> for SimTime {
    type Error = String;

    fn try_from(text: String) -> Result<Self, Self::Error> {
        TIME_UNITS
            .iter()
            .find_map(|(suffix, seconds)| {
                let number: f64 = text.strip_suffix(suffix)?.trim_end().parse().ok()?;
                (number >= 0.0).then_some(number * seconds)
            })
            .and_then(|seconds| Duration::try_from_secs_f64(seconds).ok())
            .map(Self)
            .ok_or_else(|| {
                format!(
                    "`{text}` is no time: write a number and a unit, such as \"60s\", \"500ms\", \"2min\" or \"1h\""
                )
            })
    }
}

/// Reads the text of an `acrc.toml`. The message of an error shows the line.
pub(super) fn parse(text: &str) -> Result<Config, String> {
    toml::from_str(text).map_err(|error| error.to_string().trim_end().to_owned())
}
