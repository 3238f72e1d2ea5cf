/**
 * @file The words of the language, from `words.json`, which `cargo xtask generate` writes from the catalogue.
 *
 * A word can be several things (`ABS` is a function and a daughter of JOG), and which of them it is depends on its place.
 * Words that can stand in exactly the same places share one token, so that no two tokens ever match the same text.
 */

/** The sets of words that the grammar asks for; all are asked for before the first token is made. */
const sets = [];

/** A set of words, as one rule of the grammar. */
function words(list) {
  const set = new Set(list);
  sets.push(set);
  return $ => {
    const tokens = [...new Set([...set].map(tokenOf))].sort();
    return tokens.length === 1 ? $[tokens[0]] : choice(...tokens.map(token => $[token]));
  };
}

/** Words by the sets that they are in. */
function partition() {
  const classes = new Map();
  for (const word of new Set(sets.flatMap(set => [...set]))) {
    const places = sets.flatMap((set, index) => (set.has(word) ? [index] : [])).join();
    classes.set(places, [...(classes.get(places) ?? []), word]);
  }
  return [...classes.values()].map(list => list.sort());
}

let byWord;

function tokenOf(word) {
  byWord ??= new Map(partition().flatMap(list => list.map(word => [word, tokenName(list)])));
  return byWord.get(word);
}

function tokenName([first]) {
  return `_word_${first.toLowerCase().replace('$', '_dollar')}`;
}

/** The rules of the tokens, in any case of letters. */
function tokens() {
  return Object.fromEntries(
    partition().map(list => {
      const pattern = list.map(word => word.replace('$', '\\$')).join('|');
      return [tokenName(list), _ => new RegExp(pattern, 'i')];
    }),
  );
}

module.exports = { words, tokens };
