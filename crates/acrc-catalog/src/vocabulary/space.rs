//! What a parameter or flag number belongs to.

use super::ObjectKind;

named_enum! {
    /// The owner of a range of parameters or flags.
    pub enum Space {
        /// User variables and user flags.
        User = "user",
        /// The 32-bit words that hold the flags.
        Flags = "flags",
        /// Digital inputs.
        Input = "input",
        /// Digital outputs.
        Output = "output",
        /// Expansion inputs and outputs.
        Xio = "xio",
        /// An encoder.
        Encoder = "encoder",
        /// An analog output.
        Dac = "dac",
        /// An analog input.
        Adc = "adc",
        /// A block shared by analog outputs and inputs.
        DacAdc = "dac-adc",
        /// A PLC program.
        Plc = "plc",
        /// The controller as a whole.
        System = "system",
        /// A program.
        Program = "program",
        /// A master.
        Master = "master",
        /// An axis.
        Axis = "axis",
        /// A commutator.
        Cmt = "cmt",
        /// Event logging.
        Logging = "logging",
        /// The Drive Talk data of an axis.
        DriveTalk = "drivetalk",
        /// The `CANopen` network and its nodes.
        CanOpen = "canopen",
        /// The `EtherNet/IP` map.
        EtherNetIp = "ethernetip",
        /// A communication stream.
        Stream = "stream",
        /// The Ethernet Powerlink network.
        Epl = "epl",
        /// No source says.
        Unknown = "unknown",
    }
}

impl Space {
    /// The object that stands in front of commands for it: `AXIS` for what belongs to an axis.
    pub const fn object_kind(self) -> Option<ObjectKind> {
        Some(match self {
            Self::Axis => ObjectKind::Axis,
            Self::Master => ObjectKind::Master,
            Self::Encoder => ObjectKind::Encoder,
            Self::Dac => ObjectKind::Dac,
            Self::Adc => ObjectKind::Adc,
            Self::Cmt => ObjectKind::Cmt,
            Self::Program => ObjectKind::Prog,
            Self::Plc => ObjectKind::Plc,
            _ => return None,
        })
    }

    /// Whether its objects are numbered, as axes are. The numbers of the others are elements: input 24, user variable 5.
    pub const fn is_numbered(self) -> bool {
        !matches!(
            self,
            Self::User
                | Self::Flags
                | Self::Input
                | Self::Output
                | Self::Xio
                | Self::System
                | Self::EtherNetIp
                | Self::Stream
                | Self::Unknown
        )
    }
}
