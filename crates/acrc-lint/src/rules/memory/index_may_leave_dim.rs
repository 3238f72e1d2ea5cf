//! `ACR404`: a computed number that can go beyond what is dimensioned.

use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::Expr;

use super::operands::{self, Index, Room};
use super::{interval, sites};
use crate::Context;
use crate::rule::{Check, Group, On, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR404", name: "index-may-leave-dim" },
        group: Group::Memory,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A computed number of a variable, an array, an element or a user parameter can be larger than what DIM makes \
               room for. Known are the counter of a FOR with constant bounds, x MOD n, x AND n, and sums, differences and \
               products of these; of anything else nothing is said.",
        why: "A loop that runs one step too far stops the program at its last pass.",
        bad: "PROG0\nDIM LV(1)\nDIM LA(1)\nDIM LA0(10)\nPROGRAM\nFOR LV0 = 0 TO 10 STEP 1\nLA0(LV0) = 0\nNEXT\nENDP",
        good: "PROG0\nDIM LV(1)\nDIM LA(1)\nDIM LA0(10)\nPROGRAM\nFOR LV0 = 0 TO 9 STEP 1\nLA0(LV0) = 0\nNEXT\nENDP",
        guide: "System Configuration / Memory Allocations",
    },
    checks: &[Check::Expression(On::Operand, check)],
};

fn check(context: &mut Context<'_>, expr: &Expr) {
    for place in operands::places(context, expr) {
        let Index::Computed(index) = place.index else { continue };
        let Some(count) = place.room.extent(context).and_then(|extent| extent.count) else { continue };
        let known = interval::of(context, index);
        let (low, high) = (known.low.filter(|low| *low < 0), known.high.filter(|high| beyond(*high, count)));
        let reached = match (low, high) {
            (_, Some(high)) => high,
            (Some(low), None) => low,
            (None, None) => continue,
        };
        // Parameters of the system lie behind those of the user.
        if place.room == Room::Parameters && known.high.is_none_or(|high| beyond(high, USER_PARAMETERS)) {
            continue;
        }
        let written = context.slice(index.span);
        let (dim, contents) = (place.room.dim(), place.room.contents(count));
        let message = format!("{written} can be {reached}, but {dim}({count}) gives {contents}");
        let diagnostic = RULE.at(index.span, message);
        context.report_by(sites::confidence(place.room.class()), diagnostic);
    }
}

const USER_PARAMETERS: u64 = acrc_catalog::memory::USER_PARAMETERS as u64;

/// Whether a number lies behind the last of `count`.
fn beyond(number: i64, count: u64) -> bool {
    u64::try_from(number).is_ok_and(|number| number >= count)
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes, found_by};

    fn program(statements: &str) -> Vec<(u32, &'static str)> {
        codes(&format!("PROG0\nPROGRAM\nCLEAR : DIM LV(3) : DIM LA(1) : DIM LA0(10)\n{statements}\nENDP\n"))
    }

    #[test]
    fn the_counter_of_a_loop() {
        assert_eq!(program("FOR LV0 = 0 TO 9 STEP 1\nLA0(LV0) = 0\nNEXT"), []);
        assert_eq!(program("FOR LV0 = 0 TO 10 STEP 1\nLA0(LV0) = 0\nNEXT"), [(5, "ACR404")]);
        assert_eq!(program("FOR LV0 = 1 TO 10\nLA0(LV0-1) = 0\nNEXT"), []);
        assert_eq!(program("FOR LV0 = 0 TO 9\nLA0(LV0-1) = 0\nNEXT"), [(5, "ACR404")]);
        assert_eq!(program("FOR LV0 = 0 TO 3\nFOR LV1 = 0 TO 2\nLA0(LV0*3+LV1) = 0\nNEXT\nNEXT"), [(6, "ACR404")]);
        assert_eq!(program("FOR LV0 = 0 TO 2\nFOR LV1 = 0 TO 2\nLA0(LV0*3+LV1) = 0\nNEXT\nNEXT"), []);
    }

    #[test]
    fn remainders_and_masks() {
        assert_eq!(program("LA0(LV1 MOD 10) = 0\nLA0(LV1 AND 7) = 0"), []);
        assert_eq!(program("LA0(LV1 MOD 11) = 0"), [(4, "ACR404")]);
        assert_eq!(program("LA0(LV1 AND 15) = 0"), [(4, "ACR404")]);
        assert_eq!(program("LA0((LV1 AND 7) + 3) = 0"), [(4, "ACR404")]);
        assert_eq!(program("LV(LV1 AND 3) = 0"), [(4, "ACR404")]);
    }

    #[test]
    fn of_what_is_not_known_nothing_is_said() {
        assert_eq!(program("LA0(LV1) = 0\nLA0(LV1+100) = 0\nLA0(P0) = 0"), []);
        assert_eq!(program("FOR LV0 = 0 TO LV1\nLA0(LV0) = 0\nNEXT\nLA0(LV0) = 0"), []);
    }

    #[test]
    fn a_counter_that_is_changed_on_the_way() {
        assert_eq!(program("FOR LV0 = 0 TO 10\nLV0 = 0\nLA0(LV0) = 0\nNEXT"), []);
        assert_eq!(program("FOR LV0 = 0 TO 10\nLV(LV1) = 0\nLA0(LV0) = 0\nNEXT"), []);
        assert_eq!(program("FOR LV0 = 0 TO 10\nGOSUB A\nLA0(LV0) = 0\nNEXT\nEND\n_A\nLV0 = 0\nRETURN"), []);
        assert_eq!(
            program("FOR LV0 = 0 TO 10\nGOSUB A\nLA0(LV0) = 0\nNEXT\nEND\n_A\nLV1 = 0\nRETURN"),
            [(6, "ACR404")]
        );
        assert_eq!(program("GOTO In\nFOR LV0 = 0 TO 10\n_In\nLA0(LV0) = 0\nNEXT"), [(4, "ACR133")]);
    }

    #[test]
    fn the_message_says_how_far() {
        let text = "PROG0\nDIM LV(1)\nDIM LA(1)\nDIM LA0(10)\nPROGRAM\nFOR LV0=0 TO 10\nLA0(LV0)=0\nNEXT\nENDP\n";
        let found = found_by("ACR404", text);
        assert_eq!(found[0].message, "LV0 can be 10, but DIM LA0(10) gives elements 0 to 9");
    }

    #[test]
    fn parameters() {
        let text =
            |end: u32| format!("SYS\nDIM P(10)\nPROG0\nDIM LV(1)\nPROGRAM\nFOR LV0=0 TO {end}\nP(LV0)=0\nNEXT\nENDP\n");
        assert_eq!(codes(&text(9)), []);
        assert_eq!(codes(&text(10)), [(7, "ACR404")]);
        assert_eq!(codes(&text(5000)), [], "flags lie there");
    }
}
