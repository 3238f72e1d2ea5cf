//! Columns: tables of `#DEFINE` and `DIM`, and remarks behind statements.

use crate::rows::{Row, Rows};

/// Lines whose texts before a column differ by more than this have no column in common: one long line does not push
/// the remarks of its neighbours out of sight.
const MAX_SPREAD: usize = 32;

/// Puts the operands of neighbouring `#DEFINE` lines into a column, and the sizes of neighbouring `DIM` lines.
pub(crate) fn tables(rows: &mut Rows) {
    let cells: Vec<_> = rows
        .rows
        .iter()
        .map(|row| row.table.map(|(table, stop)| Cell { key: (table, row.indent), width: rows.width(row, stop) }))
        .collect();
    let table_pad = |row: &mut Row, pad| {
        if let Some((_, stop)) = &mut row.table {
            stop.pad = pad;
        }
    };
    pad(&mut rows.rows, &cells, table_pad);
}

/// Puts the remarks of neighbouring lines into a column. Tables come first: they make their lines wider.
pub(crate) fn remarks(rows: &mut Rows) {
    let cell = |row: &Row| {
        let before = row.table.map_or(0, |(_, stop)| stop.pad);
        row.remark.map(|stop| Cell { key: (), width: rows.width(row, stop) + before })
    };
    let cells: Vec<_> = rows.rows.iter().map(cell).collect();
    let remark_pad = |row: &mut Row, pad| {
        if let Some(stop) = &mut row.remark {
            stop.pad = pad;
        }
    };
    pad(&mut rows.rows, &cells, remark_pad);
}

/// A line that may stand in a column.
struct Cell<K> {
    /// Lines with different keys share no column.
    key: K,
    /// Characters before the column.
    width: usize,
}

/// Cuts the rows into runs that share a column, and widens each to the widest of its run.
fn pad<K: PartialEq>(rows: &mut [Row], cells: &[Option<Cell<K>>], set: impl Fn(&mut Row, usize)) {
    let mut run: Vec<(&mut Row, usize)> = Vec::new();
    let mut limits = (0, 0);
    let mut key = None;
    let finish = |run: &mut Vec<(&mut Row, usize)>, widest: usize| {
        for (row, width) in run.drain(..) {
            set(row, widest - width);
        }
    };
    for (row, cell) in rows.iter_mut().zip(cells) {
        let Some(cell) = cell else {
            finish(&mut run, limits.1);
            key = None;
            continue;
        };
        let wider = (limits.0.min(cell.width), limits.1.max(cell.width));
        if row.blank_before || key != Some(&cell.key) || wider.1 - wider.0 > MAX_SPREAD {
            finish(&mut run, limits.1);
            limits = (cell.width, cell.width);
            key = Some(&cell.key);
        } else {
            limits = wider;
        }
        run.push((row, cell.width));
    }
    finish(&mut run, limits.1);
}
