//! URIs and the paths that files are known by.
//!
//! A file on disk is known by its absolute path. What has no path, such as an editor's file without a name, is known by
//! its URI, which no path is equal to.

use camino::{Utf8Path, Utf8PathBuf};
use tower_lsp_server::ls_types::Uri;

/// What a document is known by.
pub(crate) fn path_of(uri: &Uri) -> Utf8PathBuf {
    let file = (uri.scheme().as_str() == "file").then(|| uri.to_file_path()).flatten();
    let file = file.and_then(|path| Utf8PathBuf::from_path_buf(path.into_owned()).ok());
    file.filter(|path| path.is_absolute()).unwrap_or_else(|| Utf8PathBuf::from(uri.as_str()))
}

/// The URI of a path from [`path_of`].
pub(crate) fn uri_of(path: &Utf8Path) -> Option<Uri> {
    if is_on_disk(path) { Uri::from_file_path(path.as_std_path()) } else { path.as_str().parse().ok() }
}

/// Whether the path is one of the file system.
pub(crate) fn is_on_disk(path: &Utf8Path) -> bool {
    path.is_absolute()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_come_back() {
        for text in ["file:///machine/Prog0.8K", "file:///machine/a%20b/Pr%C3%BCfung.8K", "untitled:Untitled-1"] {
            let uri: Uri = text.parse().expect("a URI");
            assert_eq!(uri_of(&path_of(&uri)).as_ref().map(|uri| uri.as_str()), Some(text));
        }
    }

    #[test]
    fn one_file_has_one_path_however_its_uri_is_written() {
        let encoded: Uri = "file:///m%61chine/Prog0%2E8K".parse().expect("a URI");
        assert_eq!(path_of(&encoded), "/machine/Prog0.8K");
    }
}
