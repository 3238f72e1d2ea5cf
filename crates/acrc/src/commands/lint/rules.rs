//! The list of rules: `--rules`.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use acrc_analysis::project::{CONFIG_NAME, LintConfig, Selection};
use acrc_diagnostics::Applicability;
use acrc_lint::RuleState;
use anyhow::bail;
use serde::Serialize;

use crate::cli::{LintArguments, LintFormat};
use crate::commands::project::load;
use crate::commands::targets::real;
use crate::exit::Exit;
use crate::output::print;

#[derive(Serialize)]
struct Row {
    code: &'static str,
    name: &'static str,
    group: &'static str,
    severity: &'static str,
    enabled: bool,
    fix: Option<&'static str>,
    summary: &'static str,
}

impl From<RuleState> for Row {
    fn from(RuleState { doc, on, severity }: RuleState) -> Self {
        Self {
            code: doc.code.id,
            name: doc.code.name,
            group: doc.group.as_str(),
            severity: severity.as_str(),
            enabled: on,
            fix: doc.fix().map(Applicability::as_str),
            summary: doc.summary(),
        }
    }
}

/// Lists the rules as the project at the first path, or the one around it, has them.
pub(super) fn run(arguments: &LintArguments, selection: &Selection) -> anyhow::Result<Exit> {
    let path = arguments.paths.first().map_or(Path::new("."), PathBuf::as_path);
    let configs = real(path).ancestors().map(|folder| folder.join(CONFIG_NAME)).collect::<Vec<_>>();
    let mut config = match configs.iter().find(|config| config.is_file()) {
        Some(config) => load(config)?.config.lint,
        None => LintConfig::default(),
    };
    config.command_line = selection.clone();
    let rows: Vec<Row> = acrc_lint::rule_states(&config).into_iter().map(Row::from).collect();
    match arguments.output.format {
        LintFormat::Text => print(|out| table(&rows, out))?,
        LintFormat::Json => print(|out| {
            serde_json::to_writer(&mut *out, &rows)?;
            out.write_all(b"\n")
        })?,
        _ => bail!("the list of rules has the formats text and json"),
    }
    Ok(Exit::Clean)
}

/// A row a line. On a terminal a line is cut where the terminal would break it.
fn table(rows: &[Row], out: &mut dyn Write) -> io::Result<()> {
    let columns = terminal_size::terminal_size_of(io::stdout()).map(|(width, _)| usize::from(width.0));
    let width = |text: fn(&Row) -> &str| rows.iter().map(|row| text(row).len()).max().unwrap_or(0);
    let (names, groups) = (width(|row| row.name), width(|row| row.group));
    writeln!(out, "{:<6}  {:<names$}  {:<groups$}  {:<8}  {:<6}  finds", "code", "name", "group", "severity", "fix")?;
    for row in rows {
        let severity = if row.enabled { row.severity } else { "off" };
        let fix = row.fix.unwrap_or_default();
        let Row { code, name, group, summary, .. } = row;
        let line = format!("{code:<6}  {name:<names$}  {group:<groups$}  {severity:<8}  {fix:<6}  {summary}");
        match columns.filter(|columns| line.chars().count() > *columns) {
            Some(columns) => {
                let kept: String = line.chars().take(columns.saturating_sub(1)).collect();
                writeln!(out, "{kept}\u{2026}")?;
            }
            None => writeln!(out, "{line}")?,
        }
    }
    Ok(())
}
