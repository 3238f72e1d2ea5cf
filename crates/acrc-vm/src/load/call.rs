//! Calls of functions.

use acrc_catalog::{Confidence, FunctionId, function};
use acrc_image::Node;

use super::Loader;
use super::error::LoadErrorKind;
use super::expression::Hint;
use super::place::{Kind, Place};
use crate::code::Doubt;
use crate::fault::FaultKind;
use crate::functions::{Math, TextFunction, TextResult};
use crate::op::{DeviceQuery, Op};

impl Loader<'_> {
    pub(super) fn call(&mut self, id: FunctionId, arguments: &[Node], hint: Hint) -> Result<Place, LoadErrorKind> {
        let info = id.info();
        if info.confidence == Confidence::Low {
            self.doubt(info.name, Doubt::Existence);
        }
        if !(usize::from(info.min_args)..=usize::from(info.max_args)).contains(&arguments.len()) {
            let takes = takes(info.min_args, info.max_args);
            self.raise(FaultKind::Argument(format!("{} takes {takes}, not {}", info.name, arguments.len()).into()));
            return Ok(Place::LongConst(0));
        }
        if let Some(function) = TextFunction::from_id(id) {
            return self.text_call(function, arguments);
        }
        match arguments.first() {
            Some(argument) => self.number_call(id, argument, hint),
            None => self.unknown_function(info.name),
        }
    }

    /// A function of one number.
    fn number_call(&mut self, id: FunctionId, argument: &Node, hint: Hint) -> Result<Place, LoadErrorKind> {
        let mark = self.scratch;
        let argument = self.expression(argument)?;
        if let Some(function) = Math::from_id(id) {
            if function.has_angle() {
                self.doubt(id.info().name, Doubt::AngleUnit);
            }
            let from = self.double(&argument)?;
            self.scratch = mark;
            let to = self.double_result(hint)?;
            self.emit(Op::DoubleMath { function, to, from });
            return Ok(Place::Double(to));
        }
        match id {
            function::ABS => self.absolute(&argument, mark, hint),
            function::RND => {
                let below = self.double(&argument)?;
                self.scratch = mark;
                let to = self.double_result(hint)?;
                self.emit(Op::Random { to, below });
                Ok(Place::Double(to))
            }
            function::INKEY_DOLLAR => self.device(DeviceQuery::TakeCharacter, &argument),
            function::GETCH => self.device(DeviceQuery::AwaitCharacter, &argument),
            function::KBHIT => self.device(DeviceQuery::Waits, &argument),
            _ => self.unknown_function(id.info().name),
        }
    }

    fn absolute(&mut self, argument: &Place, mark: super::Scratch, hint: Hint) -> Result<Place, LoadErrorKind> {
        match argument.kind() {
            Kind::Long => {
                let from = self.long(argument)?;
                self.scratch = mark;
                let to = self.long_result(hint)?;
                self.emit(Op::LongAbs { to, from });
                Ok(Place::Long(to))
            }
            Kind::Value => {
                let from = self.value(argument)?;
                self.scratch = mark;
                let to = self.value_slot()?;
                self.emit(Op::ValueAbs { to, from });
                Ok(Place::Value(to))
            }
            kind => {
                let from = self.double(argument)?;
                self.scratch = mark;
                let to = if kind == Kind::Single { self.double_slot()? } else { self.double_result(hint)? };
                self.emit(Op::DoubleAbs { to, from });
                Ok(if kind == Kind::Single { Place::Single(to) } else { Place::Double(to) })
            }
        }
    }

    fn device(&mut self, query: DeviceQuery, device: &Place) -> Result<Place, LoadErrorKind> {
        let device = self.long(device)?;
        let result = self.value_slot()?;
        self.emit(Op::Device { query, to: result, device });
        if query == DeviceQuery::TakeCharacter {
            return Ok(Place::Text(result));
        }
        let to = self.long_slot()?;
        self.emit(Op::ValueToLong { to, from: result });
        Ok(Place::Long(to))
    }

    /// The arguments go to neighbouring slots.
    fn text_call(&mut self, function: TextFunction, arguments: &[Node]) -> Result<Place, LoadErrorKind> {
        let mut slots = Vec::with_capacity(arguments.len());
        for _ in arguments {
            slots.push(self.value_slot()?);
        }
        let mark = self.scratch;
        for (argument, slot) in arguments.iter().zip(&slots) {
            let place = self.expression(argument)?;
            self.value_to(&place, *slot);
            self.scratch = mark;
        }
        let Some(from) = slots.first().copied() else { return Err(LoadErrorKind::NotAValue) };
        self.emit(Op::TextCall { function, to: from, from, count: slots.len() as u8 });
        match function.result() {
            TextResult::Text => Ok(Place::Text(from)),
            TextResult::Long => {
                let to = self.long_slot()?;
                self.emit(Op::ValueToLong { to, from });
                Ok(Place::Long(to))
            }
            TextResult::Double => {
                let to = self.double_slot()?;
                self.emit(Op::ValueToDouble { to, from });
                Ok(Place::Double(to))
            }
        }
    }

    fn unknown_function(&mut self, name: &'static str) -> Result<Place, LoadErrorKind> {
        self.raise(FaultKind::UnknownFunction(name));
        let to = self.value_slot()?;
        Ok(Place::Text(to))
    }
}

/// How many arguments a function takes.
fn takes(least: u8, most: u8) -> String {
    match (least, most) {
        (1, 1) => "1 argument".to_owned(),
        _ if least == most => format!("{most} arguments"),
        _ => format!("{least} to {most} arguments"),
    }
}
