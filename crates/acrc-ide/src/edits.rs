//! What the edits of several features have in common.

use acrc_analysis::SourceFile;
use acrc_diagnostics::{Edit, Span};
use acrc_syntax::Tree;

use crate::place::line_at;

/// Edits of one file, in the order of the text.
pub type FileEdits = (SourceFile, Vec<Edit>);

/// A name in place of what stands at `span`, set off by blanks where it would grow together with its neighbours. A number
/// may touch the words around it, a name may not: `SET32`.
pub(crate) fn spaced(text: &str, span: Span, name: &str) -> String {
    let touches = |c: Option<char>| c.is_some_and(|c| c.is_ascii_alphanumeric() || c == '_');
    let before = touches(text.get(..span.start as usize).and_then(|text| text.chars().next_back()));
    let behind = touches(text.get(span.end as usize..).and_then(|text| text.chars().next()));
    format!("{}{name}{}", if before { " " } else { "" }, if behind { " " } else { "" })
}

/// The line break at the end of the line on which an offset stands, or the first of the text, or LF.
pub(crate) fn line_break<'t>(text: &'t str, tree: &Tree, offset: u32) -> &'t str {
    let line = line_at(tree, offset);
    let pair = tree.lines().get(line..).and_then(|lines| Some((lines.first()?.span.end, lines.get(1)?.span.start)));
    let first = || Some((tree.lines().first()?.span.end, tree.lines().get(1)?.span.start));
    let span = pair.or_else(first).map(|(end, start)| Span::new(end, start));
    span.and_then(|span| text.get(span.range())).filter(|text| !text.is_empty()).unwrap_or("\n")
}

/// The blanks at the start of the line on which an offset stands.
pub(crate) fn indent_at<'t>(text: &'t str, tree: &Tree, offset: u32) -> &'t str {
    let line = tree.lines().get(line_at(tree, offset)).map_or("", |line| crate::place::slice(text, line.span));
    line.get(..line.len() - line.trim_start_matches([' ', '\t']).len()).unwrap_or_default()
}

/// The edits that make one text another, by lines.
pub(crate) fn line_edits(before: &str, after: &str) -> Vec<Edit> {
    let (old, new): (Vec<&str>, Vec<&str>) =
        (before.split_inclusive('\n').collect(), after.split_inclusive('\n').collect());
    let mut edits = Vec::new();
    let place = |lines: &[&str]| lines.iter().map(|line| line.len() as u32).sum::<u32>();
    let mut known = (0, 0);
    for op in similar::capture_diff_slices(similar::Algorithm::Myers, &old, &new) {
        let (tag, gone, come) = op.as_tag_tuple();
        if tag == similar::DiffTag::Equal {
            continue;
        }
        let start = known.1 + place(old.get(known.0..gone.start).unwrap_or_default());
        let end = start + place(old.get(gone.clone()).unwrap_or_default());
        known = (gone.end, end);
        edits.push(Edit::replace(Span::new(start, end), new.get(come).unwrap_or_default().concat()));
    }
    edits
}
