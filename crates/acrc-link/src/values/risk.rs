//! What a write may do to the machine.

use acrc_catalog::{Access, BitKind, Confidence, Space, bit, first_system_flag, flags_in, law, parameter};

use super::Register;

/// What a write may do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Risk {
    /// It changes a number or a flag that means something to programs only.
    None,
    /// It switches an output.
    Output,
    /// It changes how the controller works, and may move an axis, enable a drive, or start or stop a program.
    Machine,
    /// Programs can only read it, and the catalogue is sure of that.
    ReadOnly,
}

/// Flags that only stop something when they are set, and their clearing only allows what has to be asked for again.
const SAFE_TO_SET: [acrc_catalog::Law; 2] = [law::KILL_ALL_MOTION_REQUEST, law::KILL_ALL_MOVES];

/// What writing a value to a register may do.
pub fn risk(register: Register, value: f64) -> Risk {
    match register {
        Register::Bit(number) => flag_risk(number, value != 0.0),
        Register::Parameter(number) => {
            let flags = flags_in(number);
            if !flags.is_empty() {
                // A word changes all of its flags at once.
                return flags.map(|flag| flag_risk(flag, true)).max().unwrap_or(Risk::None).min(Risk::Machine);
            }
            let info = parameter(number);
            match (info.access, info.object) {
                (Access::Read, _) if info.confidence != Confidence::Low => Risk::ReadOnly,
                (_, Space::User) => Risk::None,
                _ => Risk::Machine,
            }
        }
    }
}

fn flag_risk(number: u32, set: bool) -> Risk {
    let info = bit(number);
    let stops = SAFE_TO_SET.iter().any(|law| law.index_of(number).is_some());
    match (info.access, info.kind, info.object) {
        (Access::Read, ..) if info.confidence != Confidence::Low => Risk::ReadOnly,
        (_, Some(BitKind::Output), _) | (_, _, Space::Output) => Risk::Output,
        (_, Some(BitKind::User), _) | (_, _, Space::User) => Risk::None,
        _ if set && stops => Risk::None,
        _ if number < first_system_flag() => Risk::Output,
        _ => Risk::Machine,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_moves_enables_or_switches_is_known() {
        for (register, value, expected) in [
            (Register::Parameter(0), 1.0, Risk::None),
            (Register::Bit(32), 1.0, Risk::Output),
            (Register::Bit(8465), 1.0, Risk::Machine),
            (Register::Bit(8467), 1.0, Risk::None),
            (Register::Bit(8467), 0.0, Risk::Machine),
            (Register::Bit(516), 1.0, Risk::ReadOnly),
            (Register::Bit(796), 1.0, Risk::Machine),
            (Register::Parameter(4097), 1.0, Risk::Output),
            (Register::Parameter(12291), 1.0, Risk::ReadOnly),
            (Register::Parameter(12290), 1.0, Risk::Machine),
        ] {
            assert_eq!(risk(register, value), expected, "{register}");
        }
    }
}
