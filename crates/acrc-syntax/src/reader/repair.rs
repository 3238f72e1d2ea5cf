//! Tokens as the reader understood them.

use std::ops::Range;

use acrc_diagnostics::Span;

use crate::lexer::{Token, TokenKind};

/// Puts what the reader found out about single tokens into the list: words that it cut in two, and the text of remarks
/// whose `REM` stands where the lexer does not look for one.
pub(super) fn tokens(tokens: Vec<Token>, cuts: &[(usize, u32)], remarks: &[(Range<usize>, Span)]) -> Vec<Token> {
    if cuts.is_empty() && remarks.is_empty() {
        return tokens;
    }
    let mut out = Vec::with_capacity(tokens.len() + cuts.len());
    let mut cuts = cuts.iter().peekable();
    let mut remarks = remarks.iter().peekable();
    for (index, token) in tokens.into_iter().enumerate() {
        if let Some((range, _)) = remarks.peek()
            && index >= range.end
        {
            remarks.next();
        }
        if let Some((range, text)) = remarks.peek()
            && range.contains(&index)
        {
            if index == range.start {
                out.push(Token { kind: TokenKind::RemarkText, span: *text });
            }
            continue;
        }
        match cuts.next_if(|(position, _)| *position == index) {
            Some(&(_, middle)) => {
                out.push(Token { kind: token.kind, span: Span::new(token.span.start, middle) });
                out.push(Token { kind: token.kind, span: Span::new(middle, token.span.end) });
            }
            None => out.push(token),
        }
    }
    out
}
