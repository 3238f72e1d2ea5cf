//! How the arguments of a command are written.

named_enum! {
    /// How the arguments of a command are written; it drives the parser and the argument checker.
    ///
    /// [`crate::Command::min_args`] and [`crate::Command::max_args`] count the items that each shape names, 255 standing for any number. An object
    /// prefix such as `AXIS0` counts as the first axis.
    pub enum Shape {
        /// Nothing: `END`, `BREAK`.
        None = "None",
        /// One scalar: `ACC {rate}`.
        Value = "Value",
        /// Scalars, separated by blanks or commas: `TIM index preset`.
        Values = "Values",
        /// Axis names: `DRIVE ON X Y`.
        Axes = "Axes",
        /// Axes with a value or a tuple of values: `PPU X 4000 Y 4000`, `SLM X(24,0)`. The items are the axes; the sizes of a tuple are
        /// [`crate::Command::tuple_min`] to [`crate::Command::tuple_max`], a scalar being a tuple of one. A value may name an array (`CAM SEG`).
        AxisValues = "AxisValues",
        /// Axes with a source: `GEAR SRC X ENC2`. The items are the axes.
        AxisSources = "AxisSources",
        /// Axes with absolute or incremental targets, tuples for arcs and sines, and interpolation keywords in between. The items are the axes.
        Move = "Move",
        /// A flag with an optional sign and `BIT`, or an alias: `INH -516`.
        Bit = "Bit",
        /// A flag, then a move: `INT 24 X100`. The items are the axes.
        BitMove = "BitMove",
        /// A parameter with an optional sign, then a tuple: `IHPOS -P12290 (100, 5)`.
        ParameterTuple = "ParameterTuple",
        /// An object, parameter, array or number, or `NONE` or `CLOCK`: `SRC ENC0`.
        Source = "Source",
        /// `PROGn`, `PLCn` or `ALL`.
        Programs = "Programs",
        /// A plain number that may touch the word: `PROG 0`.
        Index = "Index",
        /// `MASTERn`, any number of them.
        Masters = "Masters",
        /// The rest of the line.
        Text = "Text",
        /// One string.
        String = "String",
        /// A label or a line number.
        Target = "Target",
        /// An expression in parentheses.
        Condition = "Condition",
        /// `IF (condition) {THEN ...}`
        If = "If",
        /// `FOR variable = start TO end {STEP step}`; the items are variable, start, end and step.
        For = "For",
        /// `PRINT {#device,} {USING "format" ;} {expression} {, | ;} ...`; the items are the expressions.
        Print = "Print",
        /// `INPUT {;} {#device,} {"prompt" ; | ,} variable ...`; the items are the variables.
        Input = "Input",
        /// `OPEN "device" AS #n`; the items are the string and the device.
        Open = "Open",
        /// `CLOSE #n`
        Close = "Close",
        /// `DIM kind{n} (count {, length})`; the kind is a daughter, the items are count and length.
        Dim = "Dim",
        /// `CLEAR {block}`; the block is a daughter, the item is its number.
        Clear = "Clear",
        /// `ATTACH SLAVEn AXISm "name"` and its relatives; the items are the objects, the first included, and the name.
        Attach = "Attach",
        /// `DETACH {object}`
        Detach = "Detach",
        /// The module words of `CONFIG`.
        Config = "Config",
        /// `#DEFINE name operand`
        Define = "Define",
        /// `operand = expression`
        Assignment = "Assignment",
        /// `_name`
        Label = "Label",
        /// A line number.
        LineNumber = "LineNumber",
        /// An object with its number, then a command or a daughter: `AXIS0 PPU 4000`.
        Object = "Object",
        /// Nothing of its own: a daughter follows.
        Parent = "Parent",
        /// Not known well enough: anything is accepted.
        Free = "Free",
    }
}
