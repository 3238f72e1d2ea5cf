//! File names as services that hold a repository know them.

use std::borrow::Cow;

/// The name with forward slashes and without a leading `./`: the form in which a repository lists its files. A back-slash
/// is taken for a separator on every system, so that a report does not depend on where it was written.
pub(crate) fn repository_path(name: &str) -> Cow<'_, str> {
    if name.contains('\\') {
        let slashed = name.replace('\\', "/");
        return Cow::Owned(without_dot(&slashed).to_owned());
    }
    Cow::Borrowed(without_dot(name))
}

fn without_dot(mut path: &str) -> &str {
    while let Some(rest) = path.strip_prefix("./") {
        path = rest.trim_start_matches('/');
    }
    path
}
