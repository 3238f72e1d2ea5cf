//! `ACR529`: an electronic cam without a source or without a table.

use acrc_analysis::Deed;
use acrc_diagnostics::{Code, Severity};

use super::{axis_name, first_motions_of_attached};
use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR529", name: "cam-without-table" },
        group: Group::Motion,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A program switches the cam of an axis on, and nothing in the project says what it follows, with CAM SRC, or \
               gives it a segment of its table, with CAM SEG.",
        why: "The cam looks the place of its source up in its table. Without a source it never moves on, and without a table \
              there is nothing to look up: the axis stays where it is.",
        bad: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nCAM SRC X ENC4\nCAM ON X\nENDP",
        good: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nDIM LA(1)\nDIM LA0(9)\nCAM DIM X1\n\
               CAM SEG X (0, 4000, LA0)\nCAM SRC X ENC4\nCAM ON X\nENDP",
        guide: "Making Motion / Cam Profiler",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    let machine = context.machine();
    for motion in first_motions_of_attached(context, &[Deed::Cam]) {
        let axis = axis_name(context, &motion);
        let name = context.slice(motion.span);
        let [no_source, no_table] = [Deed::CamSource, Deed::CamTable].map(|deed| machine.never(deed, motion.axis));
        let (lacks, help) = match (no_source, no_table) {
            (false, false) => continue,
            (true, false) => ("sets the source of its cam", format!("say what it follows: CAM SRC {name} ENC0")),
            (_, true) => {
                ("gives its cam a table", format!("fill an array and name it: CAM SEG {name} (0, length, LA0)"))
            }
        };
        let message = format!("{axis} follows a cam, but nothing in the project {lacks}");
        context.report(RULE.at(motion.span, message).with_help(help));
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn found(program: &str) -> Vec<String> {
        let text = format!(
            "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \"Y\"\nPROGRAM\n{program}\nENDP\n"
        );
        spans_of("ACR529", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn each_axis_has_its_source_and_table() {
        let table = "CAM DIM X1\nCAM SEG X (0, 4000, LA0)\nCAM SRC X ENC2";
        assert_eq!(found(&format!("{table}\nCAM ON X Y")), ["Y"]);
        assert_eq!(found("CAM SRC X ENC2\nCAM ON X"), ["X"]);
        assert_eq!(found("CAM SEG X (0, 4000, LA0)\nCAM ON X"), ["X"]);
        assert_eq!(found("CAM OFF X"), [""; 0]);
    }
}
