//! What each word of a text is, for colouring that knows aliases, axes and labels.

use std::iter::Peekable;

use acrc_analysis::query::parse;
use acrc_analysis::{Db, Project, SourceFile};
use acrc_catalog::OperandClass;
use acrc_diagnostics::Span;
use acrc_syntax::lexer::{Token, TokenKind};

use crate::occurrence::in_span;
use crate::{Entity, Occurrence, Role};

/// The command group whose words steer a program.
const FLOW: &str = "Program Flow";

/// The classes of words.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TokenClass {
    /// A command, or the first words of one with daughters.
    Command,
    /// A word that only the command before it gives its meaning: `VEL` of `JOG VEL`.
    Daughter,
    /// A word that steers a program, is only part of a statement, or is an operator: `IF`, `TO`, `AND`.
    Keyword,
    /// An object by number: `ENC0`.
    Object,
    /// The name of an axis.
    Axis,
    /// An alias.
    Alias,
    /// A label, a line number.
    Label,
    /// A parameter.
    Parameter,
    /// A flag.
    Bit,
    /// A local variable or array.
    Variable,
    /// A function.
    Function,
    /// A number.
    Number,
    /// A text between quotes.
    String,
    /// A remark.
    Comment,
    /// A sign that computes or compares.
    Operator,
}

/// A word with its class.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SemanticToken {
    /// Where it stands; on one line.
    pub span: Span,
    /// What it is.
    pub class: TokenClass,
    /// It is declared here.
    pub declaration: bool,
    /// It gets another value here.
    pub modification: bool,
    /// The language defines it.
    pub builtin: bool,
}

/// The words of a part of a file, in the order of the text and disjoint. Without a part, of the whole file. Punctuation
/// and what could not be read are left out.
pub fn semantic_tokens(db: &dyn Db, project: Project, file: SourceFile, part: Option<Span>) -> Vec<SemanticToken> {
    let part = part.unwrap_or_else(|| Span::new(0, file.text(db).len() as u32));
    let occurrences = in_span(db, project, file, part);
    let tokens = parse(db, file).tokens_in(part);
    let mut painter = Painter { occurrences: occurrences.into_iter().peekable(), open: Vec::new(), out: Vec::new() };
    for token in tokens {
        painter.token(file.text(db), token);
    }
    painter.out
}

/// Goes over tokens and occurrences side by side.
struct Painter<I: Iterator<Item = Occurrence>> {
    occurrences: Peekable<I>,
    /// Those that have begun, the innermost last.
    open: Vec<Occurrence>,
    out: Vec<SemanticToken>,
}

impl<I: Iterator<Item = Occurrence>> Painter<I> {
    fn token(&mut self, text: &str, token: &Token) {
        self.advance(token.span.start);
        let plain = |class| SemanticToken {
            span: token.span,
            class,
            declaration: false,
            modification: false,
            builtin: matches!(class, TokenClass::Keyword | TokenClass::Operator),
        };
        let inner = self.open.last().filter(|occurrence| token.span.end <= occurrence.span.end);
        let new = match token.kind {
            TokenKind::Comment | TokenKind::RemarkText => plain(TokenClass::Comment),
            TokenKind::String => plain(TokenClass::String),
            TokenKind::Word | TokenKind::Dollar | TokenKind::Hash | TokenKind::Question => {
                match inner.filter(|occurrence| names(occurrence, token)) {
                    Some(occurrence) => painted(occurrence, token.span),
                    None if token.kind == TokenKind::Word => match word(text, token.span) {
                        Some(class) => plain(class),
                        None => return,
                    },
                    None => return,
                }
            }
            TokenKind::Integer | TokenKind::Real => match inner.filter(|occurrence| self.numbers(occurrence, token)) {
                Some(occurrence) => painted(occurrence, token.span),
                None => plain(TokenClass::Number),
            },
            kind if is_operator(kind) => plain(TokenClass::Operator),
            _ => return,
        };
        self.push(new);
    }

    /// Opens what begins before or at an offset and closes what has ended.
    fn advance(&mut self, offset: u32) {
        while let Some(next) = self.occurrences.next_if(|next| next.span.start <= offset) {
            self.open.retain(|open| open.span.end > next.span.start);
            self.open.push(next);
        }
        self.open.retain(|open| open.span.end > offset);
    }

    /// Whether a number is that of the thing around it: glued to its word, or standing for it alone.
    fn numbers(&self, occurrence: &Occurrence, token: &Token) -> bool {
        let glued = self.out.last().is_some_and(|last| last.span.end == token.span.start);
        let begins = occurrence.span.start == token.span.start;
        match occurrence.entity {
            Entity::Operand { number: Some(_), .. } => {
                begins || glued && self.out.last().is_some_and(|last| last.span.start == occurrence.span.start)
            }
            Entity::Line(..) => begins,
            // Names hold digits.
            Entity::Object { .. } | Entity::Alias(_) | Entity::Label(..) | Entity::Axis(..) | Entity::Word(_) => true,
            _ => false,
        }
    }

    /// Adds a token, or makes the last one longer when both are parts of one name.
    fn push(&mut self, new: SemanticToken) {
        let is_name = !matches!(
            new.class,
            TokenClass::Number | TokenClass::Operator | TokenClass::Keyword | TokenClass::String | TokenClass::Comment
        );
        match self.out.last_mut() {
            Some(last)
                if is_name && last.span.end == new.span.start && SemanticToken { span: last.span, ..new } == *last =>
            {
                last.span = Span::cover(last.span, new.span);
            }
            _ => self.out.push(new),
        }
    }
}

/// Whether a word is part of the name of what stands around it, not of what stands within that.
fn names(occurrence: &Occurrence, token: &Token) -> bool {
    match occurrence.entity {
        Entity::Operand { .. } | Entity::Function(_) => token.span.start == occurrence.span.start,
        _ => true,
    }
}

fn painted(occurrence: &Occurrence, span: Span) -> SemanticToken {
    let class = match &occurrence.entity {
        Entity::Command(id) if id.info().group == FLOW => TokenClass::Keyword,
        // `#DEFINE` is two tokens and one word.
        Entity::Command(id) if span.start != occurrence.span.start && id.info().parent.is_some() => {
            TokenClass::Daughter
        }
        Entity::Command(_) => TokenClass::Command,
        Entity::Function(_) => TokenClass::Function,
        Entity::Word(_) => TokenClass::Keyword,
        Entity::Object { .. } => TokenClass::Object,
        Entity::Operand { class: OperandClass::Parameter, .. } => TokenClass::Parameter,
        Entity::Operand { class: OperandClass::Bit, .. } => TokenClass::Bit,
        Entity::Operand { .. } => TokenClass::Variable,
        Entity::Alias(_) => TokenClass::Alias,
        Entity::Axis(..) => TokenClass::Axis,
        Entity::Label(..) | Entity::Line(..) => TokenClass::Label,
    };
    SemanticToken {
        span,
        class,
        declaration: occurrence.role == Role::Define,
        modification: occurrence.role == Role::Write,
        builtin: matches!(
            occurrence.entity,
            Entity::Command(_) | Entity::Function(_) | Entity::Word(_) | Entity::Object { .. }
        ),
    }
}

/// What a word is that no name reaches: an operator, a part of a statement. What could not be read is nothing.
fn word(text: &str, span: Span) -> Option<TokenClass> {
    let word = acrc_catalog::word(text.get(span.range())?)?;
    (word.operator.is_some() || word.unary.is_some() || word.keyword.is_some()).then_some(TokenClass::Keyword)
}

const fn is_operator(kind: TokenKind) -> bool {
    use TokenKind::{
        Caret, Dash, Equal, Greater, GreaterEqual, Less, LessEqual, Minus, NotEqual, Plus, ShiftLeft, ShiftRight,
        Slash, Star, StarStar,
    };
    matches!(
        kind,
        Plus | Minus
            | Dash
            | Star
            | StarStar
            | Caret
            | Slash
            | Equal
            | NotEqual
            | Less
            | LessEqual
            | Greater
            | GreaterEqual
            | ShiftLeft
            | ShiftRight
    )
}
