//! Variables, parameters and flags by class (guide, "Parametric Evaluation").

use super::types::ValueType;

named_enum! {
    /// The class of a variable, parameter or flag. Ids are stored in images: append only.
    pub enum OperandClass {
        /// `P0`: a user variable or a system parameter.
        Parameter = "P",
        /// `BIT 24`: a flag, -1 when set and 0 when clear.
        Bit = "BIT",
        /// `LV0`: a local 32-bit integer.
        Lv = "LV",
        /// `SV0`: a local 32-bit float.
        Sv = "SV",
        /// `DV0`: a local 64-bit float.
        Dv = "DV",
        /// `$V0`: a local string.
        StringV = "$V",
        /// `LA0(1)`: an element of a local array of 32-bit integers.
        La = "LA",
        /// `SA0(1)`: an element of a local array of 32-bit floats.
        Sa = "SA",
        /// `DA0(1)`: an element of a local array of 64-bit floats.
        Da = "DA",
        /// `$A0(1)`: an element of a local array of strings.
        StringA = "$A",
    }
}

impl OperandClass {
    /// Whether the operand takes an element index behind its number.
    pub const fn is_array(self) -> bool {
        matches!(self, Self::La | Self::Sa | Self::Da | Self::StringA)
    }

    /// Whether it belongs to a program alone; parameters and flags belong to the controller.
    pub const fn is_local(self) -> bool {
        !matches!(self, Self::Parameter | Self::Bit)
    }

    /// The type of the value. `None` for [`OperandClass::Parameter`], whose type depends on its number ([`crate::parameter`]).
    pub const fn value_type(self) -> Option<ValueType> {
        match self {
            Self::Parameter => None,
            Self::Bit | Self::Lv | Self::La => Some(ValueType::Long),
            Self::Sv | Self::Sa => Some(ValueType::Single),
            Self::Dv | Self::Da => Some(ValueType::Double),
            Self::StringV | Self::StringA => Some(ValueType::String),
        }
    }
}
