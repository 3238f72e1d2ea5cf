//! x
use acrc_syntax::*;
fn main() {
    for l in std::fs::read_to_string(std::env::args().nth(1).unwrap()).unwrap().lines() {
        let t = parse(l);
        println!("{l}");
        if t.print(l) != l {
            println!("PRINT DIFFERS");
        }
        for e in t.errors() {
            println!(
                "        {} @{}..{} {}{}",
                e.code,
                e.span.start,
                e.span.end,
                e.message,
                e.help.as_ref().map(|h| format!("  [{h}]")).unwrap_or_default()
            );
        }
        if t.errors().is_empty() {
            println!("        ok: {}", debug_tree(&t, l).split_whitespace().skip(2).collect::<Vec<_>>().join(" "));
        }
    }
}
