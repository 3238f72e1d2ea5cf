//! A readable form of a tree, for tests and for whoever debugs one.

use std::fmt::Write;

use acrc_diagnostics::Span;

use crate::Tree;
use crate::ast::{
    Argument, Axis, BitArgument, Command, Dim, Expr, ExprKind, Input, Object, Print, PrintSeparator, Separator,
    StatementKind, Target, Tuple, Word,
};

/// Writes a tree with one line a node, indented by depth. Places are left out: two texts that differ only in blanks,
/// in the case of commands and in typographic characters give the same dump.
#[must_use]
pub fn debug_tree(tree: &Tree, text: &str) -> String {
    let mut dump = Dump { text, out: String::new() };
    for (index, line) in tree.lines().iter().enumerate() {
        let range = line.statements.start as usize..line.statements.end as usize;
        let statements = tree.statements().get(range).unwrap_or_default();
        if statements.is_empty() && line.number.is_none() && line.comment.is_none() {
            continue;
        }
        let number = line.number.map(|number| format!(" number {}", number.value)).unwrap_or_default();
        dump.line(0, format_args!("line {}{number}", index + 1));
        for statement in statements {
            dump.statement(statement.separator, statement.span, &statement.kind);
        }
        if line.comment.is_some() {
            dump.line(1, format_args!("comment"));
        }
    }
    dump.out
}

struct Dump<'t> {
    text: &'t str,
    out: String,
}

impl<'t> Dump<'t> {
    fn line(&mut self, depth: usize, text: std::fmt::Arguments<'_>) {
        // Writing to a string can't fail.
        let _ = writeln!(self.out, "{:indent$}{text}", "", indent = 2 * depth);
    }

    fn slice(&self, span: Span) -> &'t str {
        self.text.get(span.range()).unwrap_or_default()
    }

    fn statement(&mut self, separator: Separator, span: Span, kind: &StatementKind) {
        let before = match separator {
            Separator::Line => "",
            Separator::Colon => ": ",
            Separator::Blank => "+ ",
            Separator::Then => "then ",
        };
        match kind {
            StatementKind::Remark(text) => {
                self.line(1, format_args!("{before}remark {:?}", self.slice(*text).trim()));
            }
            StatementKind::Label(label) => {
                let detached = if label.detached { " detached" } else { "" };
                self.line(1, format_args!("{before}label {}{detached}", self.slice(label.name)));
            }
            StatementKind::Assign(assign) => {
                self.line(1, format_args!("{before}assign"));
                self.part(2, "target", &assign.target);
                self.part(2, "value", &assign.value);
            }
            StatementKind::If(head) => {
                let then = if head.then.is_some() { " then" } else { "" };
                self.line(1, format_args!("{before}if{then}"));
                self.expr(2, "", &head.condition);
            }
            StatementKind::For(head) => {
                self.line(1, format_args!("{before}for"));
                self.part(2, "variable", &head.variable);
                self.part(2, "start", &head.start);
                self.part(2, "end", &head.end);
                if let Some(step) = &head.step {
                    self.part(2, "step", step);
                }
            }
            StatementKind::Print(print) => self.print(before, print),
            StatementKind::Input(input) => self.input(before, input),
            StatementKind::Dim(dim) => self.dim(before, dim),
            StatementKind::Define(define) => {
                self.line(1, format_args!("{before}define {}", self.slice(define.name)));
                self.expr(2, "", &define.operand);
            }
            StatementKind::Command(command) => self.command(before, command),
            StatementKind::Error => self.line(1, format_args!("{before}error {:?}", self.slice(span).trim())),
        }
    }

    fn print(&mut self, before: &str, print: &Print) {
        let form = if print.shorthand { " shorthand" } else { "" };
        self.line(1, format_args!("{before}print{form}"));
        for (name, part) in [("device", &print.device), ("using", &print.using)] {
            if let Some(part) = part {
                self.part(2, name, part);
            }
        }
        for item in &print.items {
            self.expr(2, separator_mark(item.separator), &item.value);
        }
    }

    fn input(&mut self, before: &str, input: &Input) {
        let stay = if input.stay { " stay" } else { "" };
        self.line(1, format_args!("{before}input{stay}"));
        if let Some(device) = &input.device {
            self.part(2, "device", device);
        }
        if let Some((prompt, separator)) = &input.prompt {
            self.expr(2, separator_mark(Some(*separator)), prompt);
        }
        for variable in &input.variables {
            self.expr(2, "", variable);
        }
    }

    fn dim(&mut self, before: &str, dim: &Dim) {
        let bare = if dim.parenthesised || dim.sizes.is_empty() { "" } else { " without parentheses" };
        self.line(1, format_args!("{before}{}{bare}", dim.id.info().name));
        if let Some(index) = &dim.index {
            self.part(2, "index", index);
        }
        for size in &dim.sizes {
            self.expr(2, "", size);
        }
    }

    fn command(&mut self, before: &str, command: &Command) {
        let prefix = command.prefix.as_ref().map(|prefix| format!("{} ", object_name(prefix))).unwrap_or_default();
        self.line(1, format_args!("{before}{prefix}{}", command.id.info().name));
        for argument in &command.arguments {
            self.argument(2, "", argument);
        }
    }

    fn argument(&mut self, depth: usize, mark: &str, argument: &Argument) {
        match argument {
            Argument::Value(value) => self.expr(depth, mark, value),
            Argument::Tuple(Tuple { values, .. }) => {
                self.line(depth, format_args!("{mark}tuple"));
                for value in values {
                    self.expr(depth + 1, "", value);
                }
            }
            Argument::Axis(Axis { name, slash, value, .. }) => {
                self.line(depth, format_args!("{mark}axis {}{}", self.slice(*name), slash_mark(*slash)));
                self.axis_value(depth, value.as_deref());
            }
            Argument::Object(object) => {
                self.line(depth, format_args!("{mark}{}{}", object_name(object), slash_mark(object.slash)));
                self.axis_value(depth, object.value.as_deref());
            }
            Argument::Bit(BitArgument { negative, keyword, index, .. }) => {
                let sign = if *negative { "-" } else { "" };
                let word = if *keyword { " BIT" } else { "" };
                self.expr(depth, &format!("{mark}flag{word} {sign}"), index);
            }
            Argument::Word(Word { keyword, index, .. }) => {
                let index = index.map(|index| index.to_string()).unwrap_or_default();
                self.line(depth, format_args!("{mark}word {}{index}", keyword.name()));
            }
            Argument::Interpolation(id, _) => self.line(depth, format_args!("{mark}then {}", id.info().name)),
            Argument::Target(Target::Label(name)) => {
                self.line(depth, format_args!("{mark}to label {}", self.slice(*name)));
            }
            Argument::Target(Target::Line(number, _)) => self.line(depth, format_args!("{mark}to line {number}")),
            Argument::Device(device) => self.part(depth, "device", device),
        }
    }

    fn axis_value(&mut self, depth: usize, value: Option<&Argument>) {
        if let Some(value) = value {
            self.argument(depth + 1, "", value);
        }
    }

    fn part(&mut self, depth: usize, name: &str, expr: &Expr) {
        self.expr(depth, &format!("{name}: "), expr);
    }

    fn expr(&mut self, depth: usize, mark: &str, expr: &Expr) {
        match &expr.kind {
            ExprKind::Integer(value) => self.line(depth, format_args!("{mark}{value}")),
            ExprKind::Real(value) => self.line(depth, format_args!("{mark}real {value:?}")),
            ExprKind::String(text) => self.line(depth, format_args!("{mark}{:?}", self.slice(*text))),
            ExprKind::Alias => self.line(depth, format_args!("{mark}name {}", self.slice(expr.span))),
            ExprKind::Error => self.line(depth, format_args!("{mark}error")),
            ExprKind::Operand(operand) => {
                let class = operand.class.name();
                match (&operand.index.kind, &operand.element) {
                    (ExprKind::Integer(index), None) => self.line(depth, format_args!("{mark}{class}{index}")),
                    (_, element) => {
                        self.line(depth, format_args!("{mark}{class}"));
                        self.part(depth + 1, "index", &operand.index);
                        if let Some(element) = element {
                            self.part(depth + 1, "element", element);
                        }
                    }
                }
            }
            ExprKind::Paren(inner) => {
                self.line(depth, format_args!("{mark}( )"));
                self.expr(depth + 1, "", inner);
            }
            ExprKind::Unary(operator, operand) => {
                self.line(depth, format_args!("{mark}{}", operator.name()));
                self.expr(depth + 1, "", operand);
            }
            ExprKind::Binary(operator, _, operands) => {
                self.line(depth, format_args!("{mark}{}", operator.name()));
                for operand in operands.iter() {
                    self.expr(depth + 1, "", operand);
                }
            }
            ExprKind::Call(function, arguments) => {
                self.line(depth, format_args!("{mark}{}( )", function.info().name));
                for argument in arguments {
                    self.expr(depth + 1, "", argument);
                }
            }
        }
    }
}

fn object_name(object: &Object) -> String {
    let index = object.index.map(|index| index.to_string()).unwrap_or_default();
    format!("{}{index}", object.kind.name())
}

fn slash_mark(slash: Option<Span>) -> &'static str {
    if slash.is_some() { " /" } else { "" }
}

fn separator_mark(separator: Option<PrintSeparator>) -> &'static str {
    match separator {
        Some(PrintSeparator::Comma) => "item, ",
        Some(PrintSeparator::Semicolon) => "item; ",
        None => "item ",
    }
}
