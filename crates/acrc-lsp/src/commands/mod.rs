//! Commands that a person chooses: dry run, memory, download. Each runs this program once more, as a child, so that what
//! happens is what the command line does; an editor stays as quick as it was.

mod child;
mod outcome;

use std::collections::HashMap;
use std::path::Path;

use acrc_catalog::OperandClass;
use acrc_ide::InlineValue;
use camino::Utf8PathBuf;
use serde::Deserialize;
use serde_json::{Value, json};
use tower_lsp_server::Client;
use tower_lsp_server::jsonrpc::{Error, ErrorCode, Result};
use tower_lsp_server::ls_types::{
    ExecuteCommandParams, MessageActionItem, MessageType, ProgressToken, ShowDocumentParams, Uri,
};

use crate::abilities::Abilities;
use crate::snapshot::Snapshot;
use crate::uri::is_on_disk;

pub(crate) use outcome::{Outcomes, Run};

/// Runs a project in virtual time.
pub(crate) const SIM: &str = "acrc.sim";
/// Says where the memory goes.
pub(crate) const MEM: &str = "acrc.mem";
/// Sends a project to a controller.
pub(crate) const DOWNLOAD: &str = "acrc.download";
/// Shows the page of the last dry run.
pub(crate) const REPORT: &str = "acrc.report";
/// All commands.
pub(crate) const ALL: [&str; 4] = [SIM, MEM, DOWNLOAD, REPORT];

/// The most values that a dry run is asked for.
const MOST_VALUES: usize = 400;
/// A dry run of an editor ends when this much virtual time has passed, unless it is told otherwise.
const USUAL_TIME: &str = "60s";
/// The protocol's code for a request that is in order and could not be fulfilled.
const REQUEST_FAILED: i64 = -32803;

/// What a command is about.
#[derive(Debug, Deserialize)]
pub(crate) struct Target {
    /// Some file of the project.
    pub(crate) uri: Uri,
    /// The program to run: `PROG3`.
    program: Option<String>,
    /// Virtual time to run for: `30s`.
    until: Option<String>,
    /// The controller to send to.
    to: Option<String>,
}

/// What is known of a project before its command runs.
pub(crate) struct Plan {
    key: Utf8PathBuf,
    /// Parameters and flags that the project names.
    operands: Vec<String>,
    abilities: Abilities,
}

impl Target {
    /// Reads the arguments of a command.
    pub(crate) fn of(params: &ExecuteCommandParams) -> Result<Self> {
        let argument = params.arguments.first().cloned().unwrap_or_default();
        Self::deserialize(argument).map_err(|error| Error::invalid_params(format!("`{}`: {error}", params.command)))
    }

    /// Finds the project.
    pub(crate) fn plan(&self, snapshot: &Snapshot) -> Result<Plan> {
        let place = snapshot.place(&self.uri).ok_or_else(|| failed("the file belongs to no project"))?;
        let key = snapshot.files.keys.get(&place.project).filter(|key| is_on_disk(key));
        let key = key.ok_or_else(|| failed("the file was never saved"))?.clone();
        let mut operands: Vec<String> = Vec::new();
        for file in place.project.files(&snapshot.db) {
            let whole = acrc_diagnostics::Span::new(0, file.text(&snapshot.db).len() as u32);
            let values = acrc_ide::inline_values(&snapshot.db, place.project, *file, whole);
            operands.extend(values.iter().filter_map(operand));
        }
        operands.sort();
        operands.dedup();
        operands.truncate(MOST_VALUES);
        Ok(Plan { key, operands, abilities: snapshot.abilities })
    }
}

/// The name by which a dry run gives a value; `None` for what is local to a program.
pub(crate) fn operand(value: &InlineValue) -> Option<String> {
    match value.class {
        OperandClass::Parameter => Some(format!("P{}", value.number)),
        OperandClass::Bit => Some(format!("BIT{}", value.number)),
        _ => None,
    }
}

/// Fulfils a command.
pub(crate) async fn execute(
    client: Client,
    outcomes: &Outcomes,
    params: ExecuteCommandParams,
    target: &Target,
    plan: Plan,
) -> Result<Option<Value>> {
    let token = params.work_done_progress_params.work_done_token;
    match params.command.as_str() {
        SIM => sim(&client, outcomes, target, &plan, token).await.map(Some),
        MEM => mem(&client, &plan, token).await.map(Some),
        DOWNLOAD => download(&client, target, &plan, token).await,
        REPORT => report(&client, outcomes, &plan).await,
        other => Err(Error::invalid_params(format!("there is no command `{other}`"))),
    }
}

async fn sim(
    client: &Client,
    outcomes: &Outcomes,
    target: &Target,
    plan: &Plan,
    token: Option<ProgressToken>,
) -> Result<Value> {
    let page = outcomes.page(&plan.key).map_err(|error| failed(format!("there is no place for the page: {error}")))?;
    let until = target.until.as_deref().unwrap_or(USUAL_TIME);
    let mut arguments = vec!["sim", plan.key.as_str(), "--format", "json", "--until", until, "--report", page.as_str()];
    arguments.extend(target.program.iter().flat_map(|program| ["--run", program]));
    let operands = plan.operands.join(",");
    if !operands.is_empty() {
        arguments.extend(["--read", operands.as_str()]);
    }
    let done = during(client, token, "Dry run", child::run(&arguments)).await?;
    let run: Value = serde_json::from_str(&done.output).map_err(|_| failed(done.errors.clone()))?;
    let run = Run::new(run, page.clone());
    let summary = run.summary();
    outcomes.remember(&plan.key, run);
    if plan.abilities.refreshes_lenses {
        // A client that refuses asks when it likes.
        let _ = client.code_lens_refresh().await;
    }
    Ok(json!({ "status": done.status, "summary": summary, "report": page, "errors": done.errors }))
}

async fn mem(client: &Client, plan: &Plan, token: Option<ProgressToken>) -> Result<Value> {
    let done = during(client, token, "Memory", child::run(&["mem", plan.key.as_str()])).await?;
    Ok(json!({ "status": done.status, "output": done.output, "errors": done.errors }))
}

/// Shows what would happen to the controller, and sends only what a person has seen and confirmed.
async fn download(
    client: &Client,
    target: &Target,
    plan: &Plan,
    token: Option<ProgressToken>,
) -> Result<Option<Value>> {
    const SEND: &str = "Send";
    let to = target.to.as_deref().ok_or_else(|| Error::invalid_params("`to` names the controller"))?;
    let project = plan.key.as_str();
    let planned = planned(client, token.clone(), project, to).await?;
    let choice = |title: &str| MessageActionItem { title: title.to_owned(), properties: HashMap::new() };
    // The lines that are sent would fill a screen many times over.
    let (summary, lines) = planned.split_once("\n\n").unwrap_or((&planned, ""));
    client.log_message(MessageType::INFO, lines).await;
    let question = format!("Send {project} to the controller at {to}?\n\n{summary}");
    let answer =
        client.show_message_request(MessageType::WARNING, question, Some(vec![choice(SEND), choice("Cancel")])).await?;
    if answer.is_none_or(|answer| answer.title != SEND) {
        return Ok(None);
    }
    if self::planned(client, token.clone(), project, to).await? != planned {
        return Err(failed("nothing was sent: the files or the controller have changed since the plan was shown"));
    }
    let done = during(client, token, "Download", child::run(&["download", project, "--to", to, "--yes"])).await?;
    Ok(Some(json!({ "status": done.status, "output": done.output, "errors": done.errors })))
}

/// What a download would do.
async fn planned(client: &Client, token: Option<ProgressToken>, project: &str, to: &str) -> Result<String> {
    let done = during(client, token, "Plan", child::run(&["download", project, "--to", to, "--plan"])).await?;
    if done.status == Some(0) {
        return Ok(done.output);
    }
    Err(failed(if done.errors.is_empty() { done.output } else { done.errors }))
}

async fn report(client: &Client, outcomes: &Outcomes, plan: &Plan) -> Result<Option<Value>> {
    let run = outcomes.of(&plan.key).ok_or_else(|| failed("there was no dry run yet"))?;
    let Some(uri) = Uri::from_file_path(Path::new(run.page().as_str())) else { return Ok(None) };
    let params = ShowDocumentParams { uri, external: Some(true), take_focus: None, selection: None };
    if plan.abilities.shows_documents {
        // One that can't show it gets the path.
        let _ = client.show_document(params).await;
    }
    Ok(Some(json!({ "report": run.page() })))
}

/// Shows that something goes on while it does. Who cancels the request ends the child.
async fn during<T>(
    client: &Client,
    token: Option<ProgressToken>,
    title: &str,
    work: impl Future<Output = std::io::Result<T>>,
) -> Result<T> {
    let Some(token) = token else { return work.await.map_err(|error| failed(error.to_string())) };
    let progress = client.progress(token, title).begin().await;
    let done = work.await;
    progress.finish().await;
    done.map_err(|error| failed(error.to_string()))
}

fn failed(why: impl Into<String>) -> Error {
    Error { code: ErrorCode::ServerError(REQUEST_FAILED), message: why.into().into(), data: None }
}
