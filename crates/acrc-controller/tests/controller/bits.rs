//! Flags and the words they lie in (guide, "System Parameters and Flags").

use crate::support::Sim;

#[test]
fn a_flag_word_is_its_flags() {
    assert_eq!(
        Sim::program("P4097 = 5\nPRINT BIT(32), BIT(33), BIT(34)\nCLR 32\nPRINT P4097").prints(),
        ["-1\t0\t-1", "4"]
    );
    let ran = Sim::program("P4097 = 4294967295\nPRINT P4097").run().clean();
    assert!(ran.bit(63));
    assert_eq!(ran.record.output[0].text, "-1");
}

#[test]
fn the_word_of_the_inputs_can_be_read() {
    let world = "[[event]]\nat = 0\nset = [0, 5]\n";
    assert_eq!(Sim::program("PRINT P4096").world(world).prints(), ["33"]);
}

#[test]
fn a_write_to_a_word_does_what_its_flags_do() {
    let ran = Sim::program("P4112 = P4112 OR 1024\nPRINT BIT(522)\nX10").run();
    assert_eq!((&*ran.record.output[0].text, ran.record.faults.len()), ("-1", 1));
}

#[test]
fn read_only_flags_keep_their_state() {
    for statement in ["SET 3", "SET 516", "CLR 1024", "BIT(5) = 1", "P4096 = 1"] {
        let faults = Sim::program(statement).faults();
        assert!(faults.len() == 1 && faults[0].ends_with("is read-only"), "{statement}: {faults:?}");
    }
}

#[test]
fn numbers_that_are_no_flag_are_refused() {
    for statement in ["SET 65536", "PRINT BIT(-1)", "INH 99999"] {
        let faults = Sim::program(statement).faults();
        assert!(faults.len() == 1 && faults[0].ends_with("is no flag of this controller"), "{statement}: {faults:?}");
    }
}

#[test]
fn user_flags_keep_their_state() {
    assert_eq!(
        Sim::program("SET 128\nSET 2047\nPRINT BIT(128), BIT(2047), P4159\nCLR 128\nPRINT BIT(128)").prints(),
        ["-1\t-1\t-2147483648", "0"]
    );
}

#[test]
fn a_number_that_no_document_names_is_memory_with_a_note() {
    let ran = Sim::program("SET 17670\nPRINT P4648, BIT(17670)\nP20000 = 1.5\nPRINT P20000, P20001").run().clean();
    assert_eq!(ran.record.output.iter().map(|line| &*line.text).collect::<Vec<_>>(), ["64\t-1", "1.5\t0"]);
    let named = |name: &str| format!("no document names {name}: it keeps what is written");
    assert_eq!(ran.notes(), ["BIT17670", "P20000", "P20001", "P4648"].map(named));
}

#[test]
fn requests_clear_themselves() {
    let ran = Sim::program(
        "SET 11265\nSET 16656\nSET 5647\nINH -11265\nINH -16656\nINH -5647\nP4448 = P4448 OR 2\nPRINT P4448\nSET 10505",
    )
    .run()
    .clean();
    assert_eq!(ran.record.output[0].text, "0");
    assert!(ran.bit(10_505), "selecting a datum is no request");
    assert_eq!(ran.notes().len(), 2, "{:?}", ran.notes());
}

#[test]
fn objects_that_the_model_lacks_stay_clear_with_one_note() {
    let ran = Sim::program("SET 8721\nP14348 = 5\nPRINT BIT(8721), P14348, P14336, P14592\nP14604 = 5").run().clean();
    assert_eq!(ran.record.output[0].text, "0\t0\t0\t0");
    let of =
        |axis: u8| format!("parameters and flags of axis {axis} were written and stay 0: the ACR9000 has axis 0 to 7");
    assert_eq!(ran.notes(), [of(8), of(9)]);
    assert_eq!(Sim::program("SET 8721\nPRINT BIT(8721)").model("ACR9030").prints(), ["-1"]);
}

#[test]
fn a_kill_reaches_every_axis_of_the_master_and_stays() {
    let ran =
        Sim::program("X10\nDWL 0.5\nSET 8467\nPRINT BIT(8467), BIT(8499), BIT(522), BIT(516), BIT(8531)\nY1").run();
    assert_eq!(ran.record.output[0].text, "-1\t-1\t-1\t0\t0");
    assert_eq!(ran.record.faults[0].message, "Associated Slave Kill Motion Request Active");
    let recovered = "SET 8467\nCLR 8467\nCLR 8499\nCLR 522\nX1\nINH -516\nPRINT P12288";
    assert_eq!(Sim::program(recovered).prints(), ["1"]);
}

#[test]
fn set_and_clr_take_every_form_of_a_flag() {
    let body = "CLEAR\nDIM LV(1)\nLV0 = 33\nSET BIT(32 + 0)\nSET (LV0)\nSET (32 + 2)\nSET BIT(LV0 + 2)\nPRINT P4097\n\
                CLR (30 + 2)\nCLR BIT(LV0)\nCLR BIT(34 + 0) CLR 35\nPRINT P4097";
    assert_eq!(Sim::program(body).prints(), ["15", "0"]);
    for statement in ["SET -3", "CLR (-33)"] {
        let faults = Sim::program(statement).faults();
        assert!(faults.len() == 1 && faults[0].contains("a flag has no sign here"), "{statement}: {faults:?}");
    }
    assert!(Sim::program("SET (65535 + 1)").faults()[0].ends_with("is no flag of this controller"));
}
