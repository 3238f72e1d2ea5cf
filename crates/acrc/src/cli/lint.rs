//! The arguments of `acrc lint`.

use std::path::PathBuf;

use clap::{ArgGroup, Args, ValueEnum};

/// `acrc lint`
#[derive(Args, Debug)]
#[command(
    group = ArgGroup::new("repair").args(["fix", "diff"]),
    after_help = "A PATH is a project, a folder with projects below it (what git ignores is passed over),\n\
                  a file of a project, or `-` for standard input.\n\n\
                  A RULE is a code (ACR101), the beginning of a code (ACR1), a name (undefined-label),\n\
                  a group (flow) or ALL.\n\n\
                  Examples:\n  \
                  acrc lint                            the projects in and below this folder\n  \
                  acrc lint --fix                      repair what can be repaired safely\n  \
                  acrc lint --unsafe --diff            show what bolder repairs would change\n  \
                  acrc lint --select flow,ACR3 --ignore unused-label\n  \
                  acrc lint --format sarif --output-file acrc.sarif\n  \
                  acrc lint --baseline old.json --write-baseline    accept what is found today\n  \
                  acrc lint --baseline old.json        show only what is new\n  \
                  acrc lint - --stdin-filename src/Prog0.8K <draft.8K\n\n\
                  Exit status: 0 nothing to report at the level of --fail-on, 1 findings (with --diff:\n\
                  changes), 2 could not run, 130 interrupted."
)]
pub(crate) struct LintArguments {
    /// What to check
    #[arg(default_value = ".", value_name = "PATH")]
    pub(crate) paths: Vec<PathBuf>,
    /// Check again whenever a file changes, until Ctrl-C
    #[arg(long, conflicts_with_all = ["repair", "write_baseline", "output_file", "statistics", "rules", "stdin_filename"])]
    pub(crate) watch: bool,
    /// The name of what is read from standard input; the project that it lies in is read from disk
    #[arg(long, value_name = "FILE")]
    pub(crate) stdin_filename: Option<PathBuf>,
    /// Which rules are on.
    #[command(flatten)]
    pub(crate) selection: SelectionArguments,
    /// Repairs.
    #[command(flatten)]
    pub(crate) repair: RepairArguments,
    /// The report.
    #[command(flatten)]
    pub(crate) output: OutputArguments,
}

/// Which rules are on.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Rules")]
pub(crate) struct SelectionArguments {
    /// Check only these rules
    #[arg(long, value_name = "RULE,...", value_delimiter = ',')]
    pub(crate) select: Option<Vec<String>>,
    /// Check these rules too
    #[arg(long, value_name = "RULE,...", value_delimiter = ',')]
    pub(crate) extend_select: Vec<String>,
    /// Do not check these rules
    #[arg(long, value_name = "RULE,...", value_delimiter = ',')]
    pub(crate) ignore: Vec<String>,
    /// List the rules and which of them are on
    #[arg(long, conflicts_with_all = ["repair", "baseline", "statistics", "output_file"])]
    pub(crate) rules: bool,
}

/// Repairs.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Repairs")]
pub(crate) struct RepairArguments {
    /// Repair what can be repaired without changing what a program does
    #[arg(long)]
    pub(crate) fix: bool,
    /// Show what --fix would change, and write nothing
    #[arg(long, conflicts_with_all = ["format", "output_file", "write_baseline"])]
    pub(crate) diff: bool,
    /// Also apply repairs that may change what a program does
    #[arg(long = "unsafe", requires = "repair")]
    pub(crate) bold: bool,
}

/// The report.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Report")]
pub(crate) struct OutputArguments {
    /// How findings are shown
    #[arg(long, value_enum, default_value_t = LintFormat::Text)]
    pub(crate) format: LintFormat,
    /// Where the report goes instead of standard output
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output_file: Option<PathBuf>,
    /// The mildest finding that makes the exit status 1 [default: warning, or what acrc.toml says]
    #[arg(long, value_enum, value_name = "SEVERITY")]
    pub(crate) fail_on: Option<FailOn>,
    /// Leave out what this file lists
    #[arg(long, value_name = "FILE")]
    pub(crate) baseline: Option<PathBuf>,
    /// List in the file of --baseline what is found now
    #[arg(long, requires = "baseline", conflicts_with = "statistics")]
    pub(crate) write_baseline: bool,
    /// Show how often each rule finds something, instead of what it finds
    #[arg(long, conflicts_with = "diff")]
    pub(crate) statistics: bool,
    /// Leave out everything but the findings
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

/// Forms of lint output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum LintFormat {
    /// The source with each finding marked
    Text,
    /// One line a finding
    Concise,
    /// One JSON object
    Json,
    /// One JSON object a line, a finding each
    Jsonl,
    /// SARIF 2.1.0, for code scanning
    Sarif,
    /// Workflow commands of GitHub Actions
    Github,
    /// Code Quality report of GitLab
    Gitlab,
    /// `JUnit` XML
    #[value(help = "JUnit XML")]
    Junit,
    /// Checkstyle XML
    Checkstyle,
}

/// Findings that count as failure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum FailOn {
    /// No finding
    Never,
    /// Every finding
    Advice,
    /// Errors and warnings
    Warning,
    /// Errors only
    Error,
}
