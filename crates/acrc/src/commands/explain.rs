//! `acrc explain`: what the catalogue and the linter know of a topic.

use acrc_analysis::nearest;
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
    if let Some(text) = acrc_link::download::codes::explain(&topic) {
        print(|out| write!(out, "{text}"))?;
        return Ok(Exit::Clean);
    }
    let explanation = acrc_catalog::explain(&topic);
    if !matches!(explanation, Explanation::Entries(_))
        && let Some(rule) = nearest(&topic.to_ascii_lowercase(), acrc_lint::rules().map(|doc| doc.code.name))
    {
        bail!("nothing is known of `{topic}`: did you mean the rule `{rule}`?");
    }
    match &explanation {
        Explanation::Entries(_) => {
            print(|out| write!(out, "{}", explanation.render()))?;
            Ok(Exit::Clean)
        }
        Explanation::Near { suggestions, .. } if suggestions.is_empty() => bail!(
            "nothing is known of `{topic}`; a command, a function, P12290, BIT8467, a model, a rule or its code can be explained"
        ),
        Explanation::Near { suggestions, .. } => {
            let names: Vec<String> = suggestions.iter().map(|name| format!("`{name}`")).collect();
            bail!("nothing is known of `{topic}`: did you mean {}?", names.join(" or "))
        }
    }
}
