/** What package.json and the files beside it promise. */
import assert from 'node:assert/strict';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

const folder = join(__dirname, '..');
const read = (path: string) => readFileSync(join(folder, path), 'utf8');
const manifest = JSON.parse(read('package.json'));
const language = JSON.parse(read('language-configuration.json'));
const examples = join(folder, '../../examples/gantry/src');

interface Rule {
  pattern: string;
  flags?: string;
}
const rule = ({ pattern, flags }: Rule) => new RegExp(pattern, flags);

test('every file that is named is there', () => {
  const { grammars, snippets, languages } = manifest.contributes;
  const named = [manifest.icon, manifest.main, ...[...grammars, ...snippets].map(part => part.path), languages[0].configuration, languages[0].icon.dark];
  for (const path of named) {
    assert.ok(existsSync(join(folder, path)), path);
  }
});

test('every command is registered, and every menu names a command', () => {
  const commands: string[] = manifest.contributes.commands.map((row: { command: string }) => row.command);
  const source = readdirSync(join(folder, 'src')).map(name => read(`src/${name}`)).join('\n');
  for (const command of commands) {
    assert.ok(source.includes(`'${command.replace('acrobasic.', '')}'`), command);
  }
  const menus = Object.values<{ command: string }[]>(manifest.contributes.menus).flat();
  assert.ok(menus.every(item => commands.includes(item.command)));
});

test('every setting that is read is declared', () => {
  const declared = Object.keys(manifest.contributes.configuration.properties);
  const source = readdirSync(join(folder, 'src')).map(name => read(`src/${name}`)).join('\n');
  for (const [, name] of source.matchAll(/get<string>\('([a-z.]+)'/gi)) {
    assert.ok(declared.includes(`acrc.${name}`), name);
  }
});

test('the scopes of meanings are scopes of the grammar', () => {
  const grammar = read('syntaxes/acrobasic.tmLanguage.json');
  const scopes = Object.values<string[]>(manifest.contributes.semanticTokenScopes[0].scopes).flat();
  const missing = scopes.filter(scope => !grammar.includes(`"${scope}"`));
  // An alias is a constant, and the grammar can't tell it from a variable.
  assert.deepEqual(missing, ['variable.other.constant.acrobasic']);
});

test('the examples are indented as typing would indent them', () => {
  const { increaseIndentPattern, decreaseIndentPattern } = language.indentationRules;
  const [more, less] = [rule(increaseIndentPattern), rule(decreaseIndentPattern)];
  for (const file of readdirSync(examples).filter(name => name.endsWith('.8K'))) {
    let depth = 0;
    for (const [index, line] of readFileSync(join(examples, file), 'utf8').split('\n').entries()) {
      if (!line.trim()) {
        continue;
      }
      depth = Math.max(0, depth - (less.test(line) ? 1 : 0));
      // Where a block ends is a matter of taste to the formatter.
      if (!less.test(line)) {
        assert.equal(/^ */.exec(line)![0].length / 4, depth, `${file}:${index + 1}: ${line}`);
      }
      depth += more.test(line) ? 1 : 0;
    }
  }
});

test('one line with THEN is no block', () => {
  const more = rule(language.indentationRules.increaseIndentPattern);
  for (const line of ['IF (LV0) THEN SET 34', 'IF (LV0)THEN SET 34', 'FOR LV0 = 0 TO 3 : SET LV0 : NEXT', "' IF (LV0)", 'FORCE', 'ENDIF']) {
    assert.ok(!more.test(line), line);
  }
  for (const line of ['IF (LV0)', '10 if (LV0 = 3) ', 'ELSE', 'elseif (LV0)', 'WHILE (BIT34)', 'FOR LV0 = 0 TO 3', 'IF(LV0)']) {
    assert.ok(more.test(line), line);
  }
});

test('words are what is renamed', () => {
  const words = (text: string) => [...text.matchAll(new RegExp(language.wordPattern, 'g'))].map(match => match[0]);
  assert.deepEqual(words('_Start SET Lamp P12288 $V0 2.5 LEFT$(x)'), ['_Start', 'SET', 'Lamp', 'P12288', '$V0', '2.5', 'LEFT$', 'x']);
});
