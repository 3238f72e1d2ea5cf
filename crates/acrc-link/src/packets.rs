//! Packets over a connection: questions with their answers, and orders that are not answered.

use acrc_wire::{Reply, Request};

use crate::connection::CERTAIN;
use crate::question::{answers, what};
use crate::transport::Transport;
use crate::{Connection, LinkError};

/// Packets that are under way at most: their answers fit what sockets hold, so that neither side waits for the other.
const WINDOW: usize = 256;

impl<T: Transport> Connection<T> {
    /// Sends packets that are answered, many under way at a time, and gives each answer with the place of its question.
    ///
    /// # Errors
    /// When an answer does not come, or another one than was asked for.
    pub fn ask(
        &mut self,
        requests: &[Request<'_>],
        mut answered: impl FnMut(usize, &Reply<'_>),
    ) -> Result<(), LinkError> {
        // Text that comes in between answers nothing, and is not kept for who asks for packets all day.
        self.text.clear();
        let mut next = 0;
        for chunk in requests.chunks(WINDOW) {
            self.post(chunk)?;
            let (begin, end) = (next, next + chunk.len());
            let typed = if self.packets_came { String::new() } else { self.as_typed(chunk) };
            // What came is what a port for text makes of packets.
            let mut echoed = false;
            while next < end {
                let waited = what(requests.get(next));
                let mut wrong = None;
                let mut found = |reply: Result<Reply<'_>, String>| match reply {
                    Ok(reply) if requests.get(next).is_some_and(|request| answers(request, &reply)) => {
                        answered(next, &reply);
                        next += 1;
                    }
                    Ok(reply) => wrong = Some(format!("{reply:?}")),
                    Err(problem) => wrong = Some(problem),
                };
                let longest = if echoed { CERTAIN.min(self.settings.answer) } else { self.settings.answer };
                let came = self.read_on(longest, &waited, &mut found)?;
                if let Some(answer) = wrong {
                    return Err(LinkError::NotUnderstood { line: waited, answer });
                }
                self.packets_came |= next > begin;
                let text_only = !self.packets_came && !self.text.is_empty();
                if !came && text_only {
                    return Err(LinkError::TextOnly { endpoint: self.name.clone(), line: waited });
                }
                if !came {
                    return Err(LinkError::Timeout { line: waited, after: self.settings.answer });
                }
                echoed = text_only && self.text == typed;
            }
        }
        Ok(())
    }

    /// What an echo shows of packets that are taken for text.
    fn as_typed(&self, requests: &[Request<'_>]) -> String {
        let mut bytes = Vec::new();
        if let Some((channel, _)) = &self.channel {
            for request in requests {
                channel.request(request, &mut bytes);
            }
        }
        bytes.into_iter().filter(|byte| matches!(byte, b' '..=b'~')).map(char::from).collect()
    }

    /// Sends packets. Those that are not answered are done with that.
    ///
    /// # Errors
    /// When they cannot be sent, or the connection speaks text only.
    pub fn post(&mut self, requests: &[Request<'_>]) -> Result<(), LinkError> {
        let line = what(requests.first());
        let Some((channel, _)) = &self.channel else {
            return Err(LinkError::NotSendable { line, problem: "the connection speaks text only" });
        };
        let mut bytes = Vec::new();
        for request in requests {
            channel.request(request, &mut bytes);
        }
        self.write_bytes(&bytes, &line)
    }
}
