//! Operators (guide, "Parametric Evaluation"). Ranks and operands are rows of `data/operators.toml`.

named_enum! {
    /// An operator with two operands. Ids are stored in images, in five bits: append only.
    pub enum Operator {
        /// Power; `^` is accepted for it.
        Pow = "**",
        /// Multiplication.
        Mul = "*",
        /// Division.
        Div = "/",
        /// Remainder.
        Mod = "MOD",
        /// Addition, and joining of strings.
        Add = "+",
        /// Subtraction.
        Sub = "-",
        /// Shift left.
        Shl = "<<",
        /// Shift right.
        Shr = ">>",
        /// Equal.
        Eq = "=",
        /// Not equal.
        Ne = "<>",
        /// Less than.
        Lt = "<",
        /// Greater than.
        Gt = ">",
        /// Less than or equal.
        Le = "<=",
        /// Greater than or equal.
        Ge = ">=",
        /// Bitwise and.
        And = "AND",
        /// Bitwise and, inverted.
        Nand = "NAND",
        /// Bitwise or.
        Or = "OR",
        /// Bitwise or, inverted.
        Nor = "NOR",
        /// Bitwise exclusive or.
        Xor = "XOR",
        /// Bitwise exclusive or, inverted.
        Xnor = "XNOR",
    }
}

named_enum! {
    /// An operator with one operand. Ids are stored in images, in two bits: append only.
    pub enum UnaryOperator {
        /// Negation.
        Minus = "-",
        /// A sign without effect.
        Plus = "+",
        /// Bitwise complement; on a flag -1 becomes 0 and 0 becomes -1.
        Not = "NOT",
    }
}
