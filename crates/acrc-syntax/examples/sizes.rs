//! s
use acrc_syntax::ast::*;
fn main() {
    macro_rules! s{($($t:ty),*)=>{$(println!("{} {}",stringify!($t),std::mem::size_of::<$t>());)*}}
    s!(
        Expr,
        ExprKind,
        Operand,
        Argument,
        Axis,
        Object,
        BitArgument,
        Command,
        Statement,
        StatementKind,
        Line,
        Assign,
        If,
        Print,
        PrintItem,
        Tuple,
        Word
    );
    let text = std::fs::read_to_string("/tmp/big.8K").unwrap();
    let mut best = f64::MAX;
    let mut bl = f64::MAX;
    for _ in 0..8 {
        let t = cpu();
        let l = acrc_syntax::lexer::tokenize(&text);
        bl = bl.min(cpu() - t);
        std::mem::forget(l);
        let t = cpu();
        let tr = acrc_syntax::parse(&text);
        best = best.min(cpu() - t);
        println!("{} {} {}", tr.tokens().len(), tr.statements().len(), tr.errors().len());
    }
    println!("lex {:.1} parse {:.1} MB/s", text.len() as f64 / 1e6 / bl, text.len() as f64 / 1e6 / best);
}
fn cpu() -> f64 {
    let s = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap();
    s.split(' ').next().unwrap().parse::<f64>().unwrap() / 1e9
}
