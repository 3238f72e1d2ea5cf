//! Who comes, what they send, and how they leave.

use std::io::{Read, Write};
use std::net::{Shutdown, SocketAddr, TcpStream, UdpSocket};
use std::time::Duration;

use acrc_wire::PACKETS;

/// Where the server listens.
pub(crate) struct Places {
    pub(crate) ascii: SocketAddr,
    pub(crate) mixed: SocketAddr,
    pub(crate) management: SocketAddr,
    pub(crate) fast_status: SocketAddr,
}

/// Numbers in an order of their own for each seed (splitmix64).
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// 0 up to but without `end`.
    fn below(&mut self, end: usize) -> usize {
        (self.bits() % end as u64) as usize
    }

    fn byte(&mut self) -> u8 {
        self.bits() as u8
    }

    fn one_of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())]
    }
}

/// How a stranger leaves.
#[derive(Clone, Copy)]
enum Farewell {
    /// As the specification recommends: ends its side, reads the rest.
    Graceful,
    /// Closes with bytes unread, so that the connection is reset.
    Abrupt,
    /// Ends its side and reads nothing for a while.
    HalfOpen,
    /// Goes on sending and never reads.
    Deaf,
    /// At once, without a word.
    Silent,
}

/// A client that means no good.
pub(crate) struct Stranger {
    bytes: Vec<u8>,
    farewell: Farewell,
}

/// Words of the language, so that some lines are commands.
const WORDS: &[&str] = &[
    "SYS",
    "PROG0",
    "PROG1",
    "PROG15",
    "PLC0",
    "RUN",
    "RUN ALL",
    "HALT",
    "HALT ALL",
    "LRUN",
    "LISTEN",
    "LIST",
    "NEW",
    "PROGRAM",
    "ENDP",
    "X10",
    "X/-5",
    "JOG FWD X",
    "JOG OFF X",
    "DRIVE ON X",
    "ACC",
    "?P0",
    "?P12288",
    "P0=",
    "1e308",
    "PRINT",
    "\"",
    "(",
    ")",
    ":",
    "INPUT P0",
    "ECHO 0",
    "ECHO 4",
    "MODE 3",
    "DWL 1",
    "INH 516",
    "FOR",
    "NEXT",
    "WHILE (1)",
    "WEND",
    "IF (1)",
    "ENDIF",
    "GOTO 10",
    "10",
    "DIM P(10)",
    "DIM $V(99999999)",
    "CLEAR",
    "ATTACH",
    "FSTAT0(48,2)",
    "FSTAT ON",
    "OPEN",
    "CLOSE #1",
    "TALK TO \"STREAM3:\"",
    "SET 32",
    "CLR 8467",
    "ESAVE",
    "VER",
    "HELP",
    "MEM",
    "REN",
    "TRON",
    "STEP",
    "PAUSE",
    "RESUME",
    "BIT32=-1",
    "P4097=$FFFF",
    "'",
    "REM",
    "_label",
    "#DEFINE a P1",
];

impl Stranger {
    pub(crate) fn new(random: &mut Random) -> Self {
        let parts = 1 + random.below(20);
        let bytes = (0..parts).flat_map(|_| part(random)).collect();
        let farewell = random.one_of(&[
            Farewell::Graceful,
            Farewell::Abrupt,
            Farewell::HalfOpen,
            Farewell::Deaf,
            Farewell::Silent,
        ]);
        Self { bytes, farewell }
    }

    /// Comes, sends, leaves. What the server does is checked afterwards.
    pub(crate) fn visit(mut self, places: &Places, random: &mut Random) {
        let address = random.one_of(&[places.ascii, places.mixed, places.mixed, places.management, places.fast_status]);
        if address == places.fast_status {
            let _ = self.datagrams(address, random);
            return;
        }
        if address == places.management {
            self.bytes = (0..=random.below(5)).flat_map(|_| management(random)).collect();
        }
        // Refused, reset, shut down: all of that may happen.
        let _ = self.connection(address, random);
    }

    fn connection(&self, address: SocketAddr, random: &mut Random) -> std::io::Result<()> {
        let mut stream = TcpStream::connect(address)?;
        stream.set_nodelay(random.below(2) == 0)?;
        stream.set_read_timeout(Some(Duration::from_millis(20)))?;
        stream.set_write_timeout(Some(Duration::from_millis(20)))?;
        if matches!(self.farewell, Farewell::Silent) {
            return Ok(());
        }
        let mut rest = self.bytes.as_slice();
        while !rest.is_empty() {
            let (piece, behind) = rest.split_at((1 + random.below(64)).min(rest.len()));
            stream.write_all(piece)?;
            rest = behind;
            if random.below(8) == 0 {
                let _ = stream.read(&mut [0; 256]);
            }
        }
        match self.farewell {
            Farewell::Graceful => {
                stream.shutdown(Shutdown::Write)?;
                while stream.read(&mut [0; 4096])? > 0 {}
            }
            Farewell::HalfOpen => {
                stream.shutdown(Shutdown::Write)?;
                std::thread::sleep(Duration::from_millis(random.below(100) as u64));
            }
            Farewell::Deaf => {
                let flood = self.bytes.repeat(1 + 65536 / self.bytes.len().max(1));
                for _ in 0..16 {
                    stream.write_all(&flood)?;
                }
            }
            Farewell::Abrupt | Farewell::Silent => {}
        }
        Ok(())
    }

    fn datagrams(&self, address: SocketAddr, random: &mut Random) -> std::io::Result<()> {
        let socket = UdpSocket::bind(("127.0.0.1", 0))?;
        for _ in 0..=random.below(5) {
            // A client with an interval of days is not known to have left until then, so the interval stays below a second.
            let subscription = [0, 0, 0, random.byte() & 3, 0, 0, random.byte() & 1, random.byte()];
            let mut garbage = self.bytes[..random.below(self.bytes.len().min(600) + 1)].to_vec();
            if let Some(interval) = garbage.get_mut(4..7) {
                interval.fill(0);
            }
            let sent = if random.below(2) == 0 { subscription.as_slice() } else { &garbage };
            socket.send_to(sent, address)?;
        }
        Ok(())
    }
}

/// A piece of what is sent on 5002 and 5006.
fn part(random: &mut Random) -> Vec<u8> {
    match random.below(6) {
        0 => (0..random.below(200)).map(|_| random.byte()).collect(),
        1 => packet(random),
        2 => {
            let mut cut = packet(random);
            cut.truncate(random.below(cut.len()));
            cut
        }
        3 => vec![random.byte(); random.below(3000)],
        4 => vec![random.one_of(&[0x18, 0x19, 0x1a, 0x1b, 0x00, 0x04, 0x0d, 0x0a, 0x3a])],
        _ => line(random),
    }
}

fn line(random: &mut Random) -> Vec<u8> {
    let words: Vec<&str> = (0..=random.below(4)).map(|_| random.one_of(WORDS)).collect();
    let mut line = words.join(random.one_of(&[" ", "", " : ", "\t"])).into_bytes();
    line.extend_from_slice(random.one_of(&[b"\r".as_slice(), b"\n", b"\r\n", b"\r\0\0\0", b""]));
    line
}

/// A packet of the binary host interface with anything in it.
fn packet(random: &mut Random) -> Vec<u8> {
    let row = random.one_of(&PACKETS);
    let mut bytes = vec![row.header, row.id.unwrap_or_else(|| random.byte())];
    bytes.extend((0..2 + 4 * random.below(12)).map(|_| random.byte()));
    if random.below(2) == 0 {
        // A small number is more likely to name something.
        bytes[2..4].copy_from_slice(&[random.byte() & 7, random.byte() & 7]);
    }
    bytes
}

/// A packet of connection management: any, as a whole or a part. A reboot among them is answered by a restart.
fn management(random: &mut Random) -> Vec<u8> {
    let id = random.one_of(&[1, 1, 2, 3, 4, 4, 5, 6, 7, 8, 255]);
    let mut bytes = vec![0, 0, 0, id];
    let length = match id {
        1 => 20,
        2 | 3 => 4,
        5 => 1028,
        _ => 0,
    };
    bytes.extend((0..length).map(|_| random.byte() & 0x0f));
    if random.below(4) == 0 {
        bytes.truncate(random.below(bytes.len()));
    }
    bytes
}
