//! The occurrences in one statement.

use acrc_analysis::{SectionIndex, references, walk};
use acrc_catalog::{CommandId, OperandClass, command};
use acrc_diagnostics::Span;
use acrc_syntax::Tree;
use acrc_syntax::ast::{
    Argument, Axis, BitArgument, Command, Expr, ExprKind, Object, Operand, Statement, StatementKind, Target,
};
use acrc_syntax::lexer::TokenKind;
use acrc_syntax::units::Level;

use super::{Entity, Occurrence, Role};

/// Gathers what occurs in a statement.
pub(super) struct Collector<'a> {
    pub(super) text: &'a str,
    pub(super) tree: &'a Tree,
    pub(super) level: Level,
    pub(super) section: Option<&'a SectionIndex>,
    pub(super) is_alias: &'a dyn Fn(&str) -> bool,
    pub(super) statement: u32,
    pub(super) found: &'a mut Vec<Occurrence>,
}

impl Collector<'_> {
    pub(super) fn statement(&mut self, statement: &Statement) {
        match &statement.kind {
            StatementKind::Remark(_) => self.head(statement, command::REM),
            StatementKind::Label(label) => self.add(label.name, self.label(label.name), Role::Define),
            StatementKind::Assign(assign) => {
                self.expression(&assign.target, Role::Write);
                self.expression(&assign.value, Role::Read);
            }
            StatementKind::If(branch) => {
                self.head(statement, command::IF);
                self.expression(&branch.condition, Role::Read);
                if let Some(then) = branch.then {
                    self.add(then, Entity::Command(command::THEN), Role::Read);
                }
            }
            StatementKind::For(counted) => {
                self.head(statement, command::FOR);
                self.expression(&counted.variable, Role::Write);
                let values = [Some(&counted.start), Some(&counted.end), counted.step.as_ref()];
                self.read(values.into_iter().flatten());
            }
            StatementKind::Print(print) => {
                self.head(statement, command::PRINT);
                let parts = print.device.iter().chain(&print.using);
                self.read(parts.chain(print.items.iter().map(|item| &item.value)));
            }
            StatementKind::Input(input) => {
                self.head(statement, command::INPUT);
                self.read(input.device.iter().chain(input.prompt.iter().map(|(prompt, _)| prompt)));
                for variable in &input.variables {
                    self.expression(variable, Role::Write);
                }
            }
            StatementKind::Dim(dim) => {
                self.add(dim.name, Entity::Command(dim.id), Role::Read);
                self.read(dim.index.iter().chain(&dim.sizes));
            }
            StatementKind::Define(define) => {
                self.head(statement, command::DEFINE);
                self.add(define.name, Entity::Alias(self.slice(define.name).into()), Role::Define);
                self.expression(&define.operand, Role::Read);
            }
            StatementKind::Command(command) => self.command(command),
            StatementKind::Error => {}
        }
    }

    fn command(&mut self, command: &Command) {
        if let Some(prefix) = &command.prefix {
            self.object(prefix, Role::Read);
        }
        self.add(command.name, Entity::Command(command.id), Role::Read);
        for argument in &command.arguments {
            match argument {
                // The name that an axis gets.
                Argument::Value(Expr { kind: ExprKind::String(name), .. }) if command.id == command::ATTACH_SLAVE => {
                    self.add(*name, self.axis_name(*name), Role::Define);
                }
                argument => self.argument(command.id, argument),
            }
        }
    }

    fn argument(&mut self, id: CommandId, argument: &Argument) {
        match argument {
            Argument::Value(value) | Argument::Device(value) => self.expression(value, Role::Read),
            Argument::Tuple(tuple) => self.read(&tuple.values),
            Argument::Axis(axis) => self.axis(id, axis),
            Argument::Object(object) => self.object(object, Role::Read),
            Argument::Bit(bit) => self.bit(id, bit),
            Argument::Word(word) => self.add(word.span, Entity::Word(word.keyword), Role::Read),
            Argument::Interpolation(id, span) => self.add(*span, Entity::Command(*id), Role::Read),
            Argument::Target(target) => self.target(id, *target),
        }
    }

    fn axis(&mut self, id: CommandId, axis: &Axis) {
        let entity = if (self.is_alias)(self.slice(axis.name)) {
            Entity::Alias(self.slice(axis.name).into())
        } else {
            self.axis_name(axis.name)
        };
        self.add(axis.name, entity, Role::Read);
        if let Some(value) = &axis.value {
            self.argument(id, value);
        }
    }

    fn object(&mut self, object: &Object, role: Role) {
        self.add(object.name, Entity::Object { kind: object.kind, number: object.index }, role);
        if let Some(value) = &object.value {
            self.argument(command::AXIS_MOVE, value);
        }
    }

    fn bit(&mut self, id: CommandId, bit: &BitArgument) {
        let role = match references::bit_usage(id, bit.negative) {
            references::Usage::Write => Role::Write,
            _ => Role::Read,
        };
        if !matches!(bit.index.kind, ExprKind::Alias) {
            let number = walk::whole(&bit.index);
            self.add(bit.span, Entity::Operand { class: OperandClass::Bit, number, level: None }, role);
        }
        self.expression(&bit.index, role);
    }

    fn target(&mut self, id: CommandId, target: Target) {
        let role = if id == command::GOSUB { Role::Call } else { Role::Jump };
        match target {
            Target::Label(name) => self.add(name, self.label(name), role),
            Target::Line(number, span) => {
                let entity =
                    if self.is_label(number, span) { self.label(span) } else { Entity::Line(self.level, number) };
                self.add(span, entity, role);
            }
        }
    }

    /// A number is a line number unless only a label of that name exists.
    fn is_label(&self, number: u32, span: Span) -> bool {
        self.section.is_some_and(|section| {
            let is_line = section.lines.binary_search_by_key(&number, |line| line.number).is_ok();
            !is_line && !section.labels_named(self.text, self.slice(span)).is_empty()
        })
    }

    fn read<'t>(&mut self, expressions: impl IntoIterator<Item = &'t Expr>) {
        for expression in expressions {
            self.expression(expression, Role::Read);
        }
    }

    /// What occurs in an expression; `role` is what happens to the expression as a whole.
    fn expression(&mut self, expression: &Expr, role: Role) {
        let outermost = expression.span;
        walk::each(expression, &mut |inner| {
            let role = if inner.span == outermost { role } else { Role::Read };
            match &inner.kind {
                ExprKind::Alias => self.add(inner.span, Entity::Alias(self.slice(inner.span).into()), role),
                ExprKind::Operand(operand) => self.operand(inner.span, operand, role),
                ExprKind::Call(function, _) => {
                    self.add(self.word(inner.span), Entity::Function(*function), Role::Read);
                }
                _ => {}
            }
        });
    }

    fn operand(&mut self, whole: Span, operand: &Operand, role: Role) {
        let span = match &operand.element {
            Some(_) => Span::new(whole.start, operand.index.span.end),
            None => whole,
        };
        let level = operand.class.is_local().then_some(self.level);
        let number = walk::whole(&operand.index);
        self.add(span, Entity::Operand { class: operand.class, number, level }, role);
    }

    /// The word or sign with which a statement begins.
    fn head(&mut self, statement: &Statement, id: CommandId) {
        let tokens = self.tree.tokens_in(statement.span);
        let Some(first) = tokens.first() else { return };
        // `#DEFINE` is two tokens.
        let last = if first.kind == TokenKind::Hash { tokens.get(1).unwrap_or(first) } else { first };
        self.add(Span::new(first.span.start, last.span.end), Entity::Command(id), Role::Read);
    }

    /// The word with which an expression begins, `$` included.
    fn word(&self, span: Span) -> Span {
        let name = self.slice(span).find(|c: char| !c.is_ascii_alphanumeric() && c != '$');
        Span::new(span.start, name.map_or(span.end, |len| span.start + len as u32))
    }

    fn label(&self, name: Span) -> Entity {
        Entity::Label(self.level, self.slice(name).into())
    }

    fn axis_name(&self, name: Span) -> Entity {
        Entity::Axis(self.level, self.slice(name).to_ascii_uppercase().into())
    }

    fn slice(&self, span: Span) -> &str {
        self.text.get(span.range()).unwrap_or_default()
    }

    fn add(&mut self, span: Span, entity: Entity, role: Role) {
        if !span.is_empty() {
            self.found.push(Occurrence { span, entity, role, statement: self.statement });
        }
    }
}
