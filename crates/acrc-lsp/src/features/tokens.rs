//! The classes of words, for colouring: of a whole file, of a part, or what changed.

use std::collections::BTreeMap;
use std::sync::Arc;

use acrc_diagnostics::Span;
use acrc_ide::TokenClass;
use camino::Utf8PathBuf;
use parking_lot::Mutex;
use tower_lsp_server::ls_types::{
    SemanticToken, SemanticTokenModifier, SemanticTokenType, SemanticTokens, SemanticTokensDelta,
    SemanticTokensDeltaParams, SemanticTokensEdit, SemanticTokensFullDeltaResult, SemanticTokensLegend,
    SemanticTokensParams, SemanticTokensRangeParams, SemanticTokensRangeResult, SemanticTokensResult, Uri,
};

use super::Answer;
use crate::snapshot::{Place, Snapshot};

/// The classes with the types of the protocol that editors have colours for.
const TYPES: [(TokenClass, SemanticTokenType); 15] = [
    (TokenClass::Command, SemanticTokenType::KEYWORD),
    (TokenClass::Daughter, SemanticTokenType::MODIFIER),
    (TokenClass::Keyword, SemanticTokenType::TYPE),
    (TokenClass::Object, SemanticTokenType::CLASS),
    (TokenClass::Axis, SemanticTokenType::PARAMETER),
    (TokenClass::Alias, SemanticTokenType::MACRO),
    (TokenClass::Label, SemanticTokenType::METHOD),
    (TokenClass::Parameter, SemanticTokenType::PROPERTY),
    (TokenClass::Bit, SemanticTokenType::ENUM_MEMBER),
    (TokenClass::Variable, SemanticTokenType::VARIABLE),
    (TokenClass::Function, SemanticTokenType::FUNCTION),
    (TokenClass::Number, SemanticTokenType::NUMBER),
    (TokenClass::String, SemanticTokenType::STRING),
    (TokenClass::Comment, SemanticTokenType::COMMENT),
    (TokenClass::Operator, SemanticTokenType::OPERATOR),
];

const MODIFIERS: [SemanticTokenModifier; 3] =
    [SemanticTokenModifier::DECLARATION, SemanticTokenModifier::MODIFICATION, SemanticTokenModifier::DEFAULT_LIBRARY];

/// What the numbers in the answers mean.
pub(crate) fn legend() -> SemanticTokensLegend {
    SemanticTokensLegend {
        token_types: TYPES.iter().map(|(_, kind)| kind.clone()).collect(),
        token_modifiers: MODIFIERS.to_vec(),
    }
}

/// What the client has of each open document.
#[derive(Clone, Default)]
pub(crate) struct Tokens(Arc<Mutex<Known>>);

#[derive(Default)]
struct Known {
    count: u64,
    by_path: BTreeMap<Utf8PathBuf, (String, Vec<SemanticToken>)>,
}

impl Tokens {
    pub(crate) fn full(&self, snapshot: &Snapshot, params: &SemanticTokensParams) -> Answer<SemanticTokensResult> {
        let place = snapshot.place(&params.text_document.uri)?;
        let data = tokens(snapshot, place, None);
        let result_id = self.remember(snapshot, place, data.clone());
        Some(SemanticTokensResult::Tokens(SemanticTokens { result_id, data }))
    }

    pub(crate) fn delta(
        &self,
        snapshot: &Snapshot,
        params: &SemanticTokensDeltaParams,
    ) -> Answer<SemanticTokensFullDeltaResult> {
        let place = snapshot.place(&params.text_document.uri)?;
        let data = tokens(snapshot, place, None);
        let known = snapshot.path(place.file).and_then(|path| self.0.lock().by_path.get(path).cloned());
        let before = known.filter(|(id, _)| *id == params.previous_result_id).map(|(_, tokens)| tokens);
        let result_id = self.remember(snapshot, place, data.clone());
        Some(match before {
            Some(before) => {
                let edits = difference(&before, data);
                SemanticTokensFullDeltaResult::TokensDelta(SemanticTokensDelta { result_id, edits })
            }
            None => SemanticTokensFullDeltaResult::Tokens(SemanticTokens { result_id, data }),
        })
    }

    /// Keeps what the client gets, while the document is open.
    fn remember(&self, snapshot: &Snapshot, place: Place, data: Vec<SemanticToken>) -> Option<String> {
        let path = snapshot.path(place.file)?.to_owned();
        let mut known = self.0.lock();
        known.by_path.retain(|path, _| snapshot.documents.by_path.contains_key(path));
        if !snapshot.documents.by_path.contains_key(&path) {
            return None;
        }
        known.count += 1;
        let id = known.count.to_string();
        known.by_path.insert(path, (id.clone(), data));
        Some(id)
    }
}

pub(crate) fn range(snapshot: &Snapshot, params: &SemanticTokensRangeParams) -> Answer<SemanticTokensRangeResult> {
    let uri: &Uri = &params.text_document.uri;
    let place = snapshot.place(uri)?;
    let part = snapshot.lines(place.file).span(params.range)?;
    let data = tokens(snapshot, place, Some(part));
    Some(SemanticTokensRangeResult::Tokens(SemanticTokens { result_id: None, data }))
}

fn tokens(snapshot: &Snapshot, place: Place, part: Option<Span>) -> Vec<SemanticToken> {
    let lines = snapshot.lines(place.file);
    let found = acrc_ide::semantic_tokens(&snapshot.db, place.project, place.file, part);
    let mut data = Vec::with_capacity(found.len());
    let (mut line, mut column) = (0, 0);
    for token in found {
        let token_type = TYPES.iter().position(|(class, _)| *class == token.class).unwrap_or_default() as u32;
        let flags = [token.declaration, token.modification, token.builtin];
        let token_modifiers_bitset = flags.iter().rev().fold(0, |bits, flag| bits << 1 | u32::from(*flag));
        for part in lines.split(token.span) {
            let start = lines.position(part.start);
            let delta_line = start.line - line;
            let delta_start = if delta_line == 0 { start.character - column } else { start.character };
            (line, column) = (start.line, start.character);
            let length = lines.units(part);
            data.push(SemanticToken { delta_line, delta_start, length, token_type, token_modifiers_bitset });
        }
    }
    data
}

/// One edit for all that lies between what is the same at both ends.
fn difference(before: &[SemanticToken], mut after: Vec<SemanticToken>) -> Vec<SemanticTokensEdit> {
    /// Numbers that a token takes in the list of the protocol.
    const NUMBERS: u32 = 5;
    let start = before.iter().zip(&after).take_while(|(a, b)| a == b).count();
    let rest = before.len().min(after.len()) - start;
    let end = before.iter().rev().zip(after.iter().rev()).take(rest).take_while(|(a, b)| a == b).count();
    let deleted = before.len() - start - end;
    after.truncate(after.len() - end);
    let inserted = after.split_off(start);
    if deleted == 0 && inserted.is_empty() {
        return Vec::new();
    }
    vec![SemanticTokensEdit {
        start: start as u32 * NUMBERS,
        delete_count: deleted as u32 * NUMBERS,
        data: (!inserted.is_empty()).then_some(inserted),
    }]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn list(numbers: &[u32]) -> Vec<SemanticToken> {
        let token = |length: &u32| SemanticToken {
            delta_line: 0,
            delta_start: 1,
            length: *length,
            token_type: 0,
            token_modifiers_bitset: 0,
        };
        numbers.iter().map(token).collect()
    }

    #[test]
    fn a_difference_makes_the_one_list_of_the_other() {
        for (before, after) in [
            (&[1, 2, 3][..], &[1, 9, 3][..]),
            (&[1, 1], &[1, 1, 1]),
            (&[1, 1, 1], &[1]),
            (&[], &[4]),
            (&[4], &[]),
            (&[5], &[5]),
        ] {
            let mut made = list(before);
            for edit in difference(&list(before), list(after)) {
                let start = edit.start as usize / 5;
                let end = start + edit.delete_count as usize / 5;
                made.splice(start..end, edit.data.unwrap_or_default());
            }
            assert_eq!(made, list(after), "{before:?} {after:?}");
        }
    }

    #[test]
    fn every_class_has_its_type() {
        let mut kinds: Vec<_> = legend().token_types.iter().map(|kind| kind.as_str().to_owned()).collect();
        kinds.sort();
        kinds.dedup();
        assert_eq!(kinds.len(), TYPES.len(), "a type stands for one class");
    }
}
