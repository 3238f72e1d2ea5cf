//! `PASSWORD` in the boot unit.

use acrc_catalog::{Keyword, command};
use acrc_image::{Alias, Image, Instruction, Item, Node, Separator, UnitName, VERSION, encode};

fn password(items: Vec<Node>) -> Instruction {
    let items = items.into_iter().map(Item::from).collect();
    Instruction { address: 0, separator: Separator::Line, command: command::PASSWORD, items }
}

fn word(keyword: Keyword) -> Node {
    Node::Word { keyword, index: None }
}

/// The password behind setup code.
fn behind(statements: &[Instruction]) -> Option<String> {
    let image = Image {
        model: "ACR9000".to_owned(),
        aliases: vec![Alias { name: "Secret".to_owned(), target: Node::string("alias") }],
        boot: encode(UnitName::Boot, statements).expect("valid"),
        programs: Vec::new(),
        files: Vec::new(),
        version: VERSION,
    };
    image.password().expect("valid")
}

#[test]
fn the_last_word_of_the_setup_code_counts() {
    let on = |text: &str| password(vec![word(Keyword::On), Node::string(text)]);
    let off = |text: &str| password(vec![word(Keyword::Off), Node::string(text)]);
    assert_eq!(behind(&[]), None);
    assert_eq!(behind(&[on("a")]).as_deref(), Some("a"));
    assert_eq!(behind(&[password(vec![Node::string("a")])]).as_deref(), Some("a"));
    assert_eq!(behind(&[on("a"), off("a")]), None);
    assert_eq!(behind(&[on("a"), off("b")]).as_deref(), Some("a"), "the wrong password lifts nothing");
    assert_eq!(behind(&[on("a"), on("b")]).as_deref(), Some("a"), "what is protected keeps its password");
    assert_eq!(behind(&[on("a"), off("a"), on("b")]).as_deref(), Some("b"));
    assert_eq!(behind(&[off("a")]), None);
}

#[test]
fn a_password_may_be_an_alias_but_not_be_missing() {
    let alias = Node::Alias { index: 0, parens: 0 };
    assert_eq!(behind(&[password(vec![word(Keyword::On), alias])]).as_deref(), Some("alias"));
    assert_eq!(behind(&[password(vec![])]), None);
    assert_eq!(behind(&[password(vec![word(Keyword::On), Node::Long(5)])]), None);
}
