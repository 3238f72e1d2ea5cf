//! Parameters and flags by number.

use acrc_catalog::{
    Access, BitKind, Known, SetBy, Space, ValueType, all_bits, all_parameters, bit, bit_number, command, flag_words,
    law, parameter, parameter_number,
};
use proptest::prelude::*;

#[test]
fn named_parameters() {
    let cases: [(u32, Space, Option<u32>, &str); 22] = [
        (50, Space::User, None, "user_variable"),
        (4096, Space::Flags, None, "onboard_inputs"),
        (4121, Space::Flags, Some(1), "axis_primary_flags_0_7"),
        (4361, Space::Flags, Some(1), "axis_quaternary_flags"),
        (4448, Space::Flags, None, "canopen_control_status"),
        (6144, Space::Encoder, Some(0), "encoder_position"),
        (6176, Space::Encoder, Some(2), "encoder_position"),
        (6916, Space::System, None, "clock_ms"),
        (8193, Space::Master, Some(0), "vector_velocity"),
        (12290, Space::Axis, Some(0), "actual_position"),
        (12292 + 256, Space::Axis, Some(1), "hardware_capture"),
        (12360, Space::Axis, Some(0), "invk_input"),
        (12617, Space::Axis, Some(1), "invk_output"),
        (12375, Space::Axis, Some(0), "ppu"),
        (14336, Space::Axis, Some(8), "current_position"),
        (28693, Space::DriveTalk, Some(0), "tpe"),
        (28928, Space::DriveTalk, Some(1), "device_number"),
        (32779, Space::CanOpen, None, "bus_state"),
        (33040, Space::CanOpen, Some(1), "node_id"),
        (33288, Space::CanOpen, Some(0), "node0_adc_input"),
        (33792, Space::CanOpen, Some(1), "node1_dac_output"),
        (38912, Space::User, None, "user_long"),
    ];
    for (number, object, index, field) in cases {
        let info = parameter(number);
        assert_eq!(
            (info.known, info.object, info.object_index, info.field),
            (Known::Row, object, index, field),
            "P{number}"
        );
    }
}

#[test]
fn details_of_a_parameter() {
    let info = parameter(12291);
    assert_eq!((info.ty, info.access, info.unit), (Some(ValueType::Long), Access::Read, "counts"));
    assert_eq!(parameter(12346).unit, "units/s");
    assert_eq!(parameter(33808).element, Some(1));
    assert_eq!(parameter(5).element, Some(5));
    assert_eq!(parameter(33281).ty, None);
}

#[test]
fn parameters_without_a_row() {
    let info = parameter(14199);
    assert_eq!((info.known, info.object, info.object_index), (Known::Range, Space::Axis, Some(7)));
    assert_eq!(parameter(5000).known, Known::Unknown);
    assert_eq!(parameter(4160).known, Known::Unknown);
    assert_eq!(parameter(11297).object_index, Some(12), "a slip of one source, which lies in the master block");
    assert_eq!(parameter(20000).known, Known::Unknown);
    assert_eq!(parameter(39424).known, Known::OutOfSpace);
    assert_eq!(parameter(u32::MAX).known, Known::OutOfSpace);
}

#[test]
fn named_flags() {
    let cases: [(u32, Space, Option<u32>, &str); 22] = [
        (24, Space::Input, None, "onboard_input"),
        (34, Space::Output, None, "onboard_output"),
        (150, Space::User, None, "user_flag_1_4"),
        (516, Space::Master, Some(0), "in_motion"),
        (522 + 32, Space::Master, Some(1), "kill_all_moves"),
        (7466, Space::Master, Some(9), "kill_all_moves"),
        (769, Space::Axis, Some(0), "not_excess_error"),
        (824, Space::Axis, Some(1), "jog_active"),
        (841, Space::Axis, Some(2), "capture_complete"),
        (1048, Space::Program, Some(0), "program_pause"),
        (2593, Space::Encoder, Some(1), "encoder_signal_lost"),
        (5646, Space::System, None, "mei_open"),
        (8497, Space::Axis, Some(1), "drive_enable"),
        (10537, Space::DriveTalk, Some(1), "select_tpe"),
        (11104, Space::Stream, None, "com2_auto_address"),
        (11122, Space::Stream, None, "com2_drive_lost"),
        (11269, Space::CanOpen, None, "canopen_network_operational"),
        (12033, Space::CanOpen, Some(0), "node0_output"),
        (13057, Space::CanOpen, Some(1), "node1_output"),
        (16198, Space::Axis, Some(2), "home_found"),
        (16649, Space::Epl, None, "epl_network_operational"),
        (17161, Space::Axis, Some(0), "jog_home_direction"),
    ];
    for (number, object, index, field) in cases {
        let info = bit(number);
        assert_eq!(
            (info.known, info.object, info.object_index, info.field),
            (Known::Row, object, index, field),
            "BIT{number}"
        );
    }
}

#[test]
fn details_of_a_flag() {
    let info = bit(8499);
    assert_eq!((info.word, info.index, info.kind), (Some(4361), 19, Some(BitKind::Control)));
    assert_eq!((bit(9505).object_index, bit(9505).element), (Some(1), Some(1)));
    assert_eq!((bit(13058).element, bit(24).element), (Some(2), Some(24)));
    assert_eq!((bit(1961).field, bit(1961).element), ("wizard_drive_faulted", Some(9)));
}

#[test]
fn flags_without_a_row() {
    let range = bit(1112 + 2);
    assert_eq!((range.known, range.object, range.object_index), (Known::Range, Space::Program, Some(2)));
    assert_eq!(
        (bit(2100).known, bit(40_000).known, bit(65_535).known),
        (Known::Unknown, Known::Unknown, Known::Unknown)
    );
    assert_eq!((bit(65_536).known, bit(65_536).word), (Known::OutOfSpace, None));
}

#[test]
fn numbers_of_fields() {
    assert_eq!(bit_number("kill_all_motion_request", 1), Some(8499));
    assert_eq!(bit_number("kill_all_moves", 7), Some(746));
    assert_eq!(bit_number("kill_all_moves", 8), Some(7434));
    assert_eq!(bit_number("kill_all_moves", 16), None);
    assert_eq!(parameter_number("actual_position", 3), Some(13058));
    assert_eq!(parameter_number("clock_ms", 0), Some(6916));
    assert_eq!(parameter_number("clock_ms", 1), None);
    assert_eq!(parameter_number("no_such_field", 0), None);
}

#[test]
fn laws_are_constants() {
    const MASTER_9: u32 = law::IN_MOTION.at(9);
    assert_eq!(MASTER_9, 7460);
    assert_eq!(law::CURRENT_POSITION.at(15), 16128);
    assert_eq!(law::CURRENT_POSITION.get(16), None);
    assert_eq!((law::IN_MOTION.count(), law::IN_MOTION.index_of(7460)), (16, Some(9)));
    assert_eq!((law::MEI_OPEN.at(0), law::MEI_OPEN.index_of(5646)), (5646, Some(0)));
    assert_eq!(law::IN_MOTION.index_of(517), None);
}

/// Numbers that the documents use, by the count of rows and groups that they should resolve to.
#[test]
fn numbers_of_the_documents_resolve() {
    let fields = (6144..=6176)
        .step_by(16)
        .chain(12288..=12292)
        .chain(32768..=32779)
        .chain((33024..=33072).step_by(16))
        .chain(33280..=33295);
    for number in
        fields.chain([100, 131, 4095, 4097, 4104, 6916, 12361, 12617, 28672, 28673, 28693, 28928, 28929, 28949, 33792])
    {
        assert_eq!(parameter(number).known, Known::Row, "P{number}");
    }
    let named = (128..=131)
        .chain([777, 809, 841])
        .chain(8464..=8465)
        .chain(16132..=16135)
        .chain(16152..=16154)
        .chain(11265..=11273);
    for number in named.chain([
        520, 521, 522, 523, 792, 1032, 1920, 2047, 2560, 2561, 2592, 5645, 5647, 5651, 8191, 8469, 8479, 10500, 10532,
    ]) {
        assert!(matches!(bit(number).known, Known::Row | Known::Unknown), "BIT{number}");
        assert_eq!(bit(number).known == Known::Unknown, number == 8191, "BIT{number}");
    }
    for (first, last) in [(8960, 9455), (9472, 9983), (9984, 10495), (10496, 11007), (11040, 11071), (11232, 11263)] {
        assert!(
            matches!(bit(first).known, Known::Row) && matches!(bit(last).known, Known::Row | Known::Range),
            "BIT{first}-{last}"
        );
    }
}

#[test]
fn every_row_is_reached_at_both_ends() {
    for row in all_parameters() {
        for number in [row.law.first, row.law.last()] {
            let winner = parameter(number).row.expect("a row");
            assert!(winner == row || winner.law.count < row.law.count, "P{number}");
        }
    }
    for row in all_bits() {
        for number in [row.law.first, row.law.last()] {
            let winner = bit(number).row.expect("a row");
            assert!(winner == row || winner.law.count < row.law.count, "BIT{number}");
        }
    }
}

#[test]
fn the_flags_in_a_word() {
    assert_eq!(acrc_catalog::flags_in(4361), 8480..8512);
    assert_eq!(acrc_catalog::flags_in(4095), 0..0);
    assert_eq!(acrc_catalog::flags_in(6144), 0..0);
}

proptest! {
    #[test]
    fn a_flag_and_its_word_agree(number in 0_u32..20_000) {
        let info = bit(number);
        let word = info.word.expect("inside the flag space");
        prop_assert_eq!((word - 4096) * 32 + info.index, number);
        if let (Some(words), Some(index)) = (flag_words(word), info.object_index) {
            prop_assert_eq!(words.object_index(word).unwrap_or(index), index, "BIT{}", number);
        }
    }

    #[test]
    fn decoding_a_number_and_asking_for_it_agree(number in 0_u32..40_000) {
        if let Some(row) = parameter(number).row {
            let place = row.law.place(number).expect("the row holds it");
            prop_assert_eq!(row.law.number(place), Some(number));
            let index = (0..row.law.first_index + row.law.count).find(|index| parameter_number(row.field, *index) == Some(number));
            prop_assert!(index.is_some());
        }
    }

    #[test]
    fn any_number_is_harmless(number: u32) {
        let _ = (parameter(number), bit(number));
    }
}

#[test]
fn settings_name_the_parameters_and_flags_that_hold_them() {
    let pgain = parameter(12_560).row.expect("a row");
    assert_eq!(pgain.set_by, Some(SetBy { command: command::PGAIN, part: 0 }));
    assert_eq!((pgain.default(0), pgain.default(15)), (Some(0.002_441_406), Some(0.002_441_406)));
    let tlm = parameter(12_337).row.expect("a row");
    assert_eq!((tlm.set_by, tlm.default(0)), (Some(SetBy { command: command::TLM, part: 1 }), Some(-10.0)));
    assert_eq!(bit(16_149).row.and_then(|row| row.set_by), Some(SetBy { command: command::HLIM, part: 1 }));
    let node = parameter(33_024).row.expect("a row");
    assert_eq!((node.default(0), node.default(1)), (Some(1.0), Some(0.0)));
}

#[test]
fn below_the_flags_of_the_system_are_inputs_outputs_and_flags_of_programs() {
    assert_eq!(acrc_catalog::first_system_flag(), 512);
    assert_eq!(acrc_catalog::bit(512).object, Space::Master);
}
