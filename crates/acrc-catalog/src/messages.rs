//! Texts that a controller sends: those that are known, and those that a virtual controller words itself ([`Message::is_known`]).

use crate::Confidence;
use crate::generated::{MESSAGE_BY_ID, MESSAGES};

/// A row of the message table; its number is stable. Values come from [`crate::message`] or [`MessageId::from_id`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct MessageId(pub u8);

impl MessageId {
    /// The row.
    pub fn info(self) -> &'static Message {
        self.find().expect("a message id is an id of the catalogue")
    }

    /// The text as the controller sends it.
    pub fn text(self) -> &'static str {
        self.info().text
    }

    /// The message with this id, if there is one.
    pub fn from_id(id: u8) -> Option<Self> {
        Self(id).find().map(|message| message.id)
    }

    fn find(self) -> Option<&'static Message> {
        let place = MESSAGE_BY_ID.get(usize::from(self.0))?;
        MESSAGES.get(usize::from(*place))
    }
}

/// A text of the controller.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Message {
    /// Its identifier.
    pub id: MessageId,
    /// The name of its constant.
    pub name: &'static str,
    /// The text as the controller sends it.
    pub text: &'static str,
    /// When it is sent.
    pub meaning: &'static str,
    /// Where the row comes from (`data/README.md`).
    pub source: &'static str,
    /// How well it is attested.
    pub confidence: Confidence,
}

impl Message {
    /// The controller is known to send this text, word for word.
    pub fn is_known(&self) -> bool {
        self.source != "own"
    }
}

/// Every message, in the order of the data file.
pub fn all_messages() -> impl ExactSizeIterator<Item = &'static Message> {
    MESSAGES.iter()
}
