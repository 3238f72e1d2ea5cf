//! Whatever is typed, the controller stays sound, and how its time is cut into steps does not matter.

use acrc_controller::PromptState;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;

use crate::support::{Desk, TWO_AXES};

/// Things that people and programs type.
const PIECES: [&str; 34] = [
    "\r",
    "\r\n",
    "\n",
    " : ",
    "\x18",
    "\x19",
    "\x1a",
    "\x1b",
    "\x08",
    "PROG0\r",
    "SYS\r",
    "PLC0\r",
    "PROGRAM\r",
    "ENDP\r",
    "RUN\r",
    "LRUN\r",
    "HALT ALL\r",
    "NEW\r",
    "LIST\r",
    "X10\r",
    "DWL 0.1\r",
    "INH -516\r",
    "P0 = P0 + 1\r",
    "?P0;\r",
    "IF (P0 > 2) THEN VEL 5 : X0\r",
    "10 PRINT P0\r",
    "20 GOTO 10\r",
    "20\r",
    "FOR P0 = 1 TO 3 : NEXT\r",
    "ECHO 1\r",
    "DIM\r",
    "#DEFINE a P1\r",
    "a = 2 / 0\r",
    "CLEAR\r",
];

fn typed() -> impl Strategy<Value = Vec<u8>> {
    let piece = prop_oneof![8 => select(PIECES.to_vec()).prop_map(|piece| piece.as_bytes().to_vec()), 1 => vec(any::<u8>(), 1..6)];
    vec(piece, 1..40).prop_map(|pieces| pieces.concat())
}

fn desk() -> Desk {
    Desk::with(&format!(
        "SYS\nDIM P(4)\nDIM PLC0(100)\nDIM DEF(2)\n{TWO_AXES}PROGRAM\n_again\nDWL 0.3\nPRINT P0\nGOTO again\nENDP\n"
    ))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, ..ProptestConfig::default() })]

    #[test]
    fn esc_and_endp_always_bring_the_prompt_back(bytes in typed()) {
        let mut desk = desk();
        desk.controller.receive(desk.channel, &bytes);
        desk.wait(1.0);
        // What waits behind a wait is read when that is given up, and may wait again.
        for _ in 0..60 {
            desk.controller.receive(desk.channel, b"\x1b");
            desk.wait(0.2);
        }
        desk.send("\rENDP\r");
        let state = desk.controller.prompt_state(desk.channel);
        prop_assert!(matches!(state, PromptState::Ready(_)), "{state:?}");
    }

    #[test]
    fn steps_of_time_do_not_matter(bytes in typed()) {
        const TICKS: u64 = 5600;
        let run = |step: u64| {
            let mut desk = desk();
            desk.controller.receive(desk.channel, &bytes);
            for _ in 0..TICKS / step {
                desk.controller.step(step, &mut desk.log);
            }
            (desk.read(), desk.log.faults, desk.controller.seconds().to_bits())
        };
        let whole = run(TICKS);
        prop_assert_eq!(&run(1), &whole);
        prop_assert_eq!(&run(700), &whole);
    }
}
