//! The keyboard while a program is listened to or a statement waits: keys go to the controller as they are pressed.

use std::io;
use std::time::Duration;

use acrc_controller::PromptState;
use anyhow::Context as _;
use crossterm::event::{Event, KeyCode, KeyEvent, KeyEventKind, KeyModifiers, poll, read};
use crossterm::terminal::{disable_raw_mode, enable_raw_mode};

use super::editor::show;
use super::session::Session;

/// Wall time between two looks at the controller.
const BEAT: Duration = Duration::from_millis(10);

/// How watching ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Watched {
    /// The prompt is back.
    Ready,
    /// The user leaves the session.
    Quit,
}

/// Raw mode for as long as this lives.
pub(in crate::commands) struct RawMode;

impl RawMode {
    pub(in crate::commands) fn enter() -> io::Result<Self> {
        enable_raw_mode().map(|()| Self)
    }
}

impl Drop for RawMode {
    fn drop(&mut self) {
        // Nothing can be done about a terminal that cannot be set back.
        let _ = disable_raw_mode();
    }
}

/// Shows what comes until the prompt is back.
pub(super) fn watch(session: &mut Session) -> anyhow::Result<Watched> {
    let _raw = RawMode::enter().context("the terminal cannot be watched")?;
    loop {
        session.catch_up();
        show(session)?;
        if matches!(session.state(), PromptState::Ready(_)) {
            return Ok(Watched::Ready);
        }
        if !poll(BEAT).context("the keyboard cannot be read")? {
            continue;
        }
        if let Event::Key(key) = read().context("the keyboard cannot be read")? {
            match pressed(key) {
                Pressed::Quit => return Ok(Watched::Quit),
                Pressed::Character(byte) => session.send(&[byte]),
                Pressed::Nothing => {}
            }
        }
    }
}

/// What a key means to the controller.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::commands) enum Pressed {
    Quit,
    Character(u8),
    Nothing,
}

pub(in crate::commands) fn pressed(key: KeyEvent) -> Pressed {
    if key.kind == KeyEventKind::Release {
        return Pressed::Nothing;
    }
    let control = key.modifiers.contains(KeyModifiers::CONTROL);
    match key.code {
        KeyCode::Char('c' | 'd') if control => Pressed::Quit,
        KeyCode::Char(letter @ 'a'..='z') if control => Pressed::Character(letter as u8 - b'a' + 1),
        KeyCode::Char(character) => u8::try_from(character).map_or(Pressed::Nothing, Pressed::Character),
        KeyCode::Esc => Pressed::Character(0x1b),
        KeyCode::Enter => Pressed::Character(b'\r'),
        KeyCode::Tab => Pressed::Character(b'\t'),
        KeyCode::Backspace => Pressed::Character(0x08),
        _ => Pressed::Nothing,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_the_characters_of_a_terminal() {
        let key = |code, modifiers| pressed(KeyEvent::new(code, modifiers));
        assert_eq!(key(KeyCode::Char('x'), KeyModifiers::CONTROL), Pressed::Character(0x18));
        assert_eq!(key(KeyCode::Esc, KeyModifiers::NONE), Pressed::Character(0x1b));
        assert_eq!(key(KeyCode::Char('c'), KeyModifiers::CONTROL), Pressed::Quit);
        assert_eq!(key(KeyCode::Char('X'), KeyModifiers::SHIFT), Pressed::Character(b'X'));
        assert_eq!(key(KeyCode::Char('€'), KeyModifiers::NONE), Pressed::Nothing);
    }
}
