//! Groups of parameters and what an isolation mask isolates.

use acrc_wire::binary::{DataRequest, Group, global_variable_address};

fn parameters(group: u8, index: u8, mask: u8) -> Vec<Option<u16>> {
    DataRequest { group, index, mask }.parameters().collect()
}

#[test]
fn the_guides_table() {
    for (code, first, second) in [
        (0x10, 4096, 4097),
        (0x18, 6144, 6160),
        (0x19, 6400, 6416),
        (0x1A, 6656, 6672),
        (0x1B, 6912, 6913),
        (0x1C, 7168, 7184),
        (0x20, 8192, 8448),
        (0x28, 10240, 10496),
        (0x30, 12288, 12544),
        (0x38, 14336, 14592),
        (0x40, 16384, 16640),
        (0x50, 20480, 20481),
        (0x60, 24576, 24592),
    ] {
        let group = Group::of(code).unwrap();
        assert!(group.is_listed(), "{code:#04X}");
        assert_eq!(group.code(), code);
        assert_eq!([group.parameter(0, 0), group.parameter(0, 1)], [Some(first), Some(second)], "{code:#04X}");
    }
}

#[test]
fn masks_isolate_objects() {
    // Actual positions of axes 2, 3 and 5; those of axes 8 and 15.
    assert_eq!(parameters(0x30, 2, 0x2C), [Some(12802), Some(13058), Some(13570)]);
    assert_eq!(parameters(0x38, 2, 0x81), [Some(14338), Some(16130)]);
    assert_eq!(parameters(0x10, 0, 0xFF), (4096..4104).map(Some).collect::<Vec<_>>());
    assert_eq!(parameters(0x10, 0xFF, 0x82), [Some(4352), Some(4358)]);
    assert!(parameters(0x30, 2, 0).is_empty());
}

#[test]
fn codes_outside_of_the_table_follow_the_same_law() {
    assert_eq!(parameters(0x11, 8, 0x01), [Some(4360)], "the flags with Kill All Motion Request of axis 0");
    assert_eq!(parameters(0x31, 2, 0x03), [Some(12546), Some(12802)]);
    assert!(!Group::of(0x11).unwrap().is_listed());
    assert!(Group::of(0x1D).is_none());
    assert_eq!(parameters(0x1D, 0, 0x03), [None, None]);
}

#[test]
fn objects_behind_the_last_one_have_no_parameters() {
    assert_eq!(parameters(0x18, 0xF0, 0x03), [Some(6384), None], "there is no ENC16 in this group");
    assert_eq!(Group::of(0x30).unwrap().parameter(0, 8), None);
}

#[test]
fn one_parameter_has_a_request() {
    assert_eq!(DataRequest::of(12546), Some(DataRequest { group: 0x30, index: 2, mask: 0x02 }));
    assert_eq!(DataRequest::of(6160), Some(DataRequest { group: 0x18, index: 0x10, mask: 0x01 }));
    assert_eq!(DataRequest::of(0), None, "user parameters are in no group");
    for parameter in 0..=u16::MAX {
        if let Some(request) = DataRequest::of(parameter) {
            assert_eq!(request.parameters().collect::<Vec<_>>(), [Some(parameter)]);
        }
    }
}

#[test]
fn user_parameters_stand_behind_their_count() {
    assert_eq!(global_variable_address(0x0040_9000, 0), Some(0x0040_9001));
    assert_eq!(global_variable_address(0x0040_9000, 99), Some(0x0040_90C7));
    assert_eq!(global_variable_address(0, 1), None, "none are dimensioned");
    assert_eq!(global_variable_address(u32::MAX, 1), None);
    assert_eq!(global_variable_address(1, u32::MAX), None);
}
