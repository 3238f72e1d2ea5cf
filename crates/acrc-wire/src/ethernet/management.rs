//! Connection management on TCP port 5004 (Ethernet specification, "Connection Management").

use super::{ControllerAlarm, FILE_LEN, Watchdog};
use crate::reader::Reader;
use crate::{ByteOrder, Channel, Decoder, MANAGEMENT_PACKETS, Malformed, ManagementRow, Side, Size, WireOptions};

/// How many blocks an operating system has at most.
pub const BLOCKS: u16 = 1024;

const WATCHDOG: u32 = 1;
const USER_ALARM: u32 = 2;
const CONTROLLER_ALARM: u32 = 3;
const CONFIGURATION: u32 = 4;
const BLOCK: u32 = 5;
const END: u32 = 6;
const REBOOT: u32 = 7;

/// Whether a client with this filter gets an alarm: when they have a bit in common.
pub const fn passes(alarm: u32, filter: u32) -> bool {
    alarm & filter != 0
}

/// What a client sends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Request<'a> {
    /// Guards connections, or ends that.
    Watchdog(Watchdog),
    /// Subscribes to alarms of programs.
    UserAlarms {
        /// Which of them ([`passes`]).
        filter: u32,
    },
    /// Subscribes to alarms of the firmware.
    ControllerAlarms {
        /// Which of them ([`passes`]).
        filter: u32,
    },
    /// Asks for the configuration file.
    ConfigurationFile,
    /// A block of a new operating system.
    Block {
        /// Its place: below [`BLOCKS`].
        index: u16,
        /// Its bytes.
        data: &'a [u8; FILE_LEN],
    },
    /// Ends the download: the blocks up to the last one that was sent are the operating system.
    EndDownload,
    /// Reboots the controller.
    Reboot,
}

/// What the controller sends: answers, and alarms without being asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reply<'a> {
    /// The watchdog packet of the client.
    Watchdog(Watchdog),
    /// An alarm of a program.
    UserAlarm {
        /// The value that the program gave.
        value: u32,
    },
    /// An alarm of the firmware.
    ControllerAlarm(ControllerAlarm),
    /// The configuration file: 1020 bytes and their CRC ([`is_intact`](super::is_intact)).
    ConfigurationFile(&'a [u8; FILE_LEN]),
    /// How the download ended.
    DownloadResult(DownloadResult),
}

/// How a download ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DownloadResult {
    /// The operating system is in flash memory.
    Success,
    /// The CRC is wrong; flash memory is as it was.
    CrcFailure,
    /// Flash memory could not be written.
    FlashFailure,
}

impl DownloadResult {
    const ALL: [Self; 3] = [Self::Success, Self::CrcFailure, Self::FlashFailure];

    fn read(value: u32) -> Result<Self, Malformed> {
        let place = usize::try_from(value).ok();
        place.and_then(|place| Self::ALL.get(place)).copied().ok_or(Malformed::DownloadResult(value))
    }
}

impl Request<'_> {
    /// Encodes what a client sends.
    pub fn encode(&self, options: &WireOptions, out: &mut impl Extend<u8>) {
        let mut put = |values: &[u32]| put(values, options.management_order, out);
        match self {
            Self::Watchdog(watchdog) => {
                put(&[WATCHDOG]);
                put(&watchdog.values());
            }
            Self::UserAlarms { filter } => put(&[USER_ALARM, *filter]),
            Self::ControllerAlarms { filter } => put(&[CONTROLLER_ALARM, *filter]),
            Self::ConfigurationFile => put(&[CONFIGURATION]),
            Self::Block { index, data } => {
                put(&[BLOCK, u32::from(*index)]);
                out.extend(data.iter().copied());
            }
            Self::EndDownload => put(&[END]),
            Self::Reboot => put(&[REBOOT]),
        }
    }
}

impl Reply<'_> {
    /// Encodes what the controller sends.
    pub fn encode(&self, options: &WireOptions, out: &mut impl Extend<u8>) {
        let mut put = |values: &[u32]| put(values, options.management_order, out);
        match self {
            Self::Watchdog(watchdog) => {
                put(&[WATCHDOG]);
                put(&watchdog.values());
            }
            Self::UserAlarm { value } => put(&[USER_ALARM, *value]),
            Self::ControllerAlarm(ControllerAlarm { code, object, count }) => {
                put(&[CONTROLLER_ALARM, *code, *object, *count]);
            }
            Self::ConfigurationFile(file) => {
                put(&[CONFIGURATION]);
                out.extend(file.iter().copied());
            }
            Self::DownloadResult(result) => put(&[END, *result as u32]),
        }
    }
}

/// Decodes what clients send: the controller's end.
pub fn requests(options: WireOptions) -> Decoder<Requests> {
    Decoder::new(Channel::fifo().with_options(options))
}

/// Decodes what the controller sends: the client's end.
pub fn replies(options: WireOptions) -> Decoder<Replies> {
    Decoder::new(Channel::fifo().with_options(options))
}

/// The direction from clients to the controller. There is no text on this port: four bytes that are no identifier are
/// unreadable.
#[derive(Clone, Copy, Debug)]
pub enum Requests {}

/// The direction from the controller to a client.
#[derive(Clone, Copy, Debug)]
pub enum Replies {}

impl Side for Requests {
    type Packet<'a> = Request<'a>;

    const PACKED: bool = false;

    fn size(head: &[u8], channel: &Channel) -> Size {
        size(head, channel, |row| Some(row.request))
    }

    fn decode<'a>(bytes: &'a [u8], channel: &Channel) -> Result<Request<'a>, Malformed> {
        let order = channel.options.management_order;
        let mut rest = Reader::new(bytes);
        Ok(match rest.long_in(order)? {
            WATCHDOG => Request::Watchdog(Watchdog::read(&mut rest, order)?),
            USER_ALARM => Request::UserAlarms { filter: rest.long_in(order)? },
            CONTROLLER_ALARM => Request::ControllerAlarms { filter: rest.long_in(order)? },
            CONFIGURATION => Request::ConfigurationFile,
            BLOCK => {
                let index = rest.long_in(order)?;
                let place = u16::try_from(index).ok().filter(|index| *index < BLOCKS);
                Request::Block { index: place.ok_or(Malformed::BlockIndex(index))?, data: rest.bytes()? }
            }
            END => Request::EndDownload,
            REBOOT => Request::Reboot,
            id => return Err(Malformed::ManagementId(id)),
        })
    }
}

impl Side for Replies {
    type Packet<'a> = Reply<'a>;

    const PACKED: bool = false;

    fn size(head: &[u8], channel: &Channel) -> Size {
        size(head, channel, |row| row.reply)
    }

    fn decode<'a>(bytes: &'a [u8], channel: &Channel) -> Result<Reply<'a>, Malformed> {
        let order = channel.options.management_order;
        let mut rest = Reader::new(bytes);
        Ok(match rest.long_in(order)? {
            WATCHDOG => Reply::Watchdog(Watchdog::read(&mut rest, order)?),
            USER_ALARM => Reply::UserAlarm { value: rest.long_in(order)? },
            CONTROLLER_ALARM => Reply::ControllerAlarm(ControllerAlarm {
                code: rest.long_in(order)?,
                object: rest.long_in(order)?,
                count: rest.long_in(order)?,
            }),
            CONFIGURATION => Reply::ConfigurationFile(rest.bytes()?),
            END => Reply::DownloadResult(DownloadResult::read(rest.long_in(order)?)?),
            id => return Err(Malformed::ManagementId(id)),
        })
    }
}

/// The size of a packet by its identifier. What is none is as long as an identifier.
fn size(head: &[u8], channel: &Channel, len: fn(&ManagementRow) -> Option<usize>) -> Size {
    let Some(id) = head.first_chunk() else { return Size::AtLeast(4) };
    let id = channel.options.management_order.read(*id);
    let row = MANAGEMENT_PACKETS.iter().find(|row| row.id == id);
    Size::Exactly(row.and_then(len).unwrap_or(4))
}

fn put(values: &[u32], order: ByteOrder, out: &mut impl Extend<u8>) {
    out.extend(values.iter().flat_map(|value| order.write(*value)));
}
