//! Repairs as text edits, and their application.

use thiserror::Error;

use crate::Span;

/// The replacement of one range of text; an empty span inserts, an empty text deletes.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Edit {
    /// What is replaced.
    pub span: Span,
    /// What stands there afterwards.
    pub text: String,
}

impl Edit {
    /// Replaces the text in `span`.
    #[must_use]
    pub fn replace(span: Span, text: impl Into<String>) -> Self {
        Self { span, text: text.into() }
    }

    /// Inserts before the byte at `offset`.
    #[must_use]
    pub fn insert(offset: u32, text: impl Into<String>) -> Self {
        Self::replace(Span::empty(offset), text)
    }

    /// Removes the text in `span`.
    #[must_use]
    pub fn delete(span: Span) -> Self {
        Self::replace(span, "")
    }
}

/// Whether a fix may be applied without a person looking at it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Applicability {
    /// The program means the same afterwards, or what it meant could not run.
    Safe,
    /// The program may behave differently: applied only when asked for by name.
    Unsafe,
    /// A suggestion with parts to fill in: shown, never applied.
    DisplayOnly,
}

impl Applicability {
    /// The word used in every output: `safe`, `unsafe`, `display-only`.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Safe => "safe",
            Self::Unsafe => "unsafe",
            Self::DisplayOnly => "display-only",
        }
    }
}

/// One way to repair a finding: edits that belong together.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Fix {
    /// What it does, as an order: "replace the typographic quotes".
    pub title: String,
    /// The edits, in any order; they must not overlap.
    pub edits: Vec<Edit>,
    /// Whether it may be applied unseen.
    pub applicability: Applicability,
}

impl Fix {
    /// A fix with these edits.
    #[must_use]
    pub fn new(applicability: Applicability, title: impl Into<String>, edits: Vec<Edit>) -> Self {
        Self { title: title.into(), edits, applicability }
    }

    /// A fix that may be applied unseen.
    #[must_use]
    pub fn safe(title: impl Into<String>, edits: Vec<Edit>) -> Self {
        Self::new(Applicability::Safe, title, edits)
    }

    /// A fix that may change what the program does.
    #[must_use]
    pub fn unsafe_(title: impl Into<String>, edits: Vec<Edit>) -> Self {
        Self::new(Applicability::Unsafe, title, edits)
    }
}

/// Why a set of fixes could not be applied; the text is left as it was.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum ApplyError {
    /// Two edits change the same bytes, or insert at the same place, so that their order would matter.
    #[error(
        "edits overlap: bytes {}..{} and {}..{}",
        first.start, first.end, second.start, second.end
    )]
    Overlapping {
        /// The edit that begins first.
        first: Span,
        /// The edit that begins inside it.
        second: Span,
    },
    /// An edit reaches beyond the text, or begins or ends inside a character.
    #[error("edit of bytes {}..{} does not fit a text of {len} bytes", span.start, span.end)]
    OutsideText {
        /// The edit.
        span: Span,
        /// Length of the text in bytes.
        len: usize,
    },
}

/// Applies every edit of `fixes` to `text`. Offsets in the edits refer to `text` as given. Edits that overlap are
/// refused, also within one fix; so are two insertions at one place. An edit that occurs in several fixes is refused
/// like any other overlap: see [`compatible`] for a choice that can be applied together.
pub fn apply(text: &str, fixes: &[&Fix]) -> Result<String, ApplyError> {
    let edits = sorted_edits(fixes.iter().flat_map(|fix| &fix.edits));
    if let Some((first, second)) = first_overlap(&edits) {
        return Err(ApplyError::Overlapping { first: first.span, second: second.span });
    }

    let mut out = String::with_capacity(text.len());
    let mut copied = 0;
    for edit in edits {
        let outside = ApplyError::OutsideText { span: edit.span, len: text.len() };
        let range = edit.span.range();
        if text.get(range.clone()).is_none() {
            return Err(outside);
        }
        out.push_str(text.get(copied..range.start).ok_or(outside)?);
        out.push_str(&edit.text);
        copied = range.end;
    }
    out.push_str(text.get(copied..).unwrap_or_default());
    Ok(out)
}

/// The fixes of `fixes` that can be applied together, taken greedily in the order given. The rest needs another look
/// at the changed text.
#[must_use]
pub fn compatible<'a>(fixes: &[&'a Fix]) -> Vec<&'a Fix> {
    let mut chosen: Vec<&Fix> = Vec::new();
    let mut taken: Vec<&Edit> = Vec::new();
    for &fix in fixes {
        let edits = sorted_edits(taken.iter().copied().chain(&fix.edits));
        if first_overlap(&edits).is_none() {
            chosen.push(fix);
            taken = edits;
        }
    }
    chosen
}

fn sorted_edits<'a>(edits: impl Iterator<Item = &'a Edit>) -> Vec<&'a Edit> {
    let mut edits: Vec<&Edit> = edits.collect();
    edits.sort_by_key(|edit| edit.span);
    edits
}

/// The first pair of neighbours, in order of their spans, that can't both be applied.
fn first_overlap<'a>(edits: &[&'a Edit]) -> Option<(&'a Edit, &'a Edit)> {
    edits
        .iter()
        .zip(edits.iter().skip(1))
        .map(|(a, b)| (*a, *b))
        .find(|(a, b)| b.span.start < a.span.end || (a.span == b.span && a.span.is_empty()))
}
