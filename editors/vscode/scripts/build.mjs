// Bundles the extension into dist/, and gathers what lies elsewhere: the grammar and the licences, own and others'.
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
  const { metafile } = await esbuild.build({ ...extension, metafile: true });
  writeFileSync(join(folder, 'dist/THIRD-PARTY.txt'), notices(Object.keys(metafile.inputs)));
}
if (wants('--tests')) {
  const tests = readdirSync(join(folder, 'test')).filter(name => name.endsWith('.test.ts'));
  rmSync(join(folder, 'out'), { recursive: true, force: true });
  await esbuild.build({ ...common, entryPoints: tests.map(name => join('test', name)), outdir: 'out', sourcemap: 'inline' });
}

/** The licences of the packages that are in the bundle. */
function notices(inputs) {
  const packages = new Set(inputs.map(path => /^(.*node_modules\/(?:@[^/]+\/)?[^/]+)\//.exec(path)?.[1]).filter(Boolean));
  return [...packages].sort().map(path => {
    const { name, version } = JSON.parse(readFileSync(join(folder, path, 'package.json'), 'utf8'));
    const licence = readdirSync(join(folder, path)).find(file => /^licen[cs]e/i.test(file));
    if (licence === undefined) {
      throw new Error(`${name} has no licence to give along`);
    }
    return `${name} ${version}\n\n${readFileSync(join(folder, path, licence), 'utf8').trim()}\n`;
  }).join(`\n${'-'.repeat(72)}\n\n`);
}
