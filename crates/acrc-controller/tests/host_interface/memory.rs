//! Memory by address.

use acrc_catalog::OperandClass;
use acrc_controller::{Conversion, Options};
use proptest::prelude::*;

use crate::support::{Bench, TWO_AXES};

const KINDS: [OperandClass; 8] = [
    OperandClass::Dv,
    OperandClass::Da,
    OperandClass::Sv,
    OperandClass::Sa,
    OperandClass::Lv,
    OperandClass::La,
    OperandClass::StringV,
    OperandClass::StringA,
];

/// Program 5 has something of every kind.
const EVERYTHING: &str = "SYS\nCLEAR\nDIM P(10)\nDIM PROG5(8192)\nPROG5\nDIM LV(3)\nDIM SV(4)\nDIM DV(5)\nDIM $V(2, 10)\nDIM LA(2)\nDIM LA0(6)\nDIM LA1(7)\n\
                          DIM SA(1)\nDIM SA0(8)\nDIM DA(2)\nDIM DA1(9)\nDIM $A(1)\nDIM $A0(3, 5)\n\
                          LV2 = -7\nSV3 = 2.5\nDV4 = 0.1\nLA1(6) = 123\nSA0(7) = -1.5\nDA1(8) = 1E300\n\
                          $V1 = \"Hello\"\n$A0(2) = \"abcde\"\n";

fn peek(bench: &Bench, conversion: Conversion, address: u32, count: usize) -> Result<Vec<u32>, String> {
    let mut fields = vec![0; count];
    bench.controller.peek(conversion, address, &mut fields).map_err(|error| error.to_string())?;
    Ok(fields)
}

fn word(bench: &Bench, address: u32) -> u32 {
    peek(bench, Conversion::Long, address, 1).expect("something stands there")[0]
}

fn singles(bench: &Bench, conversion: Conversion, address: u32, count: usize) -> Vec<f32> {
    let fields = peek(bench, conversion, address, count).expect("numbers stand there");
    fields.into_iter().map(f32::from_bits).collect()
}

fn poke(bench: &mut Bench, conversion: Conversion, address: u32, fields: &[u32]) -> Result<(), String> {
    bench.controller.poke(conversion, address, fields, &mut bench.log).map_err(|error| error.to_string())
}

#[test]
fn a_kind_without_memory_has_no_address() {
    let bench = Bench::new(TWO_AXES);
    for kind in KINDS {
        assert_eq!(bench.controller.address_of(5, kind), 0);
        assert!((16..=u8::MAX).all(|program| bench.controller.address_of(program, kind) == 0));
    }
}

#[test]
fn variables_are_a_count_and_numbers() {
    let bench = Bench::new(EVERYTHING);
    let at = |kind| bench.controller.address_of(5, kind);
    let longs = at(OperandClass::Lv);
    assert_eq!(peek(&bench, Conversion::Long, longs, 4), Ok(vec![3, 0, 0, (-7_i32).cast_unsigned()]));
    let floats = at(OperandClass::Sv);
    assert_eq!(word(&bench, floats), 4);
    assert_eq!(singles(&bench, Conversion::Single, floats + 1, 4), [0.0, 0.0, 0.0, 2.5]);
    let doubles = at(OperandClass::Dv);
    assert_eq!(word(&bench, doubles), 5);
    assert_eq!(singles(&bench, Conversion::Double, doubles + 1, 5), [0.0, 0.0, 0.0, 0.0, 0.1]);
    let halves = peek(&bench, Conversion::Long, doubles + 9, 2).expect("DV4");
    assert_eq!(u64::from(halves[1]) << 32 | u64::from(halves[0]), 0.1_f64.to_bits());
}

#[test]
fn arrays_are_a_count_and_addresses_of_a_count_and_numbers() {
    let bench = Bench::new(EVERYTHING);
    let at = |kind| bench.controller.address_of(5, kind);
    let table = peek(&bench, Conversion::Long, at(OperandClass::La), 3).expect("a table");
    assert_eq!((table[0], word(&bench, table[1]), word(&bench, table[2])), (2, 6, 7));
    assert_eq!(word(&bench, table[2] + 7), 123);
    let table = peek(&bench, Conversion::Long, at(OperandClass::Sa), 2).expect("a table");
    assert_eq!((table[0], word(&bench, table[1])), (1, 8));
    assert_eq!(singles(&bench, Conversion::Single, table[1] + 8, 1), [-1.5]);
    let table = peek(&bench, Conversion::Long, at(OperandClass::Da), 3).expect("a table");
    // DA0 has no elements yet, and no single is as large as DA1(8).
    assert_eq!((table[0], table[1], word(&bench, table[2])), (2, 0, 9));
    assert_eq!(singles(&bench, Conversion::Double, table[2] + 17, 1), [f32::MAX]);
}

#[test]
fn strings_are_a_length_and_characters() {
    let bench = Bench::new(EVERYTHING);
    let table = peek(&bench, Conversion::Long, bench.controller.address_of(5, OperandClass::StringV), 3).expect("$V");
    assert_eq!((table[0], word(&bench, table[1])), (2, 0));
    let hello = peek(&bench, Conversion::Long, table[2], 4).expect("$V1");
    assert_eq!(hello, [5, u32::from_le_bytes(*b"Hell"), u32::from(b'o'), 0]);
    assert!(peek(&bench, Conversion::Long, table[2], 5).is_err());
    let arrays = peek(&bench, Conversion::Long, bench.controller.address_of(5, OperandClass::StringA), 2).expect("$A");
    let strings = peek(&bench, Conversion::Long, arrays[1], 4).expect("$A0");
    assert_eq!((arrays[0], strings[0], word(&bench, strings[1])), (1, 3, 0));
    assert_eq!(peek(&bench, Conversion::Long, strings[3], 2), Ok(vec![5, u32::from_le_bytes(*b"abcd")]));
}

#[test]
fn strings_are_written_length_first() {
    let mut bench = Bench::new(EVERYTHING);
    let table = peek(&bench, Conversion::Long, bench.controller.address_of(5, OperandClass::StringV), 2).expect("$V");
    let text = [6, u32::from_le_bytes(*b"Good"), u32::from_le_bytes(*b"byXX")];
    assert_eq!(poke(&mut bench, Conversion::Long, table[1], &text), Ok(()));
    bench.ask("PROG5");
    assert_eq!(bench.ask("? $V0"), "Goodby");
    let long = "a string of 11 characters does not fit: DIM gives it 10".to_owned();
    assert_eq!(poke(&mut bench, Conversion::Long, table[1], &[11]), Err(long));
    let wrong = format!("address 0x{:08X} does not hold a 32-bit floating point number", table[1]);
    assert_eq!(poke(&mut bench, Conversion::Single, table[1], &[1]), Err(wrong));
}

#[test]
fn user_parameters_stand_where_the_system_pointer_says() {
    for (model, pointer) in [("ACR8020", 0x40_0009), ("ACR1500", 0xC0_8008), ("ACR8000", 0x40_3E08)] {
        let none = Bench::of_model("SYS\n", model, Options::default());
        assert_eq!(word(&none, pointer), 0, "{model}");
        let mut bench = Bench::of_model("SYS\nCLEAR\nDIM P(10)\n", model, Options::default());
        let base = word(&bench, pointer);
        assert_eq!(word(&bench, base), 10, "{model}");
        bench.ask("P3 = -2.75");
        assert_eq!(singles(&bench, Conversion::Double, base + 1 + 2 * 3, 1), [-2.75], "{model}");
        assert_eq!(bench.controller.parameter_address(3), base + 7, "{model}");
        assert_eq!(poke(&mut bench, Conversion::Double, base + 1, &[1.5_f32.to_bits(), 2.5_f32.to_bits()]), Ok(()));
        assert_eq!(bench.ask("? P0 : ? P1"), "1.5 2.5", "{model}");
    }
}

#[test]
fn parameters_have_addresses() {
    let mut bench = Bench::new(TWO_AXES);
    let address = |bench: &Bench, parameter| bench.controller.parameter_address(parameter);
    for missing in [10, 4095, 60_000, u32::MAX] {
        assert_eq!(address(&bench, missing), 0, "P{missing}");
    }
    let outputs = address(&bench, 4097);
    // The guide's example: all outputs off, then output 32 on.
    bench.ask("SET 40");
    bench.controller.mask(outputs, u32::MAX, 1, &mut bench.log).expect("a long integer");
    assert_eq!((bench.controller.parameter_long(4097), word(&bench, outputs)), (Some(1), 1));
    let units = address(&bench, 12375);
    assert_eq!(singles(&bench, Conversion::Single, units, 1), [1000.0]);
    let position = address(&bench, 12288);
    assert_eq!(poke(&mut bench, Conversion::Long, position, &[2500]), Ok(()));
    assert_eq!(bench.position(0), 2.5);
}

#[test]
fn numbers_are_written_in_their_own_type() {
    let mut bench = Bench::new(EVERYTHING);
    let at = |bench: &Bench, kind| bench.controller.address_of(5, kind);
    let (longs, floats, doubles) =
        (at(&bench, OperandClass::Lv), at(&bench, OperandClass::Sv), at(&bench, OperandClass::Dv));
    assert_eq!(poke(&mut bench, Conversion::Long, longs + 1, &[1, 2]), Ok(()));
    assert_eq!(poke(&mut bench, Conversion::Single, floats + 1, &[0.5_f32.to_bits()]), Ok(()));
    assert_eq!(poke(&mut bench, Conversion::Long, floats + 2, &[0.25_f32.to_bits()]), Ok(()));
    assert_eq!(poke(&mut bench, Conversion::Double, doubles + 1, &[0.5_f32.to_bits(), 8.0_f32.to_bits()]), Ok(()));
    let [low, high] = [0.1_f64.to_bits() as u32, (0.1_f64.to_bits() >> 32) as u32];
    assert_eq!(poke(&mut bench, Conversion::Long, doubles + 5, &[low, high]), Ok(()));
    bench.ask("PROG5");
    assert_eq!(bench.ask("? LV0 : ? LV1"), "1 2");
    assert_eq!(bench.ask("? SV0 : ? SV1"), "0.5 0.25");
    assert_eq!(bench.ask("? DV0 : ? DV1 : ? DV2"), "0.5 8 0.1");
}

#[test]
fn what_is_no_number_of_that_type_is_refused() {
    let mut bench = Bench::new(EVERYTHING);
    let at = |bench: &Bench, kind| bench.controller.address_of(5, kind);
    let (longs, floats, doubles) =
        (at(&bench, OperandClass::Lv), at(&bench, OperandClass::Sv), at(&bench, OperandClass::Dv));
    for (conversion, address) in [
        (Conversion::Single, longs + 1),
        (Conversion::Double, longs + 1),
        (Conversion::Double, floats + 1),
        (Conversion::Single, doubles + 1),
        (Conversion::Double, doubles + 2),
        (Conversion::Single, longs),
    ] {
        assert!(peek(&bench, conversion, address, 1).is_err(), "{conversion:?} {address:08X}");
        assert!(poke(&mut bench, conversion, address, &[0]).is_err(), "{conversion:?} {address:08X}");
    }
    for address in [longs, floats, doubles, at(&bench, OperandClass::La), at(&bench, OperandClass::La) + 1] {
        let fixed = format!("address 0x{address:08X} holds a count or an address, which only DIM changes");
        assert_eq!(poke(&mut bench, Conversion::Long, address, &[9]), Err(fixed));
    }
    assert_eq!(
        poke(&mut bench, Conversion::Single, floats + 1, &[f32::NAN.to_bits()]),
        Err("NaN is no finite number".to_owned())
    );
    for address in [floats + 1, doubles + 1, longs] {
        let masked = bench.controller.mask(address, 1, 1, &mut bench.log).map_err(|error| error.to_string());
        assert_eq!(masked, Err(format!("address 0x{address:08X} holds no long integer, so there are no bits to mask")));
    }
}

#[test]
fn what_lies_outside_is_refused() {
    let mut bench = Bench::new(EVERYTHING);
    let longs = bench.controller.address_of(5, OperandClass::Lv);
    let outside = |address: u32| format!("nothing stands at address 0x{address:08X}");
    for address in [0, 1, 0x40_0009, longs - 1, longs + 4, u32::MAX] {
        assert_eq!(peek(&bench, Conversion::Long, address, 1), Err(outside(address)));
        assert_eq!(poke(&mut bench, Conversion::Long, address, &[0]), Err(outside(address)));
    }
    assert_eq!(peek(&bench, Conversion::Long, longs, 5), Err(outside(longs + 4)));
    assert_eq!(peek(&bench, Conversion::Long, u32::MAX, 2), Err(outside(u32::MAX)));
    // What stands in front of the refused address is written.
    assert_eq!(poke(&mut bench, Conversion::Long, longs + 3, &[11, 12]), Err(outside(longs + 4)));
    assert_eq!(word(&bench, longs + 3), 11);
}

#[test]
fn an_address_lasts_until_dim_changes_what_it_names() {
    let mut bench = Bench::new(EVERYTHING);
    let longs = bench.controller.address_of(5, OperandClass::Lv);
    bench.ask("PROG5");
    bench.ask("DIM LA0(5)");
    bench.ask("LV0 = 4");
    assert_eq!((bench.controller.address_of(5, OperandClass::Lv), word(&bench, longs + 1)), (longs, 4));
    bench.ask("CLEAR");
    assert_eq!(bench.controller.address_of(5, OperandClass::Lv), 0);
    assert!(peek(&bench, Conversion::Long, longs, 1).is_err());
}

#[test]
fn a_program_that_goes_round_in_a_circle_sees_what_is_poked() {
    let mut bench =
        Bench::new("SYS\nDIM P(10)\nPROG5\nDIM LV(1)\nPROGRAM\nWHILE (LV0 = 0)\nWEND\nP1 = LV0\nENDP\nRUN\n");
    bench.pass(100.0);
    let longs = bench.controller.address_of(5, OperandClass::Lv);
    assert_eq!(poke(&mut bench, Conversion::Long, longs + 1, &[42]), Ok(()));
    bench.pass(0.1);
    assert_eq!(bench.controller.parameter_long(1), Some(42));
}

/// Addresses near what exists, and others.
fn address(bases: Vec<u32>) -> impl Strategy<Value = u32> {
    prop_oneof![
        any::<u32>(),
        (proptest::sample::select(bases), -4_i32..600).prop_map(|(base, offset)| base.wrapping_add_signed(offset)),
    ]
}

fn conversion() -> impl Strategy<Value = Conversion> {
    proptest::sample::select(vec![Conversion::Long, Conversion::Double, Conversion::Single])
}

fn bases() -> Vec<u32> {
    let bench = Bench::of_model(EVERYTHING, "ACR8020", Options::default());
    let mut bases: Vec<u32> = KINDS.map(|kind| bench.controller.address_of(5, kind)).to_vec();
    for kind in [OperandClass::Da, OperandClass::Sa, OperandClass::La, OperandClass::StringA] {
        bases.push(word(&bench, bench.controller.address_of(5, kind) + 1));
    }
    bases.extend([0x40_0009, word(&bench, 0x40_0009), bench.controller.parameter_address(4096)]);
    bases.extend([bench.controller.parameter_address(12288), bench.controller.parameter_address(8192)]);
    bases
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_address_does_harm(
        orders in proptest::collection::vec((address(bases()), conversion(), any::<u32>(), 0_u8..4), 1..40),
    ) {
        let mut bench = Bench::of_model(EVERYTHING, "ACR8020", Options::default());
        for (address, conversion, field, what) in orders {
            match what {
                0 => {
                    let _ = peek(&bench, conversion, address, 255);
                }
                1 => {
                    let _ = bench.controller.mask(address, field, field.rotate_left(7), &mut bench.log);
                }
                _ => {
                    let written = poke(&mut bench, conversion, address, &[field]);
                    let read = peek(&bench, conversion, address, 1);
                    // Whatever can be written can be read.
                    prop_assert!(read.is_ok() || written.is_err());
                }
            }
        }
        bench.pass(0.01);
    }

    #[test]
    fn a_host_reads_what_a_program_reads(number in 0_u32..10, value in -1e6_f64..1e6) {
        let mut bench = Bench::new(EVERYTHING);
        bench.ask("PROG5");
        bench.ask(&format!("P{number} = {value} : DV0 = {value} : SV0 = {value} : LV0 = {value}"));
        let numbers = [
            (format!("P{number}"), bench.controller.parameter_address(number), Conversion::Double),
            ("DV0".to_owned(), bench.controller.address_of(5, OperandClass::Dv) + 1, Conversion::Double),
            ("SV0".to_owned(), bench.controller.address_of(5, OperandClass::Sv) + 1, Conversion::Single),
        ];
        for (name, address, conversion) in numbers {
            let shown: f64 = bench.ask(&format!("? {name}")).parse().expect("a number");
            let read = f64::from(singles(&bench, conversion, address, 1)[0]);
            prop_assert!((shown - read).abs() <= shown.abs() * 1e-6, "{name}: {shown} {read}");
        }
        let long = bench.controller.address_of(5, OperandClass::Lv) + 1;
        prop_assert_eq!(bench.ask("? LV0"), word(&bench, long).cast_signed().to_string());
    }
}
