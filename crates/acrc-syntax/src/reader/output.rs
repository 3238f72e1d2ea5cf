//! Character input and output (guide, "Character I/O").

use acrc_catalog::Keyword;

use super::{Read, Reader};
use crate::ast::{Argument, Expr, Input, Print, PrintItem, PrintSeparator, StatementKind};
use crate::lexer::TokenKind;

impl Reader<'_> {
    /// `PRINT` and `?`; the word is taken.
    pub(super) fn print(&mut self, shorthand: bool) -> Read<StatementKind> {
        let device = self.device()?;
        if device.is_some() {
            self.separator_or_end("`,`")?;
        }
        let using = match self.accept_word(Keyword::Using.name()) {
            Some(_) => Some(self.full_expression()?),
            None => None,
        };
        if using.is_some() {
            self.separator_or_end("`;`")?;
        }
        let items = self.print_items()?;
        Ok(StatementKind::Print(Box::new(Print { shorthand, device, using, items })))
    }

    fn separator_or_end(&mut self, wanted: &str) -> Read<()> {
        if self.item_separator().is_none() && !self.peek().kind.ends_statement() {
            return Err(self.expected(wanted));
        }
        Ok(())
    }

    fn print_items(&mut self) -> Read<Vec<PrintItem>> {
        self.wanted = ("a value", None);
        let mut items = Vec::new();
        while self.starts_value() {
            let value = self.full_expression()?;
            let separator = self.item_separator();
            items.push(PrintItem { value, separator });
            if separator.is_none() {
                self.wanted.0 = "`,`, `;` or the end of the statement";
                if self.is_certain_value() {
                    return Err(self.expected(self.wanted.0));
                }
                break;
            }
        }
        Ok(items)
    }

    /// Whether the next word is an item that lacks its separator, and no statement of its own.
    fn is_certain_value(&self) -> bool {
        let token = self.peek();
        match token.kind {
            TokenKind::Word | TokenKind::Dollar => {
                self.is_operand_or_function(token, self.word(token)) && !self.assignment_ahead()
            }
            _ => false,
        }
    }

    fn item_separator(&mut self) -> Option<PrintSeparator> {
        let separator = match self.peek().kind {
            TokenKind::Comma => PrintSeparator::Comma,
            TokenKind::Semicolon => PrintSeparator::Semicolon,
            _ => return None,
        };
        self.bump();
        Some(separator)
    }

    /// `#1`
    pub(super) fn device(&mut self) -> Read<Option<Expr>> {
        if self.peek().kind != TokenKind::Hash || self.is_word(self.peek_at(1), "DEFINE") {
            return Ok(None);
        }
        self.bump();
        self.value().map(Some)
    }

    /// `INPUT; #1, "prompt"; $V0, P1`; the word `INPUT` is taken.
    pub(super) fn input(&mut self) -> Read<StatementKind> {
        let stay = self.accept(TokenKind::Semicolon).is_some();
        let device = self.device()?;
        if device.is_some() && self.accept(TokenKind::Comma).is_none() {
            return Err(self.expected("`,`"));
        }
        let prompt = if self.peek().kind == TokenKind::String {
            let text = self.value()?;
            let Some(separator) = self.item_separator() else { return Err(self.expected("`;` or `,`")) };
            Some((text, separator))
        } else {
            None
        };
        let mut variables = vec![self.value()?];
        while self.accept(TokenKind::Comma).is_some() {
            variables.push(self.value()?);
        }
        self.wanted.0 = "`,` or the end of the statement";
        Ok(StatementKind::Input(Box::new(Input { stay, device, prompt, variables })))
    }

    /// `"COM1:9600,n,8,1" AS #1`, behind `OPEN` and `OPEN DTALK`
    pub(super) fn open(&mut self) -> Read<Vec<Argument>> {
        let text = self.full_expression()?;
        if self.accept_word(Keyword::As.name()).is_none() {
            return Err(self.expected("`AS`"));
        }
        let Some(device) = self.device()? else { return Err(self.expected("`#`")) };
        self.wanted.1 = None;
        Ok(vec![Argument::Value(text), Argument::Device(device)])
    }

    /// `#1` behind `CLOSE`
    pub(super) fn close_device(&mut self) -> Read<Vec<Argument>> {
        let device = self.device()?;
        if device.is_some() {
            self.wanted.1 = None;
        } else {
            self.wanted.0 = "`#`";
        }
        Ok(device.map(Argument::Device).into_iter().collect())
    }
}
