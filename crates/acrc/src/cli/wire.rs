//! `--wire`: the other readings where the documents contradict each other (docs/fidelity.md, "Wire").

use acrc_wire::{
    ByteOrder, CrcRule, CurveFields, FirstByte, FlagHeaders, MovePadding, OverrideMasks, RovHeader, SplineFields,
    WatchdogUnit, WireOptions,
};

/// One reading: what is written, and what it sets.
type Reading = (&'static str, &'static str, fn(&mut WireOptions));

/// Every reading that is not the default.
const READINGS: [Reading; 10] = [
    ("first-byte", "zero", |wire| wire.first_byte = FirstByte::Zero),
    ("flag-headers", "set-is-1d", |wire| wire.flag_headers = FlagHeaders::SetIs1D),
    ("rov-header", "07", |wire| wire.rov_header = RovHeader::Is07),
    ("override-masks", "together", |wire| wire.override_masks = OverrideMasks::Together),
    ("curve-fields", "before-slave-10", |wire| wire.curve_fields = CurveFields::BeforeSlave10),
    ("spline-fields", "both", |wire| wire.spline_fields = SplineFields::BothByCode3),
    ("move-padding", "behind-header", |wire| wire.move_padding = MovePadding::BehindHeader),
    ("watchdog-unit", "seconds", |wire| wire.watchdog_unit = WatchdogUnit::Seconds),
    ("management-order", "little-endian", |wire| wire.management_order = ByteOrder::LittleEndian),
    ("crc", "high-bit-first", |wire| wire.crc = CrcRule::HighBitFirst),
];

/// Readings as they are written: `KEY=VALUE,...`.
pub(super) fn parse_wire(text: &str) -> Result<WireOptions, String> {
    let mut options = WireOptions::default();
    for part in text.split(',').map(str::trim).filter(|part| !part.is_empty()) {
        let written = part.split_once('=').map(|(key, value)| (key.trim(), value.trim()));
        let known = READINGS.iter().find(|(key, value, _)| written == Some((*key, *value)));
        let (_, _, set) = known.ok_or_else(|| {
            let readings: Vec<String> = READINGS.iter().map(|(key, value, _)| format!("{key}={value}")).collect();
            format!("`{part}` is no reading; there are {}", readings.join(", "))
        })?;
        set(&mut options);
    }
    Ok(options)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn readings_are_set_by_name() {
        let expected =
            WireOptions { crc: CrcRule::HighBitFirst, first_byte: FirstByte::Zero, ..WireOptions::default() };
        assert_eq!(parse_wire("crc=high-bit-first, first-byte=zero"), Ok(expected));
        assert_eq!(parse_wire(""), Ok(WireOptions::default()));
        assert!(
            parse_wire("crc=low")
                .is_err_and(|error| error.starts_with("`crc=low` is no reading; there are first-byte=zero,"))
        );
    }
}
