//! `acrc explain`: what the catalogue and the linter know of a topic.

use acrc_catalog::Explanation;
use anyhow::bail;

use crate::cli::ExplainArguments;
use crate::exit::Exit;
use crate::output::print;

pub(super) fn run(arguments: &ExplainArguments) -> anyhow::Result<Exit> {
    let topic = arguments.topic.join(" ");
    if let Some(rule) = acrc_lint::explain(&topic) {
        print(|out| {
            write!(out, "{}", rule.render())?;
            match rule.configuration() {
                words if words.is_empty() => Ok(()),
                words => write!(out, "\n{words}"),
            }
        })?;
        return Ok(Exit::Clean);
    }
    let explanation = acrc_catalog::explain(&topic);
    match &explanation {
        Explanation::Entries(_) => {
            print(|out| write!(out, "{}", explanation.render()))?;
            Ok(Exit::Clean)
        }
        Explanation::Near { suggestions, .. } if suggestions.is_empty() => bail!(
            "nothing is known of `{topic}`; a command, a function, P12290, BIT8467, a model or a code can be explained"
        ),
        Explanation::Near { suggestions, .. } => {
            let names: Vec<String> = suggestions.iter().map(|name| format!("`{name}`")).collect();
            bail!("nothing is known of `{topic}`: did you mean {}?", names.join(" or "))
        }
    }
}
