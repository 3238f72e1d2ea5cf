use acrc_syntax::*;
fn main() {
    for f in std::env::args().skip(1) {
        let b = std::fs::read(&f).unwrap();
        let s = SourceText::decode(&b).unwrap();
        let t = parse(&s.text);
        println!("#### {f}");
        if t.print(&s.text) != s.text {
            println!("PRINT DIFFERS");
        }
        for e in t.errors() {
            let l = s.text[..e.span.start as usize].matches('\n').count() + 1;
            println!("  {l}: {} {} {:?}", e.code, e.message, e.help);
        }
        if std::env::var("DUMP").is_ok() {
            print!("{}", debug_tree(&t, &s.text));
        }
    }
}
