/**
 * @file AcroBASIC, the language of Parker ACR motion controllers.
 * @license MIT OR Apache-2.0
 *
 * `../acrobasic.ebnf` is the grammar for people. What differs here: a program that the compiler refuses may still have a
 * tree without an error, because an editor sees unfinished programs; a block that is not closed reaches to the `ENDP`, and a
 * word that closes no block is an `unmatched`.
 */

/// <reference types="tree-sitter-cli/dsl" />

const data = require('./words.json');
const { words, tokens } = require('./lib/words.js');
const commands = require('./lib/commands.js');

const commandNames = new Set(data.commands.map(row => row.word));
const one = word => words([word]);
const isWord = text => /^[A-Z]/.test(text);

const WORD = Object.fromEntries(
  ['IF', 'ELSE', 'ELSEIF', 'ENDIF', 'FOR', 'TO', 'STEP', 'NEXT', 'WHILE', 'WEND', 'PROGRAM', 'ENDP', 'REM', 'PRINT', 'USING',
    'INPUT', 'OPEN', 'DTALK', 'AS', 'CLOSE', 'DIM', 'P', 'BIT', 'NOT'].map(word => [word, one(word)]),
);
const JUMP = words(data.commands.filter(row => row.shape === 'Target').map(row => row.word));
const MEMORY = words(data.commands.find(row => row.word === 'DIM').daughters.map(row => row.word));
const OBJECT = words(data.objects);
const AXIS_OBJECT = one('AXIS');
const SOURCE = words(data.objects.filter(word => word !== 'AXIS'));
const PREFIX = words(data.commands.filter(row => row.shape === 'Object').map(row => row.word));
const LONE = words(data.commands.filter(row => row.shape === 'Object' && !row.required).map(row => row.word));
const PAIRED = words(
  data.commands.filter(row => row.shape === 'Object' && row.daughters.some(commands.isObject)).map(row => row.word),
);
const ARGUMENT_WORD = words(
  data.keywords.filter(word => !commandNames.has(word) && !['AS', 'USING', 'TO', 'THEN', 'ON', 'OFF'].includes(word)),
);
const FUNCTION = words(data.functions.filter(row => !row.bare).map(row => row.word));
const BARE_FUNCTION = words(data.functions.filter(row => row.bare).map(row => row.word));
const named = row => !['P', 'BIT'].includes(row.word);
const SCALAR = words(data.operands.filter(row => named(row) && !row.array).map(row => row.word));
const ARRAY = words(data.operands.filter(row => named(row) && row.array).map(row => row.word));

/** Ranks of operators: the lower one binds tighter. */
const LOWEST_RANK = 10 + Math.max(...data.operators.map(row => row.rank));
const OPERATORS = data.operators.flatMap(row =>
  row.spellings.map(text => ({ text, power: LOWEST_RANK - row.rank, words: isWord(text) ? one(text) : null })),
);

const list = ($, item) => seq(item, repeat(seq(',', item)));

/** What follows the word of a command, by the shape of its arguments. Each is a list of alternatives. */
function shapes($) {
  /** Whatever may also start the next statement is tried both ways. */
  const both = rule => word => [word, seq(word, rule)];
  /** What follows is always an argument. */
  const always = rule => word => [word, prec(1, seq(word, rule))];
  const axes = word => [word, prec(1, seq(word, $._axes))];
  const axisValues = word => [
    word,
    prec(1, seq(word, $._axis_arguments)),
    seq(word, $._lone_value),
    prec(1, seq(word, $._lone_value, $._axis_arguments)),
  ];
  const objects = word => [word, prec(1, seq(word, $._objects))];
  return {
    Value: word => [...both($._value)(word), seq(word, '=', field('value', $._expression))],
    Index: both($._value),
    Clear: both($._value),
    Values: both($._values),
    String: both(choice($._constant, $.tuple, $.argument_word)),
    Source: word => [...both($._value)(word), prec(1, seq(word, choice($.object, $.argument_word)))],
    Axes: axes,
    AxisValues: axisValues,
    AxisSources: word => [...axisValues(word), prec(1, seq(word, alias($._source, $.object)))],
    Move: always($._axis_arguments),
    Bit: both($.flag),
    BitMove: word => [...both($.flag)(word), prec(1, seq(word, $.flag, $._axis_arguments))],
    ParameterTuple: word => [...both($._parameter)(word), seq(word, $._parameter, $._group)],
    Programs: objects,
    Masters: objects,
    Attach: objects,
    Detach: objects,
    Config: objects,
    Free: both($._arguments),
    FreeValues: both($._value_arguments),
  };
}

module.exports = grammar({
  name: 'acrobasic',

  externals: $ => [
    // The letters of a name where a value is wanted.
    $._name,
    // The same where a short word would be an axis.
    $._long_name,
    // A flag: a name even where a target seems to follow.
    $._flag_name,
    // A name with `=` behind it, at the start of a statement.
    $._assigned_name,
    // An axis without and with a target.
    $._axis,
    $._axis_with_target,
    $.string,
    $._then,
    $.remark_text,
    // Never given; they tell the scanner what may come: a daughter, an item of PRINT.
    $._daughter_may_follow,
    $._item_may_follow,
    $._error_sentinel,
  ],

  extras: _ => [/[ \t\f\u00A0\u2007\u202F]+/],

  // Side by side, what follows may be an argument or the next statement (`VEL P0` or `VEL` and `P0 = 5`); both are tried.
  conflicts: $ => [
    [$.axis],
    [$._axis_by_number],
    [$._prefix, $._axis_object],
    [$._prefix, $._lone_object],
    [$.move, $._axis_arguments],
    ...[$.command, $._behind_object].flatMap(command => [
      [command],
      ...[$._axes, $._axis_arguments, $._arguments, $._objects, $._value_arguments, $._values].map(list => [command, list]),
    ]),
  ],

  supertypes: $ => [$.statement],

  rules: {
    source_file: $ => seq(optional($.line_number), repeat(choice($._item, $.program, $._unmatched_endp))),

    program: $ => choice(
      prec(2, seq(alias(WORD.PROGRAM($), 'PROGRAM'), repeat($._item), alias(WORD.ENDP($), 'ENDP'))),
      prec.right(seq(alias(WORD.PROGRAM($), 'PROGRAM'), repeat($._item))),
    ),
    _unmatched_endp: $ => alias($._endp, $.unmatched),
    _endp: $ => alias(WORD.ENDP($), 'ENDP'),

    _item: $ => choice($._branch_item, alias($._unmatched_branch, $.unmatched)),
    _branch_item: $ => choice($._line_break, ':', $.comment, $.statement, $.unmatched),
    _line_break: $ => seq(/\r\n|\n|\r/, optional($.line_number)),
    line_number: $ => $._integer,
    comment: _ => /['\u2018\u2019][^\r\n]*/,

    statement: $ => choice(
      $.remark, $.label, $.assignment, $.define, $.if_statement, $.if_block, $.for_block, $.while_block, $.jump, $.print,
      $.input, $.open, $.close, $.dim, $.move, $.command, $.object_command,
    ),

    remark: $ => prec.right(seq(alias(WORD.REM($), 'REM'), optional($.remark_text))),

    label: $ => seq('_', field('name', choice(
      alias(token.immediate(/[A-Za-z0-9_]+/), $.label_name),
      alias(/[A-Za-z0-9_]+/, $.label_name),
    ))),

    // Blocks

    if_block: $ => choice(
      prec(2, seq($._if, repeat($._branch_item), repeat($.elseif_clause), optional($.else_clause), alias(WORD.ENDIF($), 'ENDIF'))),
      prec.right(seq($._if, repeat($._branch_item), repeat($.elseif_clause), optional($.else_clause))),
    ),
    _if: $ => seq(alias(WORD.IF($), 'IF'), field('condition', $._expression)),
    elseif_clause: $ => prec.right(seq($._elseif, repeat($._branch_item))),
    _elseif: $ => prec(2, seq(choice(alias(WORD.ELSEIF($), 'ELSEIF'), $._else_if), field('condition', $._expression))),
    _else_if: $ => prec(3, seq(alias(WORD.ELSE($), 'ELSE'), alias(WORD.IF($), 'IF'))),
    else_clause: $ => prec.right(seq(alias(WORD.ELSE($), 'ELSE'), repeat($._branch_item))),

    if_statement: $ => prec.right(seq(
      $._if,
      alias($._then, 'THEN'),
      repeat(choice($.statement, $.unmatched, alias($._unmatched_branch, $.unmatched), ':')),
    )),

    for_block: $ => choice(
      prec(2, seq($._for, repeat($._item), alias(WORD.NEXT($), 'NEXT'))),
      prec.right(seq($._for, repeat($._item))),
    ),
    _for: $ => choice(
      $._for_range,
      prec(1, seq($._for_range, alias(WORD.STEP($), 'STEP'), field('step', $._expression))),
    ),
    _for_range: $ => seq(
      alias(WORD.FOR($), 'FOR'),
      field('variable', $._primary),
      '=',
      field('start', $._expression),
      alias(WORD.TO($), 'TO'),
      field('end', $._expression),
    ),

    while_block: $ => choice(
      prec(2, seq($._while, repeat($._item), alias(WORD.WEND($), 'WEND'))),
      prec.right(seq($._while, repeat($._item))),
    ),
    _while: $ => seq(alias(WORD.WHILE($), 'WHILE'), field('condition', $._expression)),

    unmatched: $ => choice(alias(WORD.NEXT($), 'NEXT'), alias(WORD.WEND($), 'WEND')),
    _unmatched_branch: $ => choice(
      alias(WORD.ELSE($), 'ELSE'),
      seq(alias(WORD.ELSEIF($), 'ELSEIF'), field('condition', $._expression)),
      alias(WORD.ENDIF($), 'ENDIF'),
    ),

    // Statements with a grammar of their own

    assignment: $ => seq(
      field('target', choice($.parameter, $.bit, $.variable, alias($._assigned, $.name))),
      '=',
      field('value', $._expression),
    ),

    define: $ => seq(
      alias(/#[ \t]*define/i, '#DEFINE'),
      field('name', alias(/[A-Za-z][A-Za-z0-9_]*/, $.name)),
      field('operand', $._value),
    ),

    jump: $ => seq(
      alias(JUMP($), $.keyword),
      field('target', choice(alias(/[A-Za-z][A-Za-z0-9_]*/, $.label_name), $.number)),
    ),

    print: $ => prec.right(seq(
      choice(alias(WORD.PRINT($), 'PRINT'), '?'),
      optional(seq($.device, optional($._separator))),
      optional(seq(alias(WORD.USING($), 'USING'), $._expression, optional($._separator))),
      optional($._item_may_follow),
      repeat(seq($._expression, $._separator, optional($._item_may_follow))),
      optional($._expression),
    )),
    _separator: _ => choice(',', ';'),
    device: $ => seq('#', $._value),

    input: $ => seq(
      alias(WORD.INPUT($), 'INPUT'),
      optional(';'),
      optional(seq($.device, ',')),
      optional(prec(1, seq($.string, $._separator))),
      list($, $._value),
    ),

    open: $ => seq(
      alias(WORD.OPEN($), 'OPEN'),
      optional(alias(WORD.DTALK($), 'DTALK')),
      $._expression,
      alias(WORD.AS($), 'AS'),
      $.device,
    ),
    close: $ => prec.right(seq(alias(WORD.CLOSE($), 'CLOSE'), optional($.device))),

    dim: $ => prec.right(seq(
      alias(WORD.DIM($), 'DIM'),
      optional(choice(
        seq(field('kind', alias(MEMORY($), $.daughter)), repeat($.number), optional($._group)),
        $._daughter_may_follow,
      )),
    )),

    move: $ => prec(1, $._axis_arguments),

    // Commands of the catalogue

    command: $ => choice(...commands.plain.map(entry => commands.rule($, entry, shapes($)))),

    object_command: $ => choice($._behind_object, $._commutation, field('object', alias($._lone_object, $.object))),
    _lone_object: $ => prec.right(seq(alias(LONE($), $.keyword), optional(alias($._integer, $.number)))),
    _behind_object: $ => prec.dynamic(1, seq(
      field('object', alias($._prefix, $.object)),
      choice(...commands.behindObject.map(entry => commands.rule($, entry, shapes($))), $._group, $.unary_expression, $.parameter,
        $._daughter_may_follow),
    )),
    // `CMT0 ENC0 ENC1`; in a list of objects it is two of them.
    _commutation: $ => prec.dynamic(-1, seq(
      field('object', alias($._commutator, $.object)),
      prec.right(repeat1(alias($._numbered, $.object))),
    )),
    _commutator: $ => prec.right(seq(alias(PAIRED($), $.keyword), optional(alias($._integer, $.number)))),
    _prefix: $ => prec.right(seq(alias(PREFIX($), $.keyword), optional(alias($._integer, $.number)))),

    object: $ => prec.right(seq(alias(OBJECT($), $.keyword), optional(alias($._integer, $.number)))),
    _numbered: $ => seq(alias(OBJECT($), $.keyword), alias($._integer, $.number)),
    argument_word: $ => prec.right(-1, seq(alias(ARGUMENT_WORD($), $.keyword), optional(alias($._integer, $.number)))),

    _axes: $ => choice(
      $.axis,
      $.object,
      prec(2, seq($._axes, alias($._bare_axis, $.axis))),
      prec(1, seq($._axes, alias($._numbered, $.object))),
    ),
    _bare_axis: $ => field('name', alias($._axis, $.axis_name)),

    _axis_arguments: $ => choice(
      $._axis_argument,
      prec(2, seq($._axis_arguments, $.axis)),
      prec(1, seq($._axis_arguments, alias($._axis_by_number, $.axis))),
    ),
    _axis_argument: $ => choice($.axis, alias($._axis_by_number, $.axis)),
    axis: $ => seq(
      field('name', alias(choice($._axis, $._axis_with_target), $.axis_name)),
      optional($._axis_value),
    ),
    _axis_by_number: $ => seq(field('name', alias($._axis_object, $.object)), optional($._axis_value)),
    _axis_object: $ => seq(alias(AXIS_OBJECT($), $.keyword), alias($._integer, $.number)),
    _source: $ => seq(alias(SOURCE($), $.keyword), alias($._integer, $.number)),
    _axis_value: $ => choice(
      seq('/', field('distance', choice($._constant, $.name, $.tuple))),
      field('value', choice($._lone_value, alias($._source, $.object), $.argument_word)),
    ),
    _lone_value: $ => choice($._constant, $.tuple, alias($._long, $.name)),

    _objects: $ => choice(
      choice($.object, $.argument_word, $._constant, $.tuple),
      prec(2, seq($._objects, $.argument_word)),
      prec(1, seq($._objects, choice($._constant, $.tuple))),
      prec(1, seq($._objects, alias($._numbered, $.object))),
    ),

    _parameter: $ => choice($._constant, alias($._flag, $.name)),
    flag: $ => seq(
      optional(choice('+', $._minus)),
      choice($.number, $.parameter, $.bit, $.variable, $.call, $._group, alias($._flag, $.name)),
    ),

    _arguments: $ => choice(
      $._argument,
      prec(2, seq($._arguments, optional(','), choice(alias($._long, $.name), $.axis, $.argument_word))),
      seq($._arguments, optional(','), choice($._constant, $.tuple)),
      seq($._arguments, alias($._numbered, $.object)),
    ),
    _argument: $ => choice($._lone_value, $.axis, $.argument_word, alias($._axis_by_number, $.axis), alias($._source, $.object)),

    _value_arguments: $ => choice(
      choice($._value, $.argument_word, $.object),
      prec(2, seq($._value_arguments, optional(','), choice($.name, $.argument_word))),
      seq($._value_arguments, optional(','), choice($._constant, $.tuple)),
      seq($._value_arguments, alias($._numbered, $.object)),
    ),

    // Values

    _value: $ => choice($._constant, $.tuple, $.name),
    _values: $ => choice($._value, seq($._values, optional(','), $._value)),
    _group: $ => choice($.parenthesized_expression, $.tuple),
    tuple: $ => seq('(', $._expression, repeat1(seq(',', $._expression)), ')'),

    /** A value that is no name. */
    _constant: $ => choice(
      $.number, $.string, $.parameter, $.bit, $.variable, $.call, $.parenthesized_expression, $.unary_expression,
    ),

    _expression: $ => choice($._primary, $.binary_expression),
    _primary: $ => choice($._constant, $.name),
    parenthesized_expression: $ => seq('(', $._expression, ')'),
    unary_expression: $ => prec.right(LOWEST_RANK, seq(
      field('operator', choice('+', $._minus, alias(WORD.NOT($), $.operator_word))),
      field('operand', $._primary),
    )),
    binary_expression: $ => choice(...OPERATORS.map(({ text, power, words }) => prec.left(power, seq(
      field('left', $._expression),
      field('operator', words ? alias(words($), $.operator_word) : text === '-' ? $._minus : text),
      field('right', $._expression),
    )))),
    _minus: _ => alias(/[-\u2010\u2011\u2012\u2013\u2014\u2212]/, '-'),

    call: $ => choice(
      seq(alias(FUNCTION($), $.function), $._call_arguments),
      prec.right(seq(alias(BARE_FUNCTION($), $.function), optional($._call_arguments))),
    ),
    _call_arguments: $ => seq('(', optional(list($, $._expression)), ')'),

    parameter: $ => seq(alias(WORD.P($), 'P'), $._index),
    bit: $ => seq(alias(WORD.BIT($), 'BIT'), $._index),
    variable: $ => choice(
      seq(alias(SCALAR($), $.variable_class), $._index),
      prec.right(seq(alias(ARRAY($), $.variable_class), $._index, optional($.parenthesized_expression))),
    ),
    _index: $ => field('index', choice(alias($._integer, $.number), $.parenthesized_expression)),

    name: $ => seq($._name, optional($._name_end)),
    _long: $ => seq($._long_name, optional($._name_end)),
    _flag: $ => seq($._flag_name, optional($._name_end)),
    _assigned: $ => seq($._assigned_name, optional($._name_end)),
    _name_end: _ => token.immediate(prec(1, /[0-9_][A-Za-z0-9_]*/)),
    number: $ => choice($._integer, $._real),
    _integer: _ => /[0-9]+/,
    _real: _ => /[0-9]+\.[0-9]*([eE][+-]?[0-9]+)?|\.[0-9]+([eE][+-]?[0-9]+)?|[0-9]+[eE][+-]?[0-9]+/,

    ...tokens(),
  },
});
