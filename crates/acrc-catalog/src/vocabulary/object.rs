//! Things that are addressed by a word and a number: `AXIS0`, `ENC3`, `PROG7`.

named_enum! {
    /// The kind of a numbered object. Ids are stored in images: append only.
    pub enum ObjectKind {
        /// An axis.
        Axis = "AXIS",
        /// A master: the trajectory generator of a program.
        Master = "MASTER",
        /// An encoder input.
        Encoder = "ENC",
        /// An analog output.
        Dac = "DAC",
        /// An analog input.
        Adc = "ADC",
        /// A step-and-direction output.
        Stepper = "STEPPER",
        /// A commutator.
        Cmt = "CMT",
        /// A program.
        Prog = "PROG",
        /// A PLC program.
        Plc = "PLC",
        /// A slot of a master, to which an axis is attached.
        Slave = "SLAVE",
        /// A USB or Ethernet command stream.
        Stream = "STREAM",
        /// A programmable limit switch.
        Pls = "PLS",
        /// A block of fast-status parameters.
        Fstat = "FSTAT",
        /// A software ratchet.
        Ratch = "RATCH",
        /// A frequency limiter.
        Limit = "LIMIT",
        /// A sampling channel.
        Samp = "SAMP",
        /// A serial port.
        Com = "COM",
        /// A drive on the Ethernet Powerlink network: position feedback and output in one.
        Epld = "EPLD",
    }
}
