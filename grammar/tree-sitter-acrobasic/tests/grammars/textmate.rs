//! The `TextMate` grammar, in the engine of VS Code, says about each token what the compiler says.
//!
//! The engine is JavaScript: the test needs node and `npm ci --prefix grammar/test`, and is left out where they are not there.

use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};

use crate::classes::{self, Class};
use crate::programs::programs;

/// Scopes by their beginning; the first that fits counts.
const SCOPES: [(&str, Class); 13] = [
    ("comment", Class::Comment),
    ("string", Class::String),
    ("constant.numeric", Class::Number),
    ("constant.other.bit", Class::Bit),
    ("entity.name.label", Class::Label),
    ("keyword.operator.word", Class::OperatorWord),
    ("keyword.operator", Class::Operator),
    ("keyword", Class::Keyword),
    ("support.function", Class::Function),
    ("variable.parameter", Class::Parameter),
    ("variable.language", Class::Variable),
    ("variable.other", Class::Name),
    ("punctuation", Class::Punctuation),
];

/// Lines that need to know more than a regular expression sees: what stands behind them is a move or the name of a flag.
const LIMITS: [&str; 3] = ["AND LD X5", "OR LD X5", "SAMP TRG X5"];

/// What the engine says about the texts, in their order. `None` where it is not installed.
fn tokenize(texts: &[&str]) -> Option<Vec<Vec<(usize, usize, String)>>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../test");
    if !folder.join("node_modules/vscode-textmate").is_dir() {
        assert!(std::env::var_os("CI").is_none(), "run `npm ci --prefix grammar/test`");
        eprintln!("left out: no engine in {}", folder.display());
        return None;
    }
    let mut node = Command::new("node")
        .arg(folder.join("tokenize.js"))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("node can be started");
    let mut input = node.stdin.take().expect("the input is a pipe");
    for text in texts {
        let line = serde_json::to_string(text).expect("a text is JSON");
        writeln!(input, "{line}").expect("node reads its input");
    }
    drop(input);
    let output = node.wait_with_output().expect("node ends");
    assert!(output.status.success(), "node failed");
    let answers = String::from_utf8(output.stdout).expect("the answer is text");
    Some(answers.lines().map(|line| serde_json::from_str(line).expect("tokens of a text")).collect())
}

#[test]
fn scopes_are_the_classes_of_the_compiler() {
    let mut programs = programs();
    for program in &mut programs {
        let lines = program.text.split_inclusive('\n');
        program.text = lines.filter(|line| !LIMITS.iter().any(|limit| line.starts_with(limit))).collect();
    }
    let texts: Vec<&str> = programs.iter().map(|program| program.text.as_str()).collect();
    let Some(answers) = tokenize(&texts) else { return };
    assert_eq!(answers.len(), texts.len());
    let mut answers = answers.into_iter();
    classes::compare(programs, |text| {
        let mut bytes = vec![None; text.len()];
        for (start, end, scope) in answers.next().unwrap_or_default() {
            let class = SCOPES.iter().find(|(beginning, _)| scope.starts_with(beginning)).map(|(_, class)| *class);
            assert!(class.is_some(), "the scope {scope} stands for no class");
            bytes[start..end].fill(class);
        }
        bytes
    });
}
