//! How the check went: whether all was checked, and what was not.

use serde::Serialize;

use super::SOURCE_ROOT;
use super::result::Message;
use super::uri::FileUri;
use crate::{Severity, Unchecked};

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Invocation {
    execution_successful: bool,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    tool_execution_notifications: Vec<Notification>,
}

impl Invocation {
    pub(super) fn new(unchecked: &[Unchecked]) -> Self {
        Self {
            execution_successful: unchecked.is_empty(),
            tool_execution_notifications: unchecked.iter().map(Notification::new).collect(),
        }
    }
}

#[derive(Serialize)]
struct Notification {
    level: &'static str,
    message: Message,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    locations: Vec<Location>,
}

impl Notification {
    fn new(Unchecked { name, reason }: &Unchecked) -> Self {
        Self {
            level: super::level(Severity::Error),
            message: Message::new(reason),
            locations: name.iter().map(|name| Location::new(name)).collect(),
        }
    }
}

/// A file as a whole.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Location {
    physical_location: PhysicalLocation,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct PhysicalLocation {
    artifact_location: ArtifactLocation,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct ArtifactLocation {
    uri: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    uri_base_id: Option<&'static str>,
}

impl Location {
    fn new(name: &str) -> Self {
        let FileUri { uri, relative } = FileUri::new(name);
        let artifact_location = ArtifactLocation { uri, uri_base_id: relative.then_some(SOURCE_ROOT) };
        Self { physical_location: PhysicalLocation { artifact_location } }
    }
}
