//! Functions of one number.
//!
//! The angle unit of the trigonometric functions is documented nowhere; radians are assumed and degrees can be chosen.
//! Results come from one software library on every machine, so that a run gives the same bytes everywhere.

use std::fmt;

use acrc_catalog::{FunctionId, function};

use crate::fault::FaultKind;

/// Unit of the angles that `SIN` and its like take, and that `ASIN` and its like give.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum AngleUnit {
    /// Radians.
    #[default]
    Radians,
    /// Degrees.
    Degrees,
}

impl fmt::Display for AngleUnit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Radians => "radians",
            Self::Degrees => "degrees",
        })
    }
}

/// How an angle takes part in a function.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Angle {
    None,
    Argument,
    Result,
}

macro_rules! math_functions {
    ($($variant:ident = $id:ident $name:literal $angle:ident |$x:ident| $body:expr;)+) => {
        /// A function of one number.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub(crate) enum Math { $($variant,)+ }

        impl Math {
            /// The function of the catalogue.
            pub(crate) fn from_id(id: FunctionId) -> Option<Self> {
                match id {
                    $(function::$id => Some(Self::$variant),)+
                    _ => None,
                }
            }

            const fn name(self) -> &'static str {
                match self { $(Self::$variant => $name,)+ }
            }

            const fn angle(self) -> Angle {
                match self { $(Self::$variant => Angle::$angle,)+ }
            }

            /// The plain result; not a number outside of the domain.
            fn raw(self, argument: f64) -> f64 {
                match self { $(Self::$variant => { let $x = argument; $body })+ }
            }
        }
    };
}

math_functions! {
    Sin = SIN "SIN" Argument |x| libm::sin(x);
    Cos = COS "COS" Argument |x| libm::cos(x);
    Tan = TAN "TAN" Argument |x| libm::tan(x);
    Cot = COT "COT" Argument |x| 1.0 / libm::tan(x);
    Asin = ASIN "ASIN" Result |x| libm::asin(x);
    Acos = ACOS "ACOS" Result |x| libm::acos(x);
    Atan = ATAN "ATAN" Result |x| libm::atan(x);
    Acot = ACOT "ACOT" Result |x| std::f64::consts::FRAC_PI_2 - libm::atan(x);
    Sinh = SINH "SINH" None |x| libm::sinh(x);
    Cosh = COSH "COSH" None |x| libm::cosh(x);
    Tanh = TANH "TANH" None |x| libm::tanh(x);
    Coth = COTH "COTH" None |x| 1.0 / libm::tanh(x);
    Asinh = ASINH "ASINH" None |x| libm::asinh(x);
    Acosh = ACOSH "ACOSH" None |x| libm::acosh(x);
    Atanh = ATANH "ATANH" None |x| libm::atanh(x);
    Acoth = ACOTH "ACOTH" None |x| libm::atanh(1.0 / x);
    Ceil = CEIL "CEIL" None |x| x.ceil();
    Floor = FLOOR "FLOOR" None |x| x.floor();
    // The rule for halves is unknown: away from zero, as taught in school.
    Round = ROUND "ROUND" None |x| x.round();
    Trunc = TRUNC "TRUNC" None |x| x.trunc();
    Ln = LN "LN" None |x| libm::log(x);
    Log = LOG "LOG" None |x| libm::log10(x);
    Sqrt = SQRT "SQRT" None |x| x.sqrt();
    Exp = EXP "EXP" None |x| libm::exp(x);
    Absf = ABSF "ABSF" None |x| x.abs();
}

impl Math {
    /// Whether its result depends on the undocumented angle unit.
    pub(crate) fn has_angle(self) -> bool {
        self.angle() != Angle::None
    }

    /// Evaluates it.
    pub(crate) fn evaluate(self, argument: f64, unit: AngleUnit) -> Result<f64, FaultKind> {
        let degrees = unit == AngleUnit::Degrees;
        let result = match self.angle() {
            Angle::Argument if degrees => self.raw(argument.to_radians()),
            Angle::Result if degrees => self.raw(argument).to_degrees(),
            _ => self.raw(argument),
        };
        if result.is_finite() { Ok(result) } else { Err(FaultKind::Domain { function: self.name(), argument }) }
    }
}

/// Exponents up to this are computed by multiplication, which is exact as long as the result is.
const MULTIPLIED_EXPONENT: f64 = 64.0;

/// `base ** exponent`
pub(crate) fn power(base: f64, exponent: f64) -> Result<f64, FaultKind> {
    if base == 0.0 && exponent < 0.0 {
        return Err(FaultKind::DivisionByZero);
    }
    let result = if exponent.trunc() == exponent && exponent.abs() <= MULTIPLIED_EXPONENT {
        multiplied(base, exponent)
    } else {
        libm::pow(base, exponent)
    };
    if result.is_nan() {
        return Err(FaultKind::Domain { function: "**", argument: base });
    }
    if result.is_finite() { Ok(result) } else { Err(FaultKind::NotFinite { operation: "**" }) }
}

/// A whole power by repeated squaring.
fn multiplied(base: f64, exponent: f64) -> f64 {
    let mut rest = exponent.abs() as u32;
    let (mut result, mut square) = (1.0, base);
    while rest > 0 {
        if rest & 1 == 1 {
            result *= square;
        }
        rest >>= 1;
        square *= square;
    }
    if exponent < 0.0 { 1.0 / result } else { result }
}
