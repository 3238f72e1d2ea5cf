/**
 * @file Commands by the shape of their arguments (`Shape` in `crates/acrc-catalog/src/vocabulary/shape.rs`).
 */

const data = require('../words.json');
const { words } = require('./words.js');

/** Shapes that have rules of their own in `grammar.js`. */
const SPECIAL = new Set([
  'Assignment', 'If', 'For', 'Condition', 'Print', 'Input', 'Open', 'Close', 'Dim', 'Define', 'Target', 'Text', 'Object',
]);

/** Commands that open, branch or close a block. */
const BLOCKS = new Set(['ELSE', 'ENDIF', 'NEXT', 'WEND', 'PROGRAM', 'ENDP']);

const objects = new Set(data.objects);

/** An object that a daughter names is an argument: `ATTACH SLAVE0`, `CMT0 ENC0`. */
function isObject(row) {
  return objects.has(row.word) && (row.shape === 'Attach' || row.shape === 'Free');
}

/** Rows with the same daughters and arguments, as one. */
function group(rows) {
  const groups = new Map();
  for (const row of rows) {
    const daughters = group(row.daughters.filter(daughter => !isObject(daughter)));
    const shape = row.shape === 'Free' && !row.axes ? 'FreeValues' : row.shape;
    const alone = shape !== 'Parent' && !row.required;
    const key = JSON.stringify([shape, alone, row.numbered, daughters.map(daughter => daughter.key)]);
    const known = groups.get(key);
    if (known) {
      known.list.push(row.word);
    } else {
      groups.set(key, { shape, alone, numbered: row.numbered, daughters, list: [row.word] });
    }
  }
  return [...groups].map(([key, entry]) => ({ ...entry, key: `${entry.list.join()} ${key}`, words: words(entry.list) }));
}

/** What may stand behind an object: the commands that take a prefix, and its daughters. */
function behindObject() {
  const rows = new Map();
  for (const object of data.commands.filter(row => row.shape === 'Object')) {
    for (const daughter of object.daughters.filter(daughter => !isObject(daughter))) add(rows, daughter);
  }
  const takesPrefix = row => row.prefixed || row.daughters.some(takesPrefix);
  for (const row of data.commands.filter(row => row.shape !== 'Object' && takesPrefix(row))) add(rows, row);
  return [...rows.values()];
}

/** One word may be a daughter of several objects, with arguments of different shapes. */
function add(rows, row) {
  const known = rows.get(row.word);
  const same = known === undefined || known.shape === row.shape;
  rows.set(row.word, {
    ...row,
    shape: same ? row.shape : 'Free',
    axes: row.axes || Boolean(known?.axes),
    required: row.required && (known?.required ?? true),
    daughters: [...(known?.daughters ?? []), ...row.daughters],
  });
}

const isPlain = row => !SPECIAL.has(row.shape) && !BLOCKS.has(row.word);

/**
 * The rule of a group: its words, then its daughters or its arguments.
 *
 * @param name what a word is in the tree
 */
function rule($, entry, shapes, name = $.keyword, depth = 1) {
  const plain = alias(entry.words($), name);
  const word = entry.numbered ? seq(plain, alias($._integer, $.number)) : plain;
  // Where a daughter is a command, too, it is the daughter.
  const choices = entry.daughters.map(daughter => 
    prec.dynamic(depth, seq(word, rule($, daughter, shapes, $.daughter, depth + 1))),
  );
  if (entry.alone) {
    choices.push(...(shapes[entry.shape]?.(word) ?? [word]));
    if (entry.daughters.length > 0) choices.push(seq(word, $._daughter_may_follow));
  }
  return choice(...choices);
}

module.exports = {
  isObject,
  plain: group(data.commands.filter(isPlain)),
  behindObject: group(behindObject()),
  rule,
};
