/** The bundled extension with the real `acrc lsp`, in a VS Code of which only the module is there. */
import assert from 'node:assert/strict';
import { mkdtempSync, mkdirSync, realpathSync, rmSync, writeFileSync } from 'node:fs';
import Module from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { URI } from 'vscode-uri';
import vscode, { Position, Range, commands, configure, open, seen, window, workspace, type Document } from './vscode';

const acrc = process.env['ACRC'];
const SETUP = "' Größe 🙂\nSYS\nHALT ALL\nNEW ALL\nCLEAR\nDIM PROG0(4096)\nDIM DEF(10)\n#DEFINE Lamp BIT33\n";
const PROGRAM = "PROGRAM\nPBOOT\n' läuft 🙂\n_Start\nSET Lamp\nDWL 0.5\nGOTO Strat\nENDP\n";
const token = { isCancellationRequested: false, onCancellationRequested: () => ({ dispose() {} }) };

interface Session {
  client: { state: number } | undefined;
  stop(): Promise<void>;
}
interface Extension {
  activate(context: object): Promise<Session>;
}

let folder: string;
let session: Session;
let program: Document;

/** Asks the provider that was registered for a kind of question. */
async function ask<T>(kind: string, method: string, ...given: unknown[]): Promise<T> {
  const all = (seen.providers.get(kind) ?? []) as Record<string, (...given: unknown[]) => Promise<T>>[];
  const provider = all.find(one => typeof one[method] === 'function');
  assert.ok(provider, `nothing is registered for ${kind}: ${[...seen.providers.keys()].join(', ')}`);
  return provider[method]!(...given, token);
}

async function until<T>(what: string, look: () => T | undefined): Promise<T> {
  const deadline = Date.now() + 20_000;
  for (;;) {
    const found = look();
    if (found !== undefined) {
      return found;
    }
    assert.ok(Date.now() < deadline, `waited in vain for ${what}: ${JSON.stringify([...seen.diagnostics])}\n${seen.output.join('\n')}`);
    await new Promise(done => setTimeout(done, 10));
  }
}

const codes = () => (seen.diagnostics.get(program.uri.toString()) ?? []).map(finding => {
  const code = finding.code as { value?: string } | string;
  return typeof code === 'object' ? code.value : code;
});

before(async () => {
  const load = (Module as unknown as { _load: (name: string, ...rest: unknown[]) => unknown })._load;
  (Module as unknown as { _load: unknown })._load = (name: string, ...rest: unknown[]) => (name === 'vscode' ? vscode : load(name, ...rest));
  folder = realpathSync(mkdtempSync(join(tmpdir(), 'acrobasic-')));
  mkdirSync(join(folder, 'src'));
  writeFileSync(join(folder, 'acrc.toml'), '[project]\nname = "lamp"\nfiles = ["src/Setup.8K", "src/Prog0.8K"]\n');
  writeFileSync(join(folder, 'src/Setup.8K'), SETUP);
  writeFileSync(join(folder, 'src/Prog0.8K'), PROGRAM.replace('GOTO Strat\n', ''));
  workspace.workspaceFolders = [{ uri: URI.file(folder), name: 'lamp', index: 0 }];
  configure('acrc.path', acrc ?? 'acrc');
  configure('acrc.sim.until', '2s');
  program = open(join(folder, 'src/Prog0.8K'), PROGRAM);
  const extension = Module.createRequire(__filename)('../dist/extension.js') as Extension;
  session = await extension.activate({ subscriptions: [] });
});

after(async () => {
  await session.stop();
  rmSync(folder, { recursive: true });
});

const options = { skip: acrc === undefined && 'ACRC names no program' };

test('the server starts, and says which it is', options, () => {
  assert.match(String(seen.status['text']), /^acrc \d/);
  assert.deepEqual(seen.messages, []);
});

test('findings come and go', options, async () => {
  await until('the unknown label', () => (codes().includes('ACR101') ? true : undefined));
  program.edit(new Range(6, 5, 6, 10), 'Start');
  await until('no unknown label', () => (codes().includes('ACR101') ? undefined : true));
});

test('completion offers aliases, and frames only as snippets of the extension', options, async () => {
  interface Item { label: string; kind: number }
  const position = new Position(4, 6);
  program.edit(new Range(4, 4, 4, 8), 'La');
  const answer = await ask<{ items: Item[] } | Item[]>('CompletionItemProvider', 'provideCompletionItems', program, position, token, { triggerKind: 0 });
  const items = Array.isArray(answer) ? answer : answer.items;
  assert.ok(items.some(item => item.label === 'Lamp'), JSON.stringify(items.slice(0, 9)));
  program.edit(new Range(4, 4, 4, 6), 'Lamp');
  const all = await ask<{ items: Item[] } | Item[]>('CompletionItemProvider', 'provideCompletionItems', program, new Position(4, 0), token, { triggerKind: 0 });
  assert.ok((Array.isArray(all) ? all : all.items).every(item => item.kind !== 14));
});

test('hover explains an alias', options, async () => {
  const hover = await ask<{ contents: unknown }>('HoverProvider', 'provideHover', program, new Position(4, 5));
  assert.match(JSON.stringify(hover.contents), /BIT33/);
});

test('rename reaches the other file', options, async () => {
  const edit = await ask<{ changes: Map<string, unknown[]> }>('RenameProvider', 'provideRenameEdits', program, new Position(4, 5), 'Lampe');
  const files = [...edit.changes.keys()].map(uri => uri.slice(uri.lastIndexOf('/') + 1));
  assert.deepEqual(files.sort(), ['Prog0.8K', 'Setup.8K']);
});

test('a dry run ends with its page', options, async () => {
  seen.choice = 'Show report';
  const answer = (await commands.executeCommand('acrobasic.sim')) as { status: number; report: string };
  assert.equal(answer?.status, 0, seen.messages.join('\n'));
  const panel = await until('the page', () => seen.panels.find(one => one.html.includes('<!DOCTYPE html>')));
  assert.match(panel.title, /^Dry run of /);
  assert.match(seen.messages.at(-1)!, /^0\.500 s of virtual time, ended$/);
});

test('a line above a program runs it', options, async () => {
  interface Lens { command: { command: string; arguments: unknown[]; title: string } }
  const lenses = await ask<Lens[]>('CodeLensProvider', 'provideCodeLenses', program);
  const run = lenses.find(lens => lens.command.command === 'acrc.sim');
  assert.ok(run, JSON.stringify(lenses));
  const answer = (await commands.executeCommand(run.command.command, ...run.command.arguments)) as { status: number };
  assert.equal(answer?.status, 0, seen.messages.join('\n'));
});

test('the page of the last run is shown in the editor', options, async () => {
  const count = seen.panels.length;
  seen.panels.forEach(panel => (panel.html = ''));
  await commands.executeCommand('acrobasic.report');
  await until('the page', () => seen.panels.find(one => one.html !== ''));
  assert.equal(seen.panels.length, count, 'in the panel that is there');
});

test('the memory is shown in the output', options, async () => {
  seen.output.length = 0;
  await commands.executeCommand('acrobasic.mem');
  assert.match(seen.output.join('\n'), /PROG0/);
});

test('another path starts another server, and a wrong one is explained', options, async () => {
  seen.choice = undefined;
  seen.messages.length = 0;
  configure('acrc.path', join(folder, 'nowhere'));
  await until('a message', () => seen.messages.find(message => message.includes('acrc.path')));
  assert.equal(seen.messages.length, 1, seen.messages.join('\n'));
  assert.match(String(seen.status['text']), /nowhere does not start/);
  configure('acrc.path', acrc);
  await until('the server', () => (/^acrc \d/.test(String(seen.status['text'])) ? true : undefined));
});

test('without a program in front there is nothing to run', options, async () => {
  window.activeTextEditor = undefined;
  assert.equal(await commands.executeCommand('acrobasic.sim'), undefined);
  assert.match(seen.messages.at(-1)!, /Open a program/);
});
