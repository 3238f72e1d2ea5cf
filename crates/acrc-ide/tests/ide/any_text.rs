//! Any text and any place: every function answers.

use acrc_diagnostics::{Fix, Span, apply};
use acrc_ide::{
    FilePosition, at, code_actions, definition, document_symbols, everywhere, fix_all, folds, format_file,
    format_range, format_typed, highlights, in_file, incoming_calls, links, outgoing_calls, prepare_rename,
    project_links, references, rename, routine_at, selection_ranges, workspace_symbols,
};
use proptest::prelude::*;

use crate::fixture::Fixture;

/// Pieces of programs, and characters that stand nowhere in one.
fn pieces() -> impl Strategy<Value = String> {
    let known = prop::sample::select(vec![
        "PROG0\n",
        "PROGRAM\n",
        "ENDP\n",
        "_A\n",
        "GOSUB A\n",
        "GOTO 10\n",
        "10 SET 32\n",
        "RETURN\n",
        "IF (BIT 5)\n",
        "IF (BIT5) THEN ",
        "ELSE\n",
        "ENDIF\n",
        "WHILE (1)\n",
        "WEND\n",
        "FOR LV0=1 TO 3\n",
        "NEXT\n",
        "BREAK\n",
        "#DEFINE Lamp BIT32\n",
        "#DEFINE P",
        "SET Lamp\n",
        "SET 516 : ",
        "X10Y/-5 ",
        "DIM LV(3)\n",
        "LV9=P1\n",
        "ATTACH SLAVE0 AXIS0 \"X\"\n",
        "ATTACH SLAVE0 AXIS0 \"",
        "REM a : b\n",
        "' c\n",
        "' acrc: allow(unused-label)\n",
        "LA0(1)=$V1\n",
        "PLC0\n",
        "SYS\n",
        ":",
        "\r",
        "\r\n",
        "\u{201c}a\u{201d}",
        "\u{1f600}",
        "_",
        "(",
        "JOG VEL X",
    ]);
    let any = prop_oneof![6 => known.prop_map(str::to_owned), 1 => "\\PC{0,4}"];
    prop::collection::vec(any, 0..16).prop_map(|pieces| pieces.concat())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn every_function_takes_any_text_and_place(first in pieces(), second in pieces(), place in 0_u32..120, len in 0_u32..40) {
        let fixture = Fixture::new(&format!("=== Setup.8K\n{first}\n=== Prog0.8K\n{second}"));
        let (db, project) = (&fixture.db, fixture.project);
        for &file in &fixture.files {
            let text = file.text(db);
            let position = FilePosition { project, file, offset: place };
            let fits = |span: Span| text.get(span.range()).is_some();
            if let Some(occurrence) = at(db, position) {
                prop_assert!(fits(occurrence.span));
                everywhere(db, project, &occurrence.entity);
            }
            prop_assert!(in_file(db, project, file).iter().all(|occurrence| fits(occurrence.span)));
            for target in definition(db, position) {
                let text = target.file.text(db);
                prop_assert!(text.get(target.whole.range()).is_some() && text.get(target.name.range()).is_some());
                prop_assert_eq!(Span::cover(target.whole, target.name), target.whole);
            }
            references(db, position, true);
            prop_assert!(highlights(db, position).iter().all(|(span, _)| fits(*span)));
            for symbol in document_symbols(db, file) {
                prop_assert!(fits(symbol.whole) && fits(symbol.place));
                prop_assert!(symbol.children.iter().all(|child| Span::cover(child.whole, child.place) == child.whole));
            }
            workspace_symbols(db, project, "a", 10);
            if let Some(routine) = routine_at(db, position) {
                let known = FilePosition { offset: routine.target.name.start, ..position };
                incoming_calls(db, known);
                outgoing_calls(db, known);
                prop_assert_eq!(routine_at(db, known), Some(routine));
            }
            prop_assert!(folds(db, file).iter().all(|fold| fits(fold.span)));
            let ranges = selection_ranges(db, file, place);
            prop_assert!(ranges.windows(2).all(|pair| Span::cover(pair[0], pair[1]) == pair[1] && pair[0] != pair[1]));
            links(db, file);
            project_links(text);
            let _ = prepare_rename(db, position);
            let renamed = rename(db, position, "Zz").unwrap_or_default();
            let part = Span::new(place, place + len);
            let actions = code_actions(db, project, file, part).into_iter().chain(fix_all(db, project, file));
            let edits = actions.flat_map(|action| action.edits).chain(renamed);
            for (file, edits) in edits {
                prop_assert!(apply(file.text(db), &[&Fix::safe("", edits.clone())]).is_ok(), "{:?}", edits);
            }
            let typed = ['\n', 'F'].map(|typed| format_typed(db, project, file, place, typed));
            for edits in [format_file(db, project, file), format_range(db, project, file, part)].into_iter().chain(typed) {
                prop_assert!(apply(text, &[&Fix::safe("", edits.clone())]).is_ok(), "{:?}", edits);
            }
        }
    }
}
