//! The costs of things in memory, a constant each.

use super::{confidence, line};
use crate::catalogue::rows::MemoryFile;

pub fn constants(memory: &MemoryFile) -> String {
    let mut out = String::new();
    let factory = &memory.factory;
    line(
        &mut out,
        "/// Memory that a controller with factory settings gives to its first programs together, in bytes.",
    );
    line(&mut out, format_args!("pub const FACTORY_PROGRAM_BYTES: u32 = {};", factory.program_bytes));
    line(&mut out, "/// How many programs share it equally, from `PROG0` on.");
    line(&mut out, format_args!("pub const FACTORY_PROGRAMS: u8 = {};", factory.programs));
    line(&mut out, "/// Bytes of each communication stream buffer of a controller with factory settings.");
    line(&mut out, format_args!("pub const FACTORY_STREAM_BYTES: u32 = {};", factory.stream_bytes));
    for row in &memory.cost {
        line(&mut out, format_args!("/// {}.", row.name));
        line(
            &mut out,
            format_args!(
                "pub const {}: Cost = Cost {{ name: {:?}, unit: {:?}, each: {}, once: {}, character: {}, most: {:?}, level: {:?}, \
                 note: {:?}, source: {:?}, confidence: {} }};",
                row.constant,
                row.name,
                row.unit,
                row.each,
                row.once,
                row.character,
                row.most,
                row.level,
                row.note,
                row.source,
                confidence(&row.confidence)
            ),
        );
    }
    let names: Vec<&str> = memory.cost.iter().map(|row| row.constant.as_str()).collect();
    line(&mut out, "/// Every cost, in the order of the data file.");
    line(&mut out, format_args!("pub const ALL: &[Cost] = &[{}];", names.join(", ")));
    out
}
