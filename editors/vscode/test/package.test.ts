/** The package as it is given to users. */
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

const folder = join(__dirname, '..');

/** The names and sizes of what is in a ZIP file. */
function entries(path: string): Map<string, number> {
  const zip = readFileSync(path);
  const end = zip.lastIndexOf(Buffer.from('PK\x05\x06'));
  const found = new Map<string, number>();
  let at = zip.readUInt32LE(end + 16);
  for (let count = zip.readUInt16LE(end + 10); count > 0; count -= 1) {
    const [name, extra, comment] = [28, 30, 32].map(offset => zip.readUInt16LE(at + offset)) as [number, number, number];
    found.set(zip.toString('utf8', at + 46, at + 46 + name), zip.readUInt32LE(at + 24));
    at += 46 + name + extra + comment;
  }
  return found;
}

test('one command makes a package with nothing but what is needed', () => {
  execFileSync('npm', ['run', 'package', '--silent'], { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'], shell: process.platform === 'win32' });
  const found = entries(join(folder, 'dist/acrobasic.vsix'));
  const files = [...found.keys()].filter(name => name.startsWith('extension/')).map(name => name.slice('extension/'.length));
  assert.deepEqual(files.sort(), [
    'LICENSE.txt', 'changelog.md', 'dist/THIRD-PARTY.txt', 'dist/extension.js', 'images/icon.png', 'language-configuration.json',
    'package.json', 'readme.md', 'snippets/acrobasic.json', 'syntaxes/acrobasic.tmLanguage.json',
  ]);
  const size = found.get('extension/dist/extension.js')!;
  assert.ok(size < 800_000, `${size} bytes`);
  const bundle = readFileSync(join(folder, 'dist/extension.js'), 'utf8');
  assert.ok(!/\.node["']/.test(bundle), 'nothing of one platform');
});
