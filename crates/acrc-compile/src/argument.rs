//! Arguments of commands to items.

use acrc_catalog::OperandClass;
use acrc_diagnostics::Span;
use acrc_image::{Node, negate};
use acrc_syntax::ast::{Argument, Axis, BitArgument, Object, Target};

use crate::encoder::Encoder;
use crate::error::{CompileErrorKind, LINE_NUMBERS};

impl Encoder<'_> {
    /// One argument.
    pub(crate) fn argument(&mut self, argument: &Argument) -> Node {
        match argument {
            Argument::Value(expr) => self.expression(expr),
            Argument::Tuple(tuple) => Node::Tuple(tuple.values.iter().map(|value| self.expression(value)).collect()),
            Argument::Axis(axis) => self.axis(axis),
            Argument::Object(object) => self.object(object, false),
            Argument::Bit(bit) => self.bit(bit),
            Argument::Word(word) => Node::Word { keyword: word.keyword, index: self.number(word.span, word.index) },
            Argument::Interpolation(command, _) => Node::Interpolation(*command),
            Argument::Target(target) => self.target(*target),
            Argument::Device(expr) => self.device(expr),
        }
    }

    /// `#1`
    pub(crate) fn device(&mut self, number: &acrc_syntax::ast::Expr) -> Node {
        Node::Device(Box::new(self.expression(number)))
    }

    /// `AXIS0` before a command or as an argument.
    pub(crate) fn object(&mut self, object: &Object, prefix: bool) -> Node {
        let index = self.number(object.name, object.index);
        let value = self.value(object.span, object.value.as_deref());
        Node::Object { kind: object.kind, index, slash: object.slash.is_some(), prefix, value }
    }

    fn axis(&mut self, axis: &Axis) -> Node {
        let name = self.slice(axis.name);
        match name.parse() {
            Ok(name) => {
                Node::Axis { name, slash: axis.slash.is_some(), value: self.value(axis.span, axis.value.as_deref()) }
            }
            Err(_) => self.mistake(axis.name, CompileErrorKind::AxisName(name.to_owned())),
        }
    }

    fn value(&mut self, span: Span, value: Option<&Argument>) -> Option<Box<Node>> {
        let value = value?;
        let node = self.nested(span, |encoder| encoder.argument(value));
        Some(Box::new(node))
    }

    /// A flag: its number alone where that is a constant, `BIT` with an expression, or an alias. A minus sign is part of the number.
    fn bit(&mut self, bit: &BitArgument) -> Node {
        let index = if bit.keyword { self.unwrapped(&bit.index) } else { self.expression(&bit.index) };
        let flag = if bit.keyword && !index.is_constant() {
            Node::Scalar { class: OperandClass::Bit, index: Box::new(index), parens: 0 }
        } else {
            index
        };
        if bit.negative { negate(flag) } else { flag }
    }

    fn target(&mut self, target: Target) -> Node {
        match target {
            Target::Label(span) => {
                let name = self.slice(span);
                match self.scope.label(name) {
                    Some(ordinal) => Node::LabelRef(ordinal),
                    None => self.mistake(span, CompileErrorKind::UndefinedLabel(name.to_owned())),
                }
            }
            Target::Line(number, span) => self.line_number(number, span),
        }
    }

    /// A line number.
    pub(crate) fn line_number(&mut self, number: u32, span: Span) -> Node {
        match i32::try_from(number) {
            Ok(number) => Node::Long(number),
            Err(_) => self.too_large(span, LINE_NUMBERS),
        }
    }
}
