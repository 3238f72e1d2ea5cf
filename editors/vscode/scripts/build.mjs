// Bundles the extension into dist/, and gathers what lies elsewhere in the repository: the grammar and the licences.
import { copyFileSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import * as esbuild from 'esbuild';

const folder = join(dirname(fileURLToPath(import.meta.url)), '..');
const repository = join(folder, '../..');
const wants = flag => process.argv.includes(flag);

mkdirSync(join(folder, 'syntaxes'), { recursive: true });
copyFileSync(join(repository, 'grammar/acrobasic.tmLanguage.json'), join(folder, 'syntaxes/acrobasic.tmLanguage.json'));
const licences = ['LICENSE-MIT', 'LICENSE-APACHE'].map(name => readFileSync(join(repository, name), 'utf8').trim());
const choice = 'AcroBASIC for VS Code may be used under either of these two licences.';
writeFileSync(join(folder, 'LICENSE'), `${[choice, ...licences].join(`\n\n${'-'.repeat(72)}\n\n`)}\n`);

const common = {
  absWorkingDir: folder,
  bundle: true,
  platform: 'node',
  format: 'cjs',
  target: 'node20',
  external: ['vscode'],
  logLevel: 'warning',
};
const extension = {
  ...common,
  entryPoints: ['src/extension.ts'],
  outfile: 'dist/extension.js',
  minify: wants('--minify'),
  sourcemap: wants('--minify') ? false : 'linked',
};
if (wants('--watch')) {
  await (await esbuild.context(extension)).watch();
} else {
  await esbuild.build(extension);
}
if (wants('--tests')) {
  const tests = readdirSync(join(folder, 'test')).filter(name => name.endsWith('.test.ts'));
  rmSync(join(folder, 'out'), { recursive: true, force: true });
  await esbuild.build({ ...common, entryPoints: tests.map(name => join('test', name)), outdir: 'out', sourcemap: 'inline' });
}
