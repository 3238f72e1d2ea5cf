//! The numbers of one stored text.

use std::collections::{BTreeMap, BTreeSet};
use std::num::NonZeroU32;

use acrc_diagnostics::{Edit, Span};
use acrc_syntax::ast::Target;

use super::collect::{Site, StoredLine, Text};
use super::{MAX_LINE_NUMBER, RenumberError, RenumberErrorKind, Source, slice};

/// A line without a number is listed with the next multiple of this.
const HIDDEN_STEP: u64 = 10;

/// Adds the edits of one text.
pub(super) fn text(
    files: &[Source<'_>],
    text: &Text,
    (start, step): (NonZeroU32, NonZeroU32),
    edits: &mut [Vec<Edit>],
    errors: &mut Vec<RenumberError>,
) {
    let before = errors.len();
    errors.extend(text.unreadable.iter().map(|site| error(site, site.what, RenumberErrorKind::Unreadable)));
    check_order(text, errors);
    let labels: BTreeSet<&str> = text.labels.iter().map(|label| slice(files, label.file, label.what)).collect();
    let numbers = numbers(text, &labels, (start, step), errors);
    let mut edit = |file: usize, span: Span, number: u32| {
        let number = number.to_string();
        if let (true, Some(edits)) = (slice(files, file, span) != number, edits.get_mut(file)) {
            edits.push(Edit::replace(span, number));
        }
    };
    for line in &text.lines {
        if let Some((number, new)) = line.number.and_then(|number| Some((number, numbers.get(&number.value)?))) {
            edit(line.file, number.span, *new);
        }
    }
    for jump in &text.jumps {
        let name = slice(files, jump.file, jump.what.span());
        match jump.what {
            Target::Line(number, span) if numbers.contains_key(&number) => {
                numbers.get(&number).into_iter().for_each(|new| edit(jump.file, span, *new));
            }
            _ if labels.contains(name) || errors.len() > before => {}
            target => {
                let kind = RenumberErrorKind::MissingTarget { target: name.to_owned() };
                errors.push(error(jump, target.span(), kind));
            }
        }
    }
}

fn error<T>(site: &Site<T>, span: Span, kind: RenumberErrorKind) -> RenumberError {
    RenumberError { file: site.file, span, kind }
}

/// The numbers must rise.
fn check_order(text: &Text, errors: &mut Vec<RenumberError>) {
    let mut before: Option<u32> = None;
    for line in &text.lines {
        let Some(number) = line.number else { continue };
        let kind = match before {
            Some(before) if before == number.value => RenumberErrorKind::Duplicate { number: number.value },
            Some(before) if before > number.value => RenumberErrorKind::OutOfOrder { number: number.value, before },
            _ => {
                before = Some(number.value);
                continue;
            }
        };
        errors.push(RenumberError { file: line.file, span: number.span, kind });
    }
}

/// The new number of each old one.
fn numbers(
    text: &Text,
    labels: &BTreeSet<&str>,
    (start, step): (NonZeroU32, NonZeroU32),
    errors: &mut Vec<RenumberError>,
) -> BTreeMap<u32, u32> {
    let step = u64::from(step.get());
    let (mut next, mut last) = (u64::from(start.get()), 0);
    let mut numbers = BTreeMap::new();
    for &StoredLine { file, number } in &text.lines {
        let Some(number) = number else {
            last = (last / HIDDEN_STEP + 1) * HIDDEN_STEP;
            continue;
        };
        if next <= last {
            next += (last - next) / step * step + step;
        }
        while labels.contains(next.to_string().as_str()) {
            next += step;
        }
        match u32::try_from(next).ok().filter(|&new| new <= MAX_LINE_NUMBER) {
            Some(new) => numbers.insert(number.value, new),
            None => {
                let kind = RenumberErrorKind::TooLarge { number: next };
                errors.push(RenumberError { file, span: number.span, kind });
                break;
            }
        };
        last = next;
        next += step;
    }
    numbers
}
