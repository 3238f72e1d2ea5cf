//! The machine allocates nothing while a program computes with numbers: neither in a loop nor at the start of a slice.

mod support;

use acrc_vm::{Budget, Stop};
use support::Machine;

#[test]
fn numeric_code_allocates_nothing() {
    let mut machine = Machine::new(
        "DIM LV(3)\nDIM SV(1)\nDIM DV(2)\nDIM LA(1)\nDIM LA0(10)\nDIM DA(1)\nDIM DA0(10)\nP1 = 0 : P2 = 0\nDWL 1\n\
         WHILE (1)\nLV0 = LV0 + 1\nFOR LV1 = 0 TO 9\nLA0(LV1) = LA0(LV1) + LV0 MOD 7\nDA0(LV1) = LV0 / 3\nNEXT\n\
         FOR DV0 = 0 TO 1 STEP 0.25 : SV0 = SV0 + DV0 : NEXT\nGOSUB Sub\nIF (LV0 > 5 AND P1 < 1e9)\nP1 = P1 + SQRT(DA0(3))\n\
         ELSE\nP2 = P2 * 0.5\nENDIF\nBIT 40 = NOT BIT 40\nIF (BIT 40) THEN LV(2) = LV(LV0 MOD 2)\nWEND\nEND\n\
         _Sub\nDV1 = SIN(DV0) ** 2 + RND(6)\nRETURN",
    );
    machine.bench.patience = 1;
    assert_eq!(machine.run(Budget::lines(9)).stop, Stop::Blocked);
    // The first pass finds room for the loops and the flag.
    assert_eq!(machine.run(Budget::lines(200)).stop, Stop::Budget);
    let counts = allocation_counter::measure(|| drop(Machine::new("P0 = 1")));
    assert!(counts.count_total > 0, "the counter counts");
    let measured = allocation_counter::measure(|| {
        for _ in 0..1000 {
            machine.bench.trace.clear();
            assert_eq!(machine.run(Budget::lines(4)).stop, Stop::Budget);
        }
    });
    assert_eq!(measured.count_total, 0, "{measured:?}");
}
