/**
 * The frames of blocks: the server has them, and this extension has a copy for those who insert snippets by name.
 * `UPDATE_SNIPPETS=1 npm test` writes the copy.
 */
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { StreamMessageReader, StreamMessageWriter, createMessageConnection } from 'vscode-languageserver-protocol/node';

const acrc = process.env['ACRC'];
const path = join(__dirname, '../snippets/acrobasic.json');

interface Item {
  label: string;
  kind: number;
  detail: string;
  filterText: string;
  insertText?: string;
  textEdit?: { newText: string };
}

/** The snippets that the server offers in an empty text. */
async function offered(): Promise<Item[]> {
  const server = spawn(acrc!, ['lsp'], { stdio: ['pipe', 'pipe', 'inherit'] });
  const connection = createMessageConnection(new StreamMessageReader(server.stdout), new StreamMessageWriter(server.stdin));
  connection.listen();
  const textDocument = { uri: 'untitled:Prog0.8K', languageId: 'acrobasic', version: 1, text: '' };
  const capabilities = { textDocument: { completion: { completionItem: { snippetSupport: true } } } };
  await connection.sendRequest('initialize', { processId: process.pid, rootUri: null, capabilities });
  await connection.sendNotification('initialized', {});
  await connection.sendNotification('textDocument/didOpen', { textDocument });
  const position = { line: 0, character: 0 };
  const answer = await connection.sendRequest<{ items: Item[] } | Item[]>('textDocument/completion', { textDocument, position });
  await connection.sendRequest('shutdown');
  await connection.sendNotification('exit');
  await new Promise(ended => server.once('exit', ended));
  connection.dispose();
  return (Array.isArray(answer) ? answer : answer.items).filter(item => item.kind === 15);
}

test('the snippets are those of the server', { skip: acrc === undefined && 'ACRC names no program' }, async () => {
  const items = await offered();
  assert.ok(items.length > 5, JSON.stringify(items));
  const snippets = Object.fromEntries(
    items.map(item => [item.detail, { prefix: item.filterText, body: (item.textEdit?.newText ?? item.insertText ?? item.label).split('\n'), description: item.label }]),
  );
  const text = `${JSON.stringify(snippets, undefined, 2)}\n`;
  if (process.env['UPDATE_SNIPPETS']) {
    writeFileSync(path, text);
  }
  assert.equal(readFileSync(path, 'utf8'), text, 'UPDATE_SNIPPETS=1 npm test writes them anew');
});
