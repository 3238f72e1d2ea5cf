//! Words that are only parts of statements.

named_enum! {
    /// A word that never starts a statement. Ids are stored in images: append only.
    pub enum Keyword {
        /// `OPEN "COM1:" AS #1`
        As = "AS",
        /// `PRINT USING "##" ; value`
        Using = "USING",
        /// `FOR variable = start TO end`, `TALK TO`
        To = "TO",
        /// `IF (condition) THEN statement`
        Then = "THEN",
        /// `FOR variable = start TO end STEP step`
        Step = "STEP",
        /// Switches an object or a mode on.
        On = "ON",
        /// Switches an object or a mode off.
        Off = "OFF",
        /// Every program, or every attachment.
        All = "ALL",
        /// No source, or an empty module of `CONFIG`.
        None = "NONE",
        /// The controller's own time base as a source.
        Clock = "CLOCK",
        /// `DRIVE RES`
        Res = "RES",
        /// A module of `CONFIG` with analog and stepper outputs: `DACSTEP2`.
        DacStep = "DACSTEP",
    }
}
