//! Puts a machine together from what the files do.

use acrc_catalog::{ObjectKind, OperandClass};
use acrc_syntax::units::Level;

use super::Machine;
use crate::deed::{self, Deed, On};
use crate::index::{AliasTarget, Attachment, AttachmentKind, Effects, Exports, Use, WriteKind};
use crate::symbols::{AliasSymbol, Symbols};

/// An alias of a flag or parameter that does something when it is written.
struct Lever<'a> {
    alias: &'a AliasSymbol,
    /// By the way of writing.
    deeds: Vec<(WriteKind, Deed, u32)>,
}

/// All ways of writing.
const HOW: [WriteKind; 3] = [WriteKind::Set, WriteKind::Clear, WriteKind::Assign];

impl Machine {
    /// What the files do together. They are in the order of the project.
    pub(crate) fn new(symbols: &Symbols, files: &[(&Exports, &Effects)]) -> Self {
        let mut machine = Self::default();
        for (exports, _) in files {
            machine.attach(exports);
        }
        sort(&mut machine.masters);
        sort(&mut machine.axes);
        let scaled = |(_, effects): &(_, &Effects)| effects.uses.iter().any(|used| used.deed == Deed::PulsesPerUnit);
        let set_up = machine.complete || files.iter().any(scaled);
        machine.complete = set_up && !machine.masters.is_empty() && !machine.axes.is_empty();
        if files.iter().all(|(exports, _)| exports.attachments.iter().all(is_detachment)) {
            let naming = (0..).zip(files).find(|(_, (_, effects))| !effects.naming_axes.is_empty());
            machine.unattached = naming.map(|(file, _)| file);
        }
        for (_, effects) in files {
            machine.programs.extend_from_slice(&effects.programs);
        }
        sort(&mut machine.programs);
        if machine.complete {
            machine.add_deeds(symbols, files);
        }
        machine
    }

    fn add_deeds(&mut self, symbols: &Symbols, files: &[(&Exports, &Effects)]) {
        let levers: Vec<Lever> = symbols.aliases.iter().filter_map(Lever::new).collect();
        for (file, (_, effects)) in (0..).zip(files) {
            self.add(file, symbols, effects, &levers);
        }
        sort(&mut self.level_deeds);
        sort(&mut self.first);
        sort(&mut self.first_moves);
        sort(&mut self.enabled);
    }

    fn attach(&mut self, exports: &Exports) {
        for attachment in &exports.attachments {
            match attachment.kind {
                AttachmentKind::Master { master: Some(master) } => self.masters.push((master, attachment.level)),
                AttachmentKind::Slave { axis: Some(axis), .. } => self.axes.push((axis, attachment.level)),
                AttachmentKind::Master { .. } | AttachmentKind::Slave { .. } => self.open = true,
                AttachmentKind::Axis { axis, stepper } => {
                    self.complete = true;
                    match axis {
                        Some(axis) if stepper => self.steppers.add(axis),
                        None if stepper => self.steppers.open(),
                        Some(axis) => self.servos.add(axis),
                        _ => {}
                    }
                }
                AttachmentKind::Detach { .. } | AttachmentKind::DetachAll => {}
            }
        }
    }

    fn add(&mut self, file: u32, symbols: &Symbols, effects: &Effects, levers: &[Lever<'_>]) {
        for used in &effects.uses {
            self.add_use(file, symbols, used);
        }
        for (deed, object) in &effects.writes {
            self.add_to_object(*deed, *object);
        }
        for lever in levers {
            let name = &lever.alias.name;
            let from = effects.aliases.partition_point(|(other, _)| other < name);
            let written = effects.aliases.get(from..).unwrap_or_default().iter();
            for (_, how) in written.take_while(|(other, _)| other == name) {
                for (_, deed, object) in lever.deeds.iter().filter(|(kind, ..)| kind == how) {
                    self.add_to_object(*deed, *object);
                }
            }
        }
        if effects.computed_flags {
            deed::of_any_flag().for_each(|deed| self.open(deed));
        }
        if effects.computed_parameters {
            deed::of_any_parameter().for_each(|deed| self.open(deed));
        }
    }

    fn add_use(&mut self, file: u32, symbols: &Symbols, used: &Use) {
        let Use { deed, level, on, .. } = used;
        if !deed.is_of_program() {
            match axis_of(symbols, *level, on) {
                Axis::Number(axis) => self.add_to_axis_by(file, used, Some(axis)),
                Axis::Any => self.add_to_axis_by(file, used, None),
                Axis::None => {}
            }
            return;
        }
        match on {
            On::Level => self.level_deeds.push((*deed, *level)),
            On::Object(kind @ (ObjectKind::Master | ObjectKind::Prog | ObjectKind::Plc), Some(number)) => {
                self.add_to_numbered(*deed, *kind, *number);
            }
            On::Object(..) | On::Axis(_) | On::Word(_) => self.open(*deed),
        }
    }

    fn add_to_axis_by(&mut self, file: u32, used: &Use, axis: Option<u32>) {
        let Use { deed, level, stored, .. } = *used;
        self.add_to_axis(deed, axis);
        if !stored {
            return;
        }
        if let Some(axis) = axis.filter(|_| deed.is_motion())
            && !self.first.iter().any(|(of, on, at, _)| (*of, *on, *at) == (deed, axis, level))
        {
            self.first.push((deed, axis, level, file));
        }
        if deed == Deed::Move && self.first_file_moving(level).is_none() {
            self.first_moves.push((level, file));
        }
        if deed == Deed::DriveOn {
            self.enabled.push((axis, level));
        }
    }

    fn add_to_axis(&mut self, deed: Deed, axis: Option<u32>) {
        if let Some(axes) = self.axis_deeds.get_mut(deed as usize) {
            match axis {
                Some(axis) => axes.add(axis),
                None => axes.open(),
            }
        }
    }

    /// The object of a flag or parameter: its kind follows from what is done.
    fn add_to_object(&mut self, deed: Deed, object: u32) {
        match deed {
            Deed::Run => self.add_to_numbered(deed, ObjectKind::Prog, object),
            _ if deed.is_of_program() => self.add_to_numbered(deed, ObjectKind::Master, object),
            _ => self.add_to_axis(deed, Some(object)),
        }
    }

    fn add_to_numbered(&mut self, deed: Deed, kind: ObjectKind, number: u32) {
        let small = u8::try_from(number).unwrap_or(u8::MAX);
        match kind {
            ObjectKind::Master => {
                let levels = self.masters.iter().filter(|(master, _)| *master == number);
                let deeds: Vec<_> = levels.map(|(_, level)| (deed, *level)).collect();
                self.level_deeds.extend(deeds);
            }
            ObjectKind::Plc => self.level_deeds.push((deed, Level::Plc(small))),
            _ => self.level_deeds.push((deed, Level::Program(small))),
        }
    }

    fn open(&mut self, deed: Deed) {
        self.add_to_axis(deed, None);
        if let Some(open) = self.open_levels.get_mut(deed as usize) {
            *open = true;
        }
    }
}

/// The axis that something is done to.
enum Axis {
    Number(u32),
    /// Its number is not written.
    Any,
    /// The program has no axis of this name, which is reported elsewhere.
    None,
}

fn axis_of(symbols: &Symbols, level: Level, on: &On<Box<str>>) -> Axis {
    match on {
        On::Object(ObjectKind::Axis, Some(axis)) => Axis::Number(*axis),
        On::Axis(name) => match symbols.axes_at(level) {
            Some(table) => match table.find(name) {
                Some((_, Some(axis))) => Axis::Number(*axis),
                Some((_, None)) => Axis::Any,
                None if table.open => Axis::Any,
                None => Axis::None,
            },
            // Which names a PLC program may use is not documented.
            None if matches!(level, Level::Plc(_)) => Axis::Any,
            None => Axis::None,
        },
        On::Level | On::Object(..) | On::Word(_) => Axis::Any,
    }
}

impl<'a> Lever<'a> {
    fn new(alias: &'a AliasSymbol) -> Option<Self> {
        let (class, number) = match alias.operand.target {
            AliasTarget::Operand(class, Some(number)) => (class, number),
            // The number of a flag: `SET First`.
            AliasTarget::Number => (OperandClass::Bit, alias.operand.text.parse().ok()?),
            _ => return None,
        };
        let of = |how| deed::of(class, number, how).into_iter().map(move |(deed, object)| (how, deed, object));
        let deeds: Vec<_> = HOW.into_iter().flat_map(of).collect();
        (!deeds.is_empty()).then_some(Self { alias, deeds })
    }
}

fn is_detachment(attachment: &Attachment) -> bool {
    matches!(attachment.kind, AttachmentKind::Detach { .. } | AttachmentKind::DetachAll)
}

fn sort<T: Ord>(list: &mut Vec<T>) {
    list.sort_unstable();
    list.dedup();
}
