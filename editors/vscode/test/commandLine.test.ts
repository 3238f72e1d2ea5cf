/** Command lines, and what VS Code makes of the output. */
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { TASKS, program, taskArguments, taskName, wrongAddress } from '../src/commandLine';

const acrc = process.env['ACRC'];
const options = { skip: acrc === undefined && 'ACRC names no program' };
const manifest = JSON.parse(readFileSync(join(__dirname, '../package.json'), 'utf8'));

interface Pattern {
  name: string;
  regexp: string;
  file: number;
  line: number;
  column: number;
  severity?: number;
  code: number;
  message: number;
}

test('the program may be named by a path with a home and a folder', () => {
  assert.equal(program('', '/home/me', undefined), 'acrc');
  assert.equal(program(' acrc ', '/home/me', undefined), 'acrc');
  assert.equal(program('~/bin/acrc', '/home/me', undefined), '/home/me/bin/acrc');
  assert.equal(program('~other/acrc', '/home/me', undefined), '~other/acrc');
  assert.equal(program('${workspaceFolder}/acrc', '/home/me', '/machine'), '/machine/acrc');
});

test('tasks write findings a line each, unless they are told otherwise', () => {
  assert.deepEqual(taskArguments({ command: 'lint' }), ['--color', 'never', 'lint', '--format', 'concise']);
  assert.deepEqual(taskArguments({ command: 'lint', arguments: ['--format=sarif'], project: 'a b' }), ['--color', 'never', 'lint', '--format=sarif', 'a b']);
  assert.deepEqual(taskArguments({ command: 'sim', arguments: ['--until', '2s'], project: 'm' }), ['--color', 'never', 'sim', '--until', '2s', 'm']);
  assert.equal(taskName({ command: 'sim', project: 'm' }), 'sim m');
});

test('an address has a host and may have a port', () => {
  for (const address of ['192.168.100.1', '192.168.100.1:5006', 'controller', '[fe80::1]:5002', ' 10.0.0.1 ']) {
    assert.equal(wrongAddress(address), undefined, address);
  }
  for (const address of ['', '192.168.100.1:', '192.168.100.1:70000', 'a b', 'http://a']) {
    assert.ok(wrongAddress(address), address);
  }
});

test('every task is a command of acrc', options, () => {
  const offered = manifest.contributes.taskDefinitions[0].properties.command.enum;
  assert.deepEqual(offered, [...TASKS]);
  for (const command of TASKS) {
    execFileSync(acrc!, [command, '--help']);
  }
});

test('the problem matchers read every finding of acrc', options, () => {
  const folder = mkdtempSync(join(tmpdir(), 'acrobasic-'));
  try {
    const file = join(folder, 'Prog0.8K');
    writeFileSync(file, 'PROGRAM\nGOTO Nowhere\nSET 34 : SET 35\nLV0 = 5\nENDP\n');
    const run = spawnSync(acrc!, taskArguments({ command: 'lint', project: file }), { encoding: 'utf8' });
    assert.equal(run.status, 1, run.stderr);
    const lines = run.stdout.split('\n').filter(line => line.includes(': ') && line.startsWith(folder));
    assert.ok(lines.length >= 2, run.stdout);
    const patterns: Pattern[] = manifest.contributes.problemPatterns;
    const found = lines.map(line => {
      const read = patterns.flatMap(pattern => {
        const match = new RegExp(pattern.regexp).exec(line);
        return match ? [{ pattern, match }] : [];
      });
      assert.equal(read.length, 1, `${line}: ${read.length} patterns`);
      const { pattern, match } = read[0]!;
      assert.equal(match[pattern.file], file);
      assert.match(match[pattern.code]!, /^ACR\d+$/);
      return `${match[pattern.line]} ${pattern.severity === undefined ? 'advice' : match[pattern.severity]}`;
    });
    assert.ok(found.includes('2 error') && found.includes('4 advice'), found.join(', '));
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test('a path of Windows is read, too', () => {
  const [pattern] = manifest.contributes.problemPatterns as Pattern[];
  const match = new RegExp(pattern!.regexp).exec('C:\\machine\\src\\Prog0.8K:2:6: error[ACR101] program 0 has no line 10');
  assert.equal(match?.[pattern!.file], 'C:\\machine\\src\\Prog0.8K');
});
