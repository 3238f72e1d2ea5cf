//! What is asked of a controller: lines that can be sent, and packets with their answers.

use acrc_wire::{Reply, Request};

use crate::LinkError;

/// Whether a line can be sent as one line.
pub(crate) fn check(line: &str) -> Result<(), LinkError> {
    let problem = if line.contains(['\r', '\n']) {
        "it is more than one line"
    } else if line.chars().any(|character| character.is_control() && character != '\t') {
        "it has a control character"
    } else if line.chars().any(|character| u8::try_from(character).is_err()) {
        "it has a character that Latin-1 lacks"
    } else {
        return Ok(());
    };
    Err(LinkError::NotSendable { line: line.escape_debug().to_string(), problem })
}

/// Whether a reply is the answer to a request: the controller repeats what was asked for.
pub(crate) fn answers(request: &Request<'_>, reply: &Reply<'_>) -> bool {
    match (request, reply) {
        (Request::Data(asked), Reply::Data(data)) => *asked == data.request(),
        (Request::GetLong { parameter: asked }, Reply::Long { parameter, .. })
        | (Request::GetSingle { parameter: asked }, Reply::Single { parameter, .. })
        | (Request::ParameterAddress { parameter: asked }, Reply::ParameterAddress { parameter, .. }) => {
            asked == parameter
        }
        (Request::Peek(_), Reply::Peek(_)) => true,
        (Request::Address(asked), Reply::Address { request, .. }) => asked == request,
        _ => false,
    }
}

/// What is asked for, in words.
pub(crate) fn what(request: Option<&Request<'_>>) -> String {
    match request {
        Some(Request::GetLong { parameter } | Request::GetSingle { parameter }) => format!("get P{parameter}"),
        Some(Request::SetLong { parameter, .. } | Request::SetSingle { parameter, .. }) => format!("set P{parameter}"),
        Some(Request::Data(data)) => format!("get group {:#04x}, index {}", data.group, data.index),
        Some(request) => format!("{request:?}"),
        None => "no packet".to_owned(),
    }
}
