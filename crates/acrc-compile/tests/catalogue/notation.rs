//! The notation of the catalogue's signatures: `{}` optional, `|` a choice, `...` repeated. A signature gives all the forms that it stands for.

/// A part of a signature.
#[derive(Clone, Debug)]
enum Part {
    /// A word, a placeholder or a mark.
    Token(String),
    /// Present or absent.
    Optional(Choice),
    /// Once or twice.
    Repeated(Vec<Part>),
    /// Nothing, or one or two of the first with marks between and, where one likes, behind.
    Listed(Choice, Choice),
}

/// Parts of which one stands.
type Choice = Vec<Vec<Part>>;

/// The forms of a signature, each as its tokens.
pub(crate) fn forms(signature: &str) -> Vec<Vec<String>> {
    let tokens = tokens(signature);
    let (choice, rest) = choice(&tokens);
    assert!(rest.is_empty(), "{signature}: `{}` closes nothing", rest.join(" "));
    choice.iter().flat_map(|parts| expand(parts)).collect()
}

/// Cuts at blanks and around marks. What stands in quotes is one token.
fn tokens(signature: &str) -> Vec<String> {
    let mut tokens: Vec<String> = Vec::new();
    let mut rest = signature;
    while let Some(first) = rest.trim_start().chars().next() {
        rest = rest.trim_start();
        let is_word = |c: char| c.is_ascii_alphanumeric() || "$_".contains(c);
        let length = if rest.starts_with("...") {
            3
        } else if first == '"' {
            1 + rest[1..].find('"').map_or(rest.len() - 1, |end| end + 1)
        } else if is_word(first) || rest.starts_with("#D") {
            1 + rest[1..].find(|c| !is_word(c)).unwrap_or(rest.len() - 1)
        } else {
            first.len_utf8()
        };
        let (token, behind) = rest.split_at(length);
        tokens.push(token.to_owned());
        rest = behind;
    }
    tokens
}

/// Reads up to the end or to the brace that closes.
fn choice(mut tokens: &[String]) -> (Choice, &[String]) {
    let mut alternatives = vec![Vec::new()];
    while let Some((token, rest)) = tokens.split_first() {
        tokens = rest;
        match token.as_str() {
            "}" => return (with_shared_heads(alternatives), tokens),
            "|" => alternatives.push(Vec::new()),
            other => {
                let parts = alternatives.last_mut().expect("begins with one");
                match other {
                    "{" => {
                        let (inner, rest) = choice(tokens);
                        tokens = rest;
                        parts.push(Part::Optional(inner));
                    }
                    "..." => repeat(parts),
                    _ => parts.push(Part::Token(other.to_owned())),
                }
            }
        }
    }
    (with_shared_heads(alternatives), tokens)
}

/// What `...` repeats: everything from the last axis on, else the part before it, with the marks behind it where these are optional.
fn repeat(parts: &mut Vec<Part>) {
    if let [.., Part::Optional(listed), Part::Optional(marks)] = parts.as_slice()
        && marks.iter().flatten().all(is_mark)
    {
        let list = Part::Listed(listed.clone(), marks.clone());
        parts.truncate(parts.len() - 2);
        parts.push(list);
        return;
    }
    let is_axis = |part: &Part| matches!(part, Part::Token(token) if token == "axis");
    let start = parts.iter().rposition(is_axis).unwrap_or(parts.len().saturating_sub(1));
    let repeated = parts.split_off(start);
    parts.push(Part::Repeated(repeated));
}

/// `{"prompt" ; | ,}` is a prompt with one of two marks: an alternative of marks alone takes the place of the marks before it.
fn with_shared_heads(mut alternatives: Choice) -> Choice {
    for place in 1..alternatives.len() {
        if !alternatives[place].is_empty() && alternatives[place].iter().all(is_mark) {
            let before = &alternatives[place - 1];
            let head = before.iter().rposition(|part| !is_mark(part)).map_or(0, |last| last + 1);
            let shared = before[..head].to_vec();
            alternatives[place].splice(0..0, shared);
        }
    }
    alternatives
}

fn is_mark(part: &Part) -> bool {
    matches!(part, Part::Token(token) if [",", ";", "+", "-", "/"].contains(&token.as_str()))
}

fn expand(parts: &[Part]) -> Vec<Vec<String>> {
    let Some((first, rest)) = parts.split_first() else { return vec![Vec::new()] };
    let heads = match first {
        Part::Token(token) => vec![vec![token.clone()]],
        Part::Optional(choice) => or_nothing(expand_choice(choice)),
        Part::Repeated(parts) => {
            let once = expand(parts);
            let twice = joined(&once, &once);
            [once, twice].concat()
        }
        Part::Listed(listed, marks) => {
            let (once, marks) = (expand_choice(listed), expand_choice(marks));
            let twice = joined(&joined(&once, &marks), &once);
            let ends = or_nothing(marks);
            or_nothing([joined(&once, &ends), joined(&twice, &ends)].concat())
        }
    };
    joined(&heads, &expand(rest))
}

fn expand_choice(choice: &Choice) -> Vec<Vec<String>> {
    choice.iter().flat_map(|parts| expand(parts)).collect()
}

fn or_nothing(forms: Vec<Vec<String>>) -> Vec<Vec<String>> {
    std::iter::once(Vec::new()).chain(forms).collect()
}

/// Each of the first followed by each of the second.
fn joined(heads: &[Vec<String>], tails: &[Vec<String>]) -> Vec<Vec<String>> {
    heads.iter().flat_map(|head| tails.iter().map(|tail| [&head[..], tail].concat())).collect()
}
