//! AcroBASIC in Zed: says how the language server `acrc lsp` is started.

use zed_extension_api::serde_json::Value;
use zed_extension_api::settings::LspSettings;
use zed_extension_api::{self as zed, Command, Extension, LanguageServerId, Result, Worktree};

struct AcroBasic;

impl Extension for AcroBasic {
    fn new() -> Self {
        Self
    }

    /// `lsp.acrc.binary` of the settings, else `acrc` on the path.
    fn language_server_command(&mut self, server: &LanguageServerId, worktree: &Worktree) -> Result<Command> {
        let binary = LspSettings::for_worktree(server.as_ref(), worktree)?.binary;
        let (path, arguments) = binary.map_or((None, None), |binary| (binary.path, binary.arguments));
        let command = path
            .or_else(|| worktree.which("acrc"))
            .ok_or("acrc is not on the PATH: install it, or say in lsp.acrc.binary.path where it is")?;
        let args = arguments.unwrap_or_else(|| vec!["lsp".to_owned()]);
        Ok(Command { command, args, env: worktree.shell_env() })
    }

    /// `lsp.acrc.settings` of the settings, below the name that the server asks for.
    fn language_server_workspace_configuration(
        &mut self,
        server: &LanguageServerId,
        worktree: &Worktree,
    ) -> Result<Option<Value>> {
        let settings = LspSettings::for_worktree(server.as_ref(), worktree)?.settings;
        Ok(settings.map(|settings| zed::serde_json::json!({ "acrc": settings })))
    }
}

zed::register_extension!(AcroBasic);
