//! Devices and streams: `OPEN`, `CLOSE`, `PRINT`, `INPUT`, `INKEY$`, `GETCH`, `KBHIT`.

use acrc_controller::{State, Stopped};

use crate::support::{Ran, Sim};

/// What was printed, joined, with the ends of lines.
fn text(ran: &Ran) -> String {
    ran.record.output.iter().map(|line| line.text.as_str()).collect::<Vec<_>>().join("|")
}

#[test]
fn text_goes_to_the_stream_of_its_device() {
    let program = "OPEN \"COM1:9600,N,8,1\" AS #1\nOPEN \"STREAM2:\" AS #0\nPRINT #1, \"one\"\nPRINT \"two\"\nCLOSE #0\nPRINT \"three\"";
    let ran = Sim::program(program).run().clean();
    let sent: Vec<_> =
        ran.record.output.iter().map(|line| (line.device, line.stream.as_deref(), line.text.as_str())).collect();
    assert_eq!(sent, [(1, Some("COM1"), "one"), (0, Some("STREAM2"), "two"), (0, None, "three")]);
}

#[test]
fn devices_1_to_3_belong_to_all_programs() {
    let setup = "OPEN \"COM2:\" AS #2\nPROG1\nPROGRAM\nPRINT #2, \"hello\"\nENDP\n";
    let ran = Sim::new(setup).start(&[1]).run().clean();
    assert_eq!((ran.record.output[0].program, ran.record.output[0].stream.as_deref()), (Some(1), Some("COM2")));
}

#[test]
fn a_device_stays_open_behind_the_end_of_its_program() {
    let setup = "PROG0\nPROGRAM\nOPEN \"COM1:\" AS #1\nEND\nENDP\nPROG1\nPROGRAM\nDWL 0.1\nPRINT #1, \"hello\"\nENDP\n";
    let ran = Sim::new(setup).start(&[0, 1]).run().clean();
    assert_eq!(ran.record.output[0].stream.as_deref(), Some("COM1"));
}

#[test]
fn opening_and_closing_again_changes_nothing() {
    let program =
        "CLOSE #1\nOPEN \"COM1:\" AS #1\nOPEN \"com1:9600,n,8,1\" AS #1\nCLOSE #1\nCLOSE #1\nOPEN \"COM1:\" AS #3";
    Sim::program(program).run().clean();
}

#[test]
fn what_cannot_be_opened_or_read_is_refused() {
    for (program, expected) in [
        ("OPEN \"COM1:\" AS #1\nOPEN \"COM2:\" AS #1", "#1 is open already, as COM1: CLOSE #1 comes first"),
        ("OPEN \"COM1:\" AS #1\nOPEN \"COM1:\" AS #2", "COM1 is open already, as #1: CLOSE #1 comes first"),
        ("OPEN \"COM7:\" AS #1", "`COM7` is no stream: there are FIFO, DPCB, COM1, COM2 and STREAM1 to STREAM5"),
        ("OPEN \"FIFO:\" AS #1", "ACR9000 has no FIFO: its streams are COM1, COM2, STREAM1"),
        ("OPEN \"COM1:1,n,8,1\" AS #1", "1 is no baud rate of COM1"),
        ("OPEN \"COM1:\" AS #4", "OPEN: there is no device #4 here"),
        ("PRINT #9, 1", "PRINT: there is no device #9 here"),
        ("DIM LV(1)\nINPUT #1, LV0", "#1 is not open: OPEN \"COM1:9600,n,8,1\" AS #1 or the like comes first"),
        ("PRINT INKEY$(2)", "#2 is not open"),
        ("PRINT KBHIT(3)", "#3 is not open"),
        ("PRINT GETCH(1)", "#1 is not open"),
    ] {
        let faults = Sim::program(program).faults();
        assert!(faults.len() == 1 && faults[0].starts_with(expected), "{program}\n{faults:#?}");
    }
}

#[test]
fn text_to_a_closed_device_is_lost() {
    let ran = Sim::program("PRINT #1, \"a\"\nPRINT \"b\"").run().clean();
    assert_eq!(text(&ran), "b");
    assert_eq!(ran.notes(), ["#1 was not open when something was printed to it: that text is lost"]);
}

#[test]
fn input_asks_echoes_and_holds_its_program_only() {
    let setup = "PROG0\nDIM LV(2) : DIM $V(1,20)\nPROGRAM\nINPUT \"size = \"; LV0\nPRINT LV0 * 2\nINPUT; LV1, $V0\nPRINT \" \"; LV1; $V0\nENDP\n\
                 PROG1\nPROGRAM\nDWL 1\nPRINT \"other\"\nENDP\n";
    let world = "[[event]]\nat = 2\nstream = \"PROG0\"\ntext = \"2\"\n[[event]]\nat = 3\nstream = \"PROG0\"\ntext = \"1\\n7,a,b\\n\"\n";
    let sim = Sim::new(setup).start(&[0, 1]).world(world);
    let ran = sim.run().clean();
    assert_eq!(text(&ran), "size = |other|2|1||42|? |7,a,b| 7a,b");
    assert_eq!(sim.watched(false).run().clean().record.output, ran.record.output);
}

#[test]
fn a_line_that_does_not_fit_is_asked_for_again() {
    let program = "DIM LV(2)\nINPUT \"n = \", LV0, LV1\nPRINT LV0 + LV1";
    let ran = Sim::program(program).offer("PROG0", "one\n5\n5,\n5,2x\n 5 , -1.5e1 \n").run().clean();
    assert_eq!(text(&ran), "n = |one||n = |5||n = |5,||n = |5,2x||n = | 5 , -1.5e1 ||-10");
}

#[test]
fn without_input_the_run_says_who_waits_where() {
    let program = "DIM LV(1)\nOPEN \"COM2:\" AS #1\nINPUT #1, LV0";
    let ran = Sim::program(program).run().clean();
    assert_eq!(ran.stopped, Stopped::Until);
    let report = &ran.controller.programs()[0];
    assert_eq!((report.state, report.awaits.map(|port| port.to_string())), (State::Waiting, Some("COM2".to_owned())));
}

#[test]
fn characters_come_one_by_one() {
    let program = "DIM LV(1) : DIM $V(1,5)\nOPEN \"COM1:\" AS #1\nWHILE ($V0 = \"\")\n$V0 = INKEY$(1)\nWEND\n\
                   PRINT $V0; KBHIT(1); GETCH(1); KBHIT(1); \"<\"; INKEY$(1); \">\"\nLV0 = GETCH(1)\nPRINT LV0";
    let world =
        "[[event]]\nat = 1\nstream = \"COM1\"\ntext = \"ab\"\n[[event]]\nat = 2\nstream = \"COM1\"\ntext = \"\\n\"\n";
    let sim = Sim::program(program).world(world);
    assert_eq!(sim.timed().last().map(String::as_str), Some("2000 13"));
    assert_eq!(sim.prints()[0], "a-1980<>");
    assert_eq!(sim.watched(false).timed().last().map(String::as_str), Some("2000 13"));
}

#[test]
fn offered_lines_wait_for_the_stream_to_be_opened() {
    let program = "DIM $V(1,20)\nDWL 1\nOPEN \"COM1:\" AS #1\nINPUT #1, \"\"; $V0\nPRINT $V0\n\
                   CLOSE #1\nOPEN \"COM1:\" AS #2\nINPUT #2, \"\"; $V0\nPRINT $V0";
    let prints = Sim::program(program).offer("COM1", "first\r\nsecond").until(2.0).prints();
    assert_eq!(prints, ["first", "", "first", "second"]);
}

#[test]
fn closing_drops_what_was_not_read() {
    let program = "OPEN \"COM1:\" AS #1\nDWL 1\nCLOSE #1\nOPEN \"COM1:\" AS #1\nPRINT KBHIT(1)";
    let ran = Sim::program(program).world("[[event]]\nat = 0.5\nstream = \"COM1\"\ntext = \"abc\"\n").run().clean();
    assert_eq!(text(&ran), "0");
    assert_eq!(ran.notes(), ["COM1 was closed with 3 characters that no program had read: they are lost"]);
}

#[test]
fn a_full_buffer_holds_the_sender_back() {
    let text = "x".repeat(100);
    let world = format!("[[event]]\nat = 0.5\nstream = \"STREAM3\"\ntext = \"{text}\"\n");
    let setup = |size: u32| {
        format!(
            "DIM STREAM3({size})\nPROG0\nDIM LV(1)\nPROGRAM\nOPEN \"STREAM3:\" AS #1\nDWL 1\nWHILE (KBHIT(1))\nLV0 = LV0 + ASC(INKEY$(1)) / 120\nWEND\nPRINT LV0\nENDP\n"
        )
    };
    let ran = Sim::new(&setup(100)).start(&[0]).world(&world).run().clean();
    assert_eq!((ran.record.output[0].text.as_str(), ran.notes().len()), ("100", 0));
    let ran = Sim::new(&setup(99)).start(&[0]).world(&world).run().clean();
    assert_eq!(ran.record.output[0].text, "100");
    assert!(ran.notes()[0].starts_with("STREAM3: more characters arrived than its buffer of 99 bytes holds"));
}

#[test]
fn the_world_types_at_the_terminal_of_a_stream_that_no_program_has() {
    let setup = "DIM P(4)\nPROG0\nPROGRAM\nP0 = P0 + 1\nENDP\n";
    let world = "[[event]]\nat = 0\nstream = \"STREAM1\"\ntext = \"PROG0\\nRUN\\nDWL 0.1\\n?P0\\n\"\n";
    let ran = Sim::new(setup).world(world).run().clean();
    assert!(ran.record.output.iter().all(|line| line.stream.as_deref() == Some("STREAM1") && line.program.is_none()));
    assert!(text(&ran).ends_with("P00>?P0\r\n1\r\nP00>"), "{}", text(&ran));
}

#[test]
fn a_restart_closes_the_devices() {
    let setup = "PROG0\nDIM $V(1,9)\nPROGRAM\nPBOOT\nOPEN \"COM1:\" AS #1\nINPUT #1, \"\"; $V0\nPRINT #1, \"got \"; $V0\nENDP\n";
    let project = format!("OPEN \"COM1:\" AS #2\nREBOOT\n{setup}");
    let ran = Sim::new(&project).start(&[0]).offer("COM1", "a\nb\n").run().clean();
    assert_eq!(text(&ran), "a||got a");
}

#[test]
fn drives_and_networks_that_are_not_there_leave_a_note() {
    let ran = Sim::program("OPEN DTALK \"COM2:9600,N,8,1\" AS #1\nEPLC OFF\nEPLC ON\nOPEN \"COM2:\" AS #2").run();
    assert_eq!(ran.record.faults[0].message, "COM2 is open already, as #1: CLOSE #1 comes first");
    assert_eq!(
        ran.notes(),
        [
            "EPLC ON and EPLC OFF: there is no network in a dry run; its state comes from the world",
            "OPEN DTALK: no drive answers in a dry run; what drives report comes from the world",
        ]
    );
}
