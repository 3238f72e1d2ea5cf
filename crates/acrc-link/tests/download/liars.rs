//! Controllers that answer what they should not, or do not do what they are told.

use std::time::Duration;

use acrc_link::download::{Fate, Plan, Script, Settings, compare, send, survey};
use acrc_link::{Answer, Connection, Console, LinkError};

use crate::bench::{Notes, bring, look, over, project, script};
use crate::support::{Line, Machine};

const MACHINE: &str = "SYS\nCLEAR\nDIM PROG0(900)\nDIM PROG1(600)\nDIM DEF(3)\n#DEFINE Lamp BIT32\nPROG0\nPROGRAM\n_Again\nSET Lamp\n\
                       DWL 1\nCLR Lamp\nGOTO Again\nENDP\nPROG1\n10 DWL 2\n20 DWL 3\nSYS\n";

/// What is wrong with one answer.
#[derive(Clone, Copy, PartialEq)]
enum Lie {
    /// The line never arrives, and is answered as if it had.
    Swallows,
    /// A text stands where nothing should.
    Grumbles,
    /// The answer does not come.
    Silent,
}

/// A console that lies once.
struct Liar {
    inner: Connection<Line>,
    lie: Lie,
    /// The lines that are left until then.
    left: usize,
}

impl Console for Liar {
    fn command(&mut self, line: &str) -> Result<Answer, LinkError> {
        let lies = self.left == 0;
        self.left = self.left.wrapping_sub(1);
        if !lies {
            return self.inner.command(line);
        }
        match self.lie {
            Lie::Swallows => {
                let answer = self.inner.command("")?;
                Ok(Answer { command: line.to_owned(), lines: Vec::new(), ..answer })
            }
            Lie::Grumbles => {
                let answer = self.inner.command(line)?;
                Ok(Answer { lines: vec!["Stack overflow".to_owned()], ..answer })
            }
            Lie::Silent => {
                self.inner.command(line)?;
                Err(LinkError::Timeout { line: line.to_owned(), after: Duration::from_secs(5) })
            }
        }
    }

    fn command_within(&mut self, line: &str, _: Duration) -> Result<Answer, LinkError> {
        self.command(line)
    }

    fn send_key(&mut self, key: u8) -> Result<(), LinkError> {
        self.inner.send_key(key)
    }
}

/// Lets the controller lie at each line in turn. Gives how often that was not noticed.
fn each(lie: Lie, script: &Script) -> usize {
    let model = acrc_catalog::default_model();
    let clean = Machine::new();
    bring(&clean, script);
    let mut unnoticed = 0;
    for left in 0.. {
        let machine = Machine::new();
        let mut connection = machine.connect();
        let survey = survey(&mut connection, model).expect("it answers");
        let plan = Plan::new(script, &survey, model, &Settings::default()).expect("nothing is against it");
        let mut liar = Liar { inner: connection, lie, left };
        let sent = send(&mut liar, script, &plan, &Settings::default(), &mut Notes::default(), model);
        let over = liar.left < usize::MAX / 2;
        drop(liar);
        match sent {
            Ok(_) => {
                unnoticed += 1;
                let comparison = compare(script, &look(&machine));
                assert!(comparison.is_equal(), "the lie at line {left} went through: {comparison:#?}");
            }
            Err(failure) => {
                assert!(failure.state.open.is_none() || lie == Lie::Silent, "{left}: {failure:#?}");
                for unit in failure.state.with(Fate::Verified) {
                    let listing = &look(&machine).programs[&unit];
                    assert_eq!(listing, &look(&clean).programs[&unit], "{left}: {unit} is not what it is said to be");
                }
            }
        }
        bring(&machine, script);
        assert!(compare(script, &look(&machine)).is_equal());
        if over {
            return unnoticed - 1;
        }
    }
    unnoticed
}

#[test]
fn a_line_that_never_arrives_is_noticed_at_the_end() {
    let script = script(&project(MACHINE));
    // NEW ALL, CLEAR and the like change nothing on a controller that is empty.
    assert!(each(Lie::Swallows, &script) < 12);
}

#[test]
fn a_text_in_the_place_of_an_answer_ends_it() {
    let script = script(&project(MACHINE));
    // The prompt is what counts where the prompt is changed, and a flag that is not known is not set.
    assert!(each(Lie::Grumbles, &script) < 12);
}

#[test]
fn an_answer_that_does_not_come_ends_it() {
    assert_eq!(each(Lie::Silent, &script(&project(MACHINE))), 0);
}

#[test]
fn a_text_that_somebody_left_half_entered_is_ended() {
    let script = script(&project(MACHINE));
    let machine = Machine::new();
    let mut connection = machine.connect();
    for line in ["PROG0", "PROGRAM", "SET 40"] {
        connection.command(line).expect("it is answered");
    }
    over(&mut connection, &script, &Settings::default(), &mut Notes::default()).well();
    assert!(compare(&script, &look(&machine)).is_equal());
}
