//! Blank lines between subroutines (guide, "Program Labels": a `RETURN` ends one, the next label starts another).

use crate::rows::{Role, Rows};

/// Sets a blank line between a `RETURN` or `END` and the label behind it, above the comments that stand directly
/// before the label. Where a blank line stands between them already, none is added.
pub(crate) fn separate(rows: &mut Rows) {
    // The line that would get a blank line before it, if a label comes next.
    let mut first = None;
    for index in 0..rows.rows.len() {
        let Some(row) = rows.rows.get(index) else { break };
        match row.role {
            Role::Comment => {}
            Role::Blank | Role::Frozen => first = None,
            Role::Code { label, leaves } => {
                let target = first.filter(|_| label).and_then(|first| rows.rows.get_mut::<usize>(first));
                if let Some(target) = target {
                    target.blank_before = true;
                }
                first = leaves.then_some(index + 1);
            }
        }
    }
}
