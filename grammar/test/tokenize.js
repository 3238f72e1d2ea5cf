/**
 * @file Reads texts as JSON strings, one a line, and writes the tokens of each as a line of JSON: [first byte, end, scope].
 */

import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import oniguruma from 'vscode-oniguruma';
import textmate from 'vscode-textmate';

const require = createRequire(import.meta.url);
const grammarPath = new URL('../acrobasic.tmLanguage.json', import.meta.url);

await oniguruma.loadWASM(readFileSync(require.resolve('vscode-oniguruma/release/onig.wasm')).buffer);

const registry = new textmate.Registry({
  onigLib: Promise.resolve({
    createOnigScanner: sources => new oniguruma.OnigScanner(sources),
    createOnigString: text => new oniguruma.OnigString(text),
  }),
  loadGrammar: async () => textmate.parseRawGrammar(readFileSync(grammarPath, 'utf8'), grammarPath.pathname),
});
const grammar = await registry.loadGrammar('source.acrobasic');

/** The scope of each token with its place in UTF-8; text without a scope of its own is left out. */
function tokenize(text) {
  const found = [];
  let place = 0;
  let state = textmate.INITIAL;
  for (const part of text.split(/(\r\n|\n|\r)/)) {
    if (!/^[\r\n]/.test(part)) {
      const line = grammar.tokenizeLine(part, state);
      state = line.ruleStack;
      for (const { startIndex, endIndex, scopes } of line.tokens) {
        const start = place + Buffer.byteLength(part.slice(0, startIndex));
        const end = start + Buffer.byteLength(part.slice(startIndex, endIndex));
        if (scopes.length > 1) found.push([start, end, scopes.at(-1)]);
      }
    }
    place += Buffer.byteLength(part);
  }
  return found;
}

for (const line of readFileSync(0, 'utf8').split('\n').filter(Boolean)) {
  console.log(JSON.stringify(tokenize(JSON.parse(line))));
}
