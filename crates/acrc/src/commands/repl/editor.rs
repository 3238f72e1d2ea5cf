//! A session at a terminal: lines are edited here, and the controller gets them when they are complete.

use std::borrow::Cow;
use std::io::{self, Write as _};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use acrc_controller::PromptState;
use anyhow::Context as _;
use reedline::{
    ColumnarMenu, Emacs, FileBackedHistory, KeyCode, KeyModifiers, Keybindings, MenuBuilder as _, Prompt,
    PromptEditMode, PromptHistorySearch, Reedline, ReedlineEvent, ReedlineMenu, Signal, default_emacs_keybindings,
};

use super::complete::{Vocabulary, WordCompleter};
use super::session::Session;
use super::watch::{Watched, watch};
use crate::commands::virtual_controller::describe_programs;
use crate::output::Terminal;

/// Lines of the history.
const HISTORY: usize = 1000;
/// Wall time that a statement has before the keyboard is watched while it runs.
const PROMPTLY: Duration = Duration::from_millis(60);
/// Wall time between two looks at the controller.
const BEAT: Duration = Duration::from_millis(2);
/// The menu of completions.
const MENU: &str = "words";

/// Keys that the controller gets at once: the character that each stands for.
const KEYS: [(KeyModifiers, KeyCode, &str); 4] = [
    (KeyModifiers::NONE, KeyCode::Esc, "\u{1b}"),
    (KeyModifiers::CONTROL, KeyCode::Char('x'), "\u{18}"),
    (KeyModifiers::CONTROL, KeyCode::Char('y'), "\u{19}"),
    (KeyModifiers::CONTROL, KeyCode::Char('z'), "\u{1a}"),
];

/// Runs the session until the user leaves it.
pub(super) fn run(session: &mut Session, name: &str, terminal: Terminal) -> anyhow::Result<()> {
    greet(session, name, terminal)?;
    // The editor echoes and shows the prompt itself.
    session.send(b"ECHO 4\r");
    session.settle(1.0);
    session.read();

    let vocabulary = Arc::new(Mutex::new(Vocabulary::default()));
    let mut editor = editor(Arc::clone(&vocabulary), terminal);
    loop {
        session.catch_up();
        show(session)?;
        let PromptState::Ready(prompt) = session.state() else {
            if watch(session)? == Watched::Quit {
                return Ok(());
            }
            continue;
        };
        *vocabulary.lock().unwrap_or_else(PoisonError::into_inner) = Vocabulary::of(session);
        match editor.read_line(&ControllerPrompt(prompt)).context("the terminal cannot be read")? {
            Signal::Success(line) => send_line(session, &line)?,
            Signal::HostCommand(key) => {
                session.catch_up();
                session.send(key.as_bytes());
            }
            Signal::CtrlC | Signal::CtrlD => return Ok(()),
            _ => {}
        }
    }
}

fn greet(session: &Session, name: &str, terminal: Terminal) -> io::Result<()> {
    let programs = describe_programs(&session.controller);
    let mut out = io::stdout().lock();
    writeln!(
        out,
        "{}",
        terminal.heading(&format!("{} (virtual), {name}: {programs}", session.controller.model().name))
    )?;
    let help = "HELP lists the commands of the prompt. Tab completes, Up finds earlier lines, Ctrl-C quits.\n\
                ESC leaves LRUN. Ctrl-X kills all motion, Ctrl-Y clears that, Ctrl-Z also disables the drives.";
    writeln!(out, "{}", terminal.faint(help))
}

/// Sends a line and shows what is answered promptly. A text that was pasted may hold several lines.
fn send_line(session: &mut Session, line: &str) -> anyhow::Result<()> {
    session.catch_up();
    let text = line.replace("\r\n", "\r").replace('\n', "\r");
    let bytes: Vec<u8> = text.chars().map(|character| u8::try_from(character).unwrap_or(b'?')).collect();
    session.send(&bytes);
    session.send(b"\r");
    let begun = Instant::now();
    while session.state() == PromptState::Busy && begun.elapsed() < PROMPTLY {
        std::thread::sleep(BEAT);
        session.catch_up();
        show(session)?;
    }
    show(session)
}

/// Shows what the controller has sent. A text that does not end its line is ended, since the editor begins a line of its own.
pub(super) fn show(session: &mut Session) -> anyhow::Result<()> {
    let bytes = session.read();
    if bytes.is_empty() {
        return Ok(());
    }
    let text: String = bytes.iter().copied().map(char::from).filter(|character| is_shown(*character)).collect();
    let mut out = io::stdout().lock();
    out.write_all(text.as_bytes()).and_then(|()| out.flush()).context("cannot write to the terminal")
}

/// A program may print anything; the terminal shall not act on it.
pub(in crate::commands) fn is_shown(character: char) -> bool {
    !character.is_control() || matches!(character, '\r' | '\n' | '\t')
}

pub(in crate::commands) fn editor(vocabulary: Arc<Mutex<Vocabulary>>, terminal: Terminal) -> Reedline {
    let mut keys = default_emacs_keybindings();
    bind(&mut keys);
    let menu = ReedlineMenu::EngineCompleter(Box::new(ColumnarMenu::default().with_name(MENU)));
    let editor = Reedline::create()
        .with_completer(Box::new(WordCompleter(vocabulary)))
        .with_menu(menu)
        .with_edit_mode(Box::new(Emacs::new(keys)))
        .with_ansi_colors(terminal.color)
        .use_bracketed_paste(true);
    // A history that cannot be kept is no reason not to work.
    let file = dirs::data_dir().map(|folder| folder.join("acrc").join("history.txt"));
    match file.and_then(|file| FileBackedHistory::with_file(HISTORY, file).ok()) {
        Some(history) => editor.with_history(Box::new(history)),
        None => editor,
    }
}

fn bind(keys: &mut Keybindings) {
    let complete = vec![ReedlineEvent::Menu(MENU.to_owned()), ReedlineEvent::MenuNext];
    keys.add_binding(KeyModifiers::NONE, KeyCode::Tab, ReedlineEvent::UntilFound(complete));
    for (modifiers, key, character) in KEYS {
        keys.add_binding(modifiers, key, ReedlineEvent::ExecuteHostCommand(character.to_owned()));
    }
}

/// The prompt of the controller as it is.
pub(in crate::commands) struct ControllerPrompt(pub(in crate::commands) String);

impl Prompt for ControllerPrompt {
    fn render_prompt_left(&self) -> Cow<'_, str> {
        Cow::Borrowed(&self.0)
    }

    fn render_prompt_right(&self) -> Cow<'_, str> {
        Cow::Borrowed("")
    }

    fn render_prompt_indicator(&self, _: PromptEditMode) -> Cow<'_, str> {
        Cow::Borrowed("")
    }

    fn render_prompt_multiline_indicator(&self) -> Cow<'_, str> {
        Cow::Borrowed("")
    }

    fn render_prompt_history_search_indicator(&self, search: PromptHistorySearch) -> Cow<'_, str> {
        Cow::Owned(format!("(earlier: {}) ", search.term))
    }
}
