//! What a rule is: its documentation and its checks.

use std::fmt::Write as _;

use acrc_diagnostics::{Code, Diagnostic, Severity, Span};
use acrc_syntax::ast::{Expr, ExprKind, Statement};

use acrc_analysis::SectionIndex;

use crate::Context;
use crate::references::Reference;

/// The documentation of a rule: what `acrc explain` prints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RuleDoc {
    /// Its stable code and name.
    pub code: Code,
    /// The group that it belongs to.
    pub group: Group,
    /// The severity that its findings have unless one says otherwise.
    pub severity: Severity,
    /// It is on unless the configuration turns it off; otherwise it is off unless the configuration selects it.
    pub enabled: bool,
    /// How an editor shows what it finds, beside the severity.
    pub mark: Option<Mark>,
    /// What it finds.
    pub what: &'static str,
    /// Why that matters on a machine.
    pub why: &'static str,
    /// A program that it complains about.
    pub bad: &'static str,
    /// The same program, repaired.
    pub good: &'static str,
    /// The section of the programmer's guide, or the reason why there is none.
    pub guide: &'static str,
}

/// What a finding says of the text itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// It could be left out and nothing would change: editors show it faded.
    Unnecessary,
    /// It is read, and every document writes it otherwise: editors strike it through.
    Deprecated,
}

/// Groups of rules by what they look at.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Group {
    /// Whether the text can be read: `ACR0xx`.
    Syntax,
    /// Whether a program fits the stored form: `ACR02x`.
    Compile,
    /// Labels, blocks, the way through a program: `ACR1xx`.
    Flow,
    /// Names and arguments: `ACR2xx`.
    Names,
    /// Parameters and bits: `ACR3xx`.
    Parameters,
    /// Whether programs, variables and aliases fit their memory: `ACR4xx`.
    Memory,
    /// Attachments, motion, limits: `ACR5xx`.
    Motion,
    /// What works, and could be clearer or cheaper: `ACR6xx`.
    Style,
    /// Comments that suppress findings: `ACR9xx`.
    Suppressions,
}

impl Group {
    /// All groups, in the order of their codes.
    pub const ALL: [Self; 9] = [
        Self::Syntax,
        Self::Compile,
        Self::Flow,
        Self::Names,
        Self::Parameters,
        Self::Memory,
        Self::Motion,
        Self::Style,
        Self::Suppressions,
    ];

    /// The word used in lists.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Syntax => "syntax",
            Self::Compile => "compile",
            Self::Flow => "flow",
            Self::Names => "names",
            Self::Parameters => "parameters",
            Self::Memory => "memory",
            Self::Motion => "motion",
            Self::Style => "style",
            Self::Suppressions => "suppressions",
        }
    }
}

/// Where in the one pass over a file a rule is asked.
#[derive(Clone, Copy)]
pub(crate) enum Check {
    /// Once a file.
    File(fn(&mut Context<'_>)),
    /// Once a section.
    Section(fn(&mut Context<'_>, &SectionIndex)),
    /// At each statement.
    Statement(fn(&mut Context<'_>, &Statement)),
    /// At each expression of some kind, the inner ones included.
    Expression(On, fn(&mut Context<'_>, &Expr)),
    /// At each parameter, bit and variable whose number is known, however it is written.
    Reference(fn(&mut Context<'_>, &Reference)),
}

/// The kinds of expressions, as rules ask for them.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum On {
    /// Numbers, and signs before something.
    Number,
    /// Parameters, bits, variables.
    Operand,
    /// Names.
    Alias,
    /// Functions and operators with two sides.
    Compound,
    /// Texts.
    Text,
}

impl On {
    /// How many kinds there are.
    pub(crate) const COUNT: usize = Self::Text as usize + 1;

    /// The kind of an expression. Parentheses and what could not be read are nobody's business.
    pub(crate) fn of(expr: &Expr) -> Option<Self> {
        match expr.kind {
            ExprKind::Integer(_) | ExprKind::Real(_) | ExprKind::Unary(..) => Some(Self::Number),
            ExprKind::Operand(_) => Some(Self::Operand),
            ExprKind::Alias => Some(Self::Alias),
            ExprKind::Binary(..) | ExprKind::Call(..) => Some(Self::Compound),
            ExprKind::String(_) => Some(Self::Text),
            ExprKind::Paren(_) | ExprKind::Error => None,
        }
    }
}

/// A rule of the registry.
pub(crate) struct Rule {
    pub(crate) doc: RuleDoc,
    /// Its checks; none when the parser or the compiler reports it.
    pub(crate) checks: &'static [Check],
}

impl Rule {
    /// A finding of this rule at its default severity.
    pub(crate) fn at(&self, span: Span, message: impl Into<String>) -> Diagnostic {
        Diagnostic::new(self.doc.severity, self.doc.code, span, message)
    }
}

impl RuleDoc {
    /// The page as text, ending in a line break.
    pub fn render(&self) -> String {
        let mut page = String::new();
        let Self { code, group, severity, enabled, mark: _, what, why, bad, good, guide } = self;
        let off = if *enabled { "" } else { ", off unless selected" };
        // Writing to a string does not fail.
        let _ = writeln!(
            page,
            "{} {} ({severity}, {}{off})\n\n{what}\n\nWhy it matters\n{why}\n",
            code.id,
            code.name,
            group.as_str()
        );
        for (title, program) in [("Bad", bad), ("Good", good)] {
            let _ = writeln!(page, "{title}");
            for line in program.lines() {
                let _ = writeln!(page, "{}", format!("    {line}").trim_end());
            }
            page.push('\n');
        }
        let _ = writeln!(page, "Guide: {guide}");
        page
    }
}
