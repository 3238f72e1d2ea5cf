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
    for statement in ["SET 17664", "PRINT BIT(-1)", "INH 99999"] {
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
fn a_flag_whose_effect_is_not_simulated_leaves_a_note() {
    let ran = Sim::program("SET 796\nSET 16148").run().clean();
    assert_eq!(ran.notes().len(), 2);
    assert!(ran.notes().iter().all(|note| note.ends_with("was set: the dry run does not simulate what it does")));
}
