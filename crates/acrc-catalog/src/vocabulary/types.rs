//! Types of values, and the looser classes that functions are described with.

named_enum! {
    /// The type of a stored value.
    pub enum ValueType {
        /// 32-bit integer.
        Long = "long",
        /// 32-bit float.
        Single = "single",
        /// 64-bit float.
        Double = "double",
        /// Characters.
        String = "string",
    }
}

named_enum! {
    /// What a function takes or gives.
    pub enum TypeClass {
        /// A long, single or double; a flag counts as a long.
        Number = "number",
        /// A 32-bit integer.
        Long = "long",
        /// A single or double.
        Float = "float",
        /// A string.
        String = "string",
        /// The type of the argument.
        Same = "same",
        /// A long or a string.
        LongOrString = "long or string",
    }
}
