//! `ACR316`: two nodes of the fieldbus `CANopen` with one ID.

use acrc_analysis::{SectionIndex, walk};
use acrc_catalog::OperandClass;
use acrc_diagnostics::{Code, Diagnostic, Severity, Span};
use acrc_syntax::ast::StatementKind;

use crate::Context;
use crate::references::meaning;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR316", name: "duplicate-node" },
        group: Group::Parameters,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "A program gives one CANopen node ID to two nodes, or to a node and to the controller itself (P32768, and P33024 \
               and every 16th behind it). Of several assignments to a parameter the last one counts; where the text takes \
               different ways, it is a warning.",
        why: "The network does not start: its state reports invalid node information, and the inputs and outputs of all nodes \
              stay dead.",
        bad: "PROG0\nPROGRAM\nP33024 = 1\nP33040 = 1\nSET 11265\nENDP",
        good: "PROG0\nPROGRAM\nP33024 = 1\nP33040 = 2\nSET 11265\nENDP",
        guide: "CANopen / Bus State",
    },
    checks: &[Check::Section(check)],
};

/// The fields of the catalogue that hold IDs.
const IDS: [&str; 2] = ["node_id", "master_node_id"];

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    let mut ids: Vec<(u32, u64, Span)> = Vec::new();
    let range = section.section.statements.start as usize..section.section.statements.end as usize;
    for statement in context.tree().statements().get(range).unwrap_or_default() {
        let StatementKind::Assign(assign) = &statement.kind else { continue };
        let Some((OperandClass::Parameter, number)) = meaning(context, &assign.target) else { continue };
        let number = u32::try_from(number).ok().filter(|number| IDS.contains(&acrc_catalog::parameter(*number).field));
        if let Some(number) = number {
            ids.retain(|(other, ..)| *other != number);
            ids.extend(walk::whole(&assign.value).filter(|id| *id > 0).map(|id| (number, id, statement.span)));
        }
    }
    let takes_ways = !section.jumps.is_empty() || !section.blocks.all().is_empty();
    for (at, (number, id, span)) in ids.iter().enumerate() {
        let earlier = ids.iter().take(at).find(|(_, other, _)| other == id);
        if let Some((other, _, first)) = earlier {
            let message = format!("P{number} gets the node ID {id}, which P{other} has");
            let finding = RULE.at(*span, message).with_related(*first, "given here");
            let finding = finding.with_help("give each node the ID that its switch shows, each another one");
            let severity = if takes_ways { Severity::Warning } else { Severity::Error };
            context.report(Diagnostic { severity, ..finding });
        }
    }
}

#[cfg(test)]
mod tests {
    use acrc_diagnostics::Severity;

    use crate::testing::{found_by, spans_of};

    #[test]
    fn nodes_and_the_controller() {
        assert_eq!(spans_of("ACR316", "P33024 = 1\nP33040 = 1\nP33056 = 2\n"), ["P33040 = 1"]);
        assert_eq!(spans_of("ACR316", "P32768 = 3\nP33024 = 3\n"), ["P33024 = 3"]);
        assert_eq!(spans_of("ACR316", "P33024 = 0\nP33040 = 0\nP32770 = 1\nP32771 = 1\n"), [""; 0]);
    }

    #[test]
    fn the_last_assignment_counts() {
        assert_eq!(spans_of("ACR316", "P33024 = 1\nP33024 = 2\nP33040 = 1\n"), [""; 0]);
        assert_eq!(spans_of("ACR316", "P33024 = 1\nP33024 = P0\nP33040 = 1\n"), [""; 0]);
        let ways = "PROG0\nPROGRAM\nP33024 = 1\nIF (BIT 1)\nP33040 = 1\nENDIF\nENDP\n";
        assert_eq!(found_by("ACR316", ways)[0].severity, Severity::Warning);
    }
}
