//! The guide's table "How Much Memory?", row by row: unit, bytes of each, bytes once, bytes a character.

use acrc_catalog::memory::{self, LocalBlock};
use acrc_catalog::{OperandClass, memory::Cost};

#[test]
fn the_table_of_the_guide() {
    let rows: [(Cost, u32, u32, u32); 18] = [
        (memory::LV, 4, 0, 0),
        (memory::SV, 4, 0, 0),
        (memory::DV, 8, 0, 0),
        (memory::STRING_V, 4, 0, 1),
        (memory::REFERENCES, 4, 4, 0),
        (memory::LA, 4, 4, 0),
        (memory::SA, 4, 4, 0),
        (memory::DA, 8, 4, 0),
        (memory::STRING_A, 0, 0, 1),
        (memory::COMMANDS, 4, 0, 0),
        (memory::OPERATORS, 4, 0, 0),
        (memory::LONGS, 4, 0, 0),
        (memory::SINGLES, 4, 0, 0),
        (memory::DOUBLES, 8, 0, 0),
        (memory::STRINGS, 4, 0, 1),
        (memory::CALLS, 4, 0, 0),
        (memory::ALIASES, 48, 16, 0),
        (memory::MOVES, 136, 0, 0),
    ];
    for (row, each, once, character) in rows {
        assert_eq!((row.each, row.once, row.character), (each, once, character), "{}", row.name);
    }
    assert_eq!(memory::ALL.len(), rows.len() + 1, "user parameters are no row of the guide");
}

#[test]
fn blocks_of_local_variables() {
    for (block, count, length, bytes) in [
        (LocalBlock::Variables(OperandClass::Lv), 2, 0, 8),
        (LocalBlock::Variables(OperandClass::StringV), 10, 80, 10 * (4 + 80)),
        (LocalBlock::References(OperandClass::La), 1, 0, 4 + 4),
        (LocalBlock::Array(OperandClass::Da), 3, 0, 3 * 8 + 4),
        (LocalBlock::Array(OperandClass::StringA), 5, 20, 5 * 20),
        (LocalBlock::Array(OperandClass::StringA), 5, 0, 5),
        (LocalBlock::Moves, 10, 0, 10 * 136),
    ] {
        assert_eq!(block.bytes(count, length), bytes, "{block:?}");
    }
    assert_eq!(LocalBlock::Array(OperandClass::Da).bytes(u64::MAX, 0), u64::MAX);
}

#[test]
fn factory_settings() {
    assert_eq!((memory::FACTORY_PROGRAM_BYTES, memory::FACTORY_PROGRAMS), (512 * 1024, 8));
    assert_eq!((memory::FACTORY_SHARE, memory::FACTORY_STREAM_BYTES), (65_536, 256));
}
