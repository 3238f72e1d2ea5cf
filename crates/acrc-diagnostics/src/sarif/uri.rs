//! File names as URI references (RFC 3986).

use std::borrow::Cow;

use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, utf8_percent_encode};

use crate::path::repository_path;

/// What is escaped in a path: all but what RFC 3986 calls unreserved or a sub-delimiter, `@` and the slash. A colon is
/// escaped too: in the first part of a relative path it would end the name of a scheme.
const ESCAPED: &AsciiSet = &NON_ALPHANUMERIC
    .remove(b'-')
    .remove(b'.')
    .remove(b'_')
    .remove(b'~')
    .remove(b'!')
    .remove(b'$')
    .remove(b'&')
    .remove(b'\'')
    .remove(b'(')
    .remove(b')')
    .remove(b'*')
    .remove(b'+')
    .remove(b',')
    .remove(b';')
    .remove(b'=')
    .remove(b'@')
    .remove(b'/');

/// A file as a report names it.
pub(super) struct FileUri {
    pub(super) uri: String,
    /// Whether the root of the report has to be known to find the file.
    pub(super) relative: bool,
}

impl FileUri {
    /// An absolute path, of Windows or of Unix, becomes a `file` URI, any other name a relative reference.
    pub(super) fn new(name: &str) -> Self {
        let path = without_verbatim_prefix(repository_path(name));
        let uri = |prefix: &str, path: &str| format!("{prefix}{}", utf8_percent_encode(path, ESCAPED));
        if let Some(share) = path.strip_prefix("//") {
            return Self { uri: uri("file://", share), relative: false };
        }
        if let Some((drive, rest)) = split_drive(&path) {
            return Self { uri: uri(&format!("file:///{drive}:"), rest), relative: false };
        }
        if path.starts_with('/') {
            return Self { uri: uri("file://", &path), relative: false };
        }
        Self { uri: uri("", &path), relative: true }
    }
}

/// Windows puts `\\?\` before paths that are to be taken as they are; no URI has a place for it.
fn without_verbatim_prefix(path: Cow<'_, str>) -> Cow<'_, str> {
    if let Some(share) = path.strip_prefix("//?/UNC/") {
        return Cow::Owned(format!("//{share}"));
    }
    match path.strip_prefix("//?/") {
        Some(rest) => Cow::Owned(rest.to_owned()),
        None => path,
    }
}

/// `C:/x` as `C` and `/x`.
fn split_drive(path: &str) -> Option<(char, &str)> {
    let (drive, rest) = path.split_once(':')?;
    let letter = drive.parse::<char>().ok().filter(char::is_ascii_alphabetic)?;
    rest.starts_with('/').then_some((letter, rest))
}
