//! What is put into the database: files and the project that they form.
#![expect(missing_docs, reason = "salsa generates constructors and setters without documentation")]

use acrc_catalog::Model;
use acrc_diagnostics::Diagnostic;

use crate::FileRole;
use crate::project::Config;

/// A file of a project.
#[salsa::input(debug)]
pub struct SourceFile {
    /// Its path, as it is shown.
    #[returns(deref)]
    pub name: String,
    /// Its decoded text.
    #[returns(deref)]
    pub text: String,
    /// What it is to the project.
    #[returns(copy)]
    pub role: FileRole,
    /// What was found while decoding it: byte order mark, bytes of another encoding.
    #[returns(deref)]
    pub encoding: Vec<Diagnostic>,
}

/// The files of one controller.
#[salsa::input(debug)]
pub struct Project {
    /// The files in the order in which they are sent.
    #[returns(deref)]
    pub files: Vec<SourceFile>,
    /// The controller model.
    #[returns(copy)]
    pub model: &'static Model,
    /// The configuration.
    #[returns(ref)]
    pub config: Config,
}
