//! The machine: eight axes in blended coordinated moves.

use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};

/// Moves eight axes forth and back for as long as it runs.
pub(crate) const MOVING: &str = "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"A\"\nATTACH SLAVE1 AXIS1 \"B\"\n\
    ATTACH SLAVE2 AXIS2 \"C\"\nATTACH SLAVE3 AXIS3 \"D\"\nATTACH SLAVE4 AXIS4 \"E\"\nATTACH SLAVE5 AXIS5 \"G\"\n\
    ATTACH SLAVE6 AXIS6 \"H\"\nATTACH SLAVE7 AXIS7 \"I\"\nACC 500 DEC 500 STP 0 VEL 50\nPROGRAM\n_Again\n\
    A/10 B/5 C/4 D/3 E/2 G/1 H/7 I/6\nA/-10 B/-5 C/-4 D/-3 E/-2 G/-1 H/-7 I/-6\nGOTO Again\nENDP\n";

/// Starts the program as a client does, and makes the axes' positions known to fast status.
pub(crate) fn start(address: SocketAddr) {
    let mut stream = TcpStream::connect(address).expect("the server listens");
    for line in ["FSTAT0(48,2)", "FSTAT1(48,0)", "FSTAT ON", "RUN PROG0"] {
        stream.write_all(format!("{line}\r").as_bytes()).expect("the server takes it");
        let mut heard = Vec::new();
        let mut byte = [0];
        while !heard.ends_with(b"SYS>") {
            stream.read_exact(&mut byte).expect("the server answers");
            heard.extend(byte);
        }
        assert_eq!(heard, format!("{line}\r\nSYS>").as_bytes(), "{}", String::from_utf8_lossy(&heard));
    }
}
