//! A project beside what a controller has.

use std::collections::BTreeSet;
use std::fmt::Display;

use acrc_image::list::{ListOptions, list_instructions};
use acrc_image::{Alias, Instruction, Node, Separator, UnitName};

use super::demand::Demand;
use super::listing::{Names, unit_lines};
use super::script::Script;
use super::survey::Survey;

/// How two things stand to each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// They are the same.
    Equal,
    /// They are not.
    Different,
    /// Only the project has it.
    OnlyProject,
    /// Only the controller has it.
    OnlyController,
}

impl Standing {
    /// In words.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Equal => "equal",
            Self::Different => "different",
            Self::OnlyProject => "missing on the controller",
            Self::OnlyController => "only on the controller",
        }
    }

    fn of<T: PartialEq>(project: Option<&T>, controller: Option<&T>) -> Self {
        match (project, controller) {
            (Some(_), None) => Self::OnlyProject,
            (None, Some(_)) => Self::OnlyController,
            (project, controller) if project == controller => Self::Equal,
            _ => Self::Different,
        }
    }
}

/// A program on both sides.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pair {
    /// The program.
    pub unit: UnitName,
    /// How it stands.
    pub standing: Standing,
    /// Its lines in the project, as they are listed.
    pub project: Vec<String>,
    /// Its lines on the controller, in the same form where they can be read.
    pub controller: Vec<String>,
}

/// A block of memory or an alias on both sides.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// What it is: `DIM PROG0`, `#DEFINE Lamp`.
    pub name: String,
    /// How it stands.
    pub standing: Standing,
    /// Its value in the project.
    pub project: Option<String>,
    /// Its value on the controller.
    pub controller: Option<String>,
}

/// A project beside what a controller has.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Comparison {
    /// The programs of both.
    pub programs: Vec<Pair>,
    /// Memory, when the project shares it out, and aliases.
    pub entries: Vec<Entry>,
    /// What could not be compared, and why.
    pub notes: Vec<String>,
}

impl Comparison {
    /// Whether nothing differs.
    pub fn is_equal(&self) -> bool {
        let pairs = self.programs.iter().map(|pair| pair.standing);
        pairs.chain(self.entries.iter().map(|entry| entry.standing)).all(|standing| standing == Standing::Equal)
    }
}

/// Compares a project with what a controller has.
pub fn compare(script: &Script, survey: &Survey) -> Comparison {
    let known = survey.aliases.as_deref().unwrap_or_default();
    let names = Names::new(&script.image.aliases, known);
    let units: BTreeSet<UnitName> =
        script.units().map(|unit| unit.name).chain(survey.programs.keys().copied()).collect();
    let pair = |unit: UnitName| {
        let (own, listing) = (script.unit(unit), survey.programs.get(&unit));
        let standing = match (own, listing) {
            (Some(own), Some(listing)) if listing.compare(own, &names).is_err() => Standing::Different,
            // A program without a line is none to a controller.
            (Some(own), None) if own.words.is_empty() => Standing::Equal,
            (own, listing) => Standing::of(own.map(|_| &()), listing.map(|_| &())),
        };
        let project = own.and_then(|unit| unit_lines(unit, &names.entries)).unwrap_or_default();
        let controller = listing.map(|listing| listing.canonical(unit, &names)).unwrap_or_default();
        Pair { unit, standing, project, controller }
    };
    let mut comparison = Comparison::default();
    if let Some(text) = &survey.protected {
        comparison.notes.push(format!("programs were not compared: the controller does not list them ({text})"));
    } else {
        comparison.programs = units.into_iter().map(pair).collect();
    }
    comparison.memory(script, survey);
    comparison.aliases(script, survey);
    comparison
}

impl Comparison {
    fn memory(&mut self, script: &Script, survey: &Survey) {
        let demand = Demand::of(script);
        let Some(own) = demand.memory.as_ref().filter(|_| demand.shares_memory()) else { return };
        let Some(found) = &survey.memory else {
            return self.notes.push("memory was not compared: what DIM reports is not understood".to_owned());
        };
        let blocks: BTreeSet<_> = own.keys().chain(found.keys()).collect();
        for block in blocks {
            self.entry(format!("DIM {block}"), own.get(block), found.get(block));
        }
    }

    fn aliases(&mut self, script: &Script, survey: &Survey) {
        let own = &script.image.aliases;
        let Some(found) = &survey.aliases else {
            if !own.is_empty() {
                self.notes.push("aliases were not compared: what DEF reports is not understood".to_owned());
            }
            return;
        };
        let names: BTreeSet<&str> = own.iter().chain(found).map(|alias| alias.name.as_str()).collect();
        let operand =
            |aliases: &[Alias], name: &str| aliases.iter().find(|alias| alias.name == name).and_then(definition);
        for name in names {
            let (own, found) = (operand(own, name), operand(found, name));
            self.entry(format!("#DEFINE {name}"), own.as_ref(), found.as_ref());
        }
    }

    fn entry<T: PartialEq + Display>(&mut self, name: String, project: Option<&T>, controller: Option<&T>) {
        let standing = Standing::of(project, controller);
        let (project, controller) = (project.map(ToString::to_string), controller.map(ToString::to_string));
        self.entries.push(Entry { name, standing, project, controller });
    }
}

/// What an alias stands for, as it is written.
fn definition(alias: &Alias) -> Option<String> {
    let command = acrc_catalog::command::DEFINE;
    let items = vec![Node::Alias { index: 0, parens: 0 }.into()];
    let define = Instruction { address: 0, separator: Separator::Line, command, items };
    let text = list_instructions(&[define], std::slice::from_ref(alias), &ListOptions::default()).ok()?;
    text.trim_end().rsplit_once(&format!("{} ", alias.name)).map(|(_, operand)| operand.to_owned())
}
