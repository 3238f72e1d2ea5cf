//! What a program may do with a parameter or a flag, and what a flag is for.

named_enum! {
    /// What a program may do with a parameter or a flag.
    pub enum Access {
        /// Reading only; the controller writes it.
        Read = "read",
        /// Reading and writing.
        ReadWrite = "read-write",
        /// No source says.
        Unknown = "unknown",
    }
}

named_enum! {
    /// What a flag is for (guide, "Parameters and Bits").
    pub enum BitKind {
        /// A digital input.
        Input = "input",
        /// A digital output.
        Output = "output",
        /// Set and cleared by the controller to report a state.
        Status = "status",
        /// Set by a program to ask for something; the controller clears it when it is done.
        Request = "request",
        /// Set and cleared by a program; the controller obeys it and leaves it alone.
        Control = "control",
        /// Free for programs.
        User = "user",
    }
}
