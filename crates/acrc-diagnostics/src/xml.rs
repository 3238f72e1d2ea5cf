//! Text that may stand in an XML document.

use crate::path::repository_path;
use crate::plain::visible;

/// A file name as the value of an attribute. It stays what it is as far as XML allows: characters that no document may
/// have become visible, and line ends and tabs, which a reader would turn into spaces, become spaces here.
pub(crate) fn xml_name(name: &str) -> String {
    let allowed = |c| match c {
        '\n' | '\r' | '\t' => ' ',
        '\0'..='\x1F' | '\u{FFFE}' | '\u{FFFF}' => visible(c),
        other => other,
    };
    repository_path(name).chars().map(allowed).collect()
}
