/** The connection to `acrc lsp`. */
import { execFile } from 'node:child_process';
import { homedir } from 'node:os';
import { promisify } from 'node:util';
import * as vscode from 'vscode';
import { LanguageClient, Trace, type LanguageClientOptions, type Middleware } from 'vscode-languageclient/node';
import { program } from './commandLine';

export const LANGUAGE = 'acrobasic';

/** The program of the settings. */
export function acrc(): string {
  const setting = vscode.workspace.getConfiguration('acrc').get<string>('path', 'acrc');
  return program(setting, homedir(), vscode.workspace.workspaceFolders?.[0]?.uri.fsPath);
}

/** Fails when the program can't be run, so that this is said once, and by this extension. */
export async function probe(): Promise<void> {
  await promisify(execFile)(acrc(), ['--version'], { timeout: 10_000 });
}

/** A client that is not started yet. */
export function create(output: vscode.LogOutputChannel, middleware: Middleware): LanguageClient {
  const server = { command: acrc(), args: ['lsp'] };
  const options: LanguageClientOptions = {
    documentSelector: [
      { scheme: 'file', language: LANGUAGE },
      { scheme: 'untitled', language: LANGUAGE },
      { scheme: 'file', pattern: '**/acrc.toml' },
    ],
    synchronize: { configurationSection: 'acrc' },
    initializationOptions: vscode.workspace.getConfiguration().get('acrc'),
    outputChannel: output,
    middleware: { ...middleware, ...withoutSnippets },
  };
  return new LanguageClient('acrc', 'AcroBASIC', server, options);
}

/** The frames of blocks are snippets of this extension, too: each is offered once. */
const withoutSnippets: Middleware = {
  async provideCompletionItem(document, position, context, token, next) {
    const answer = await next(document, position, context, token);
    const keep = (item: vscode.CompletionItem) => item.kind !== vscode.CompletionItemKind.Snippet;
    if (Array.isArray(answer)) {
      return answer.filter(keep);
    }
    return answer && new vscode.CompletionList(answer.items.filter(keep), answer.isIncomplete);
  },
};

/** Writes into the output what the settings ask for. */
export async function follow(client: LanguageClient): Promise<void> {
  const level = vscode.workspace.getConfiguration('acrc').get<string>('trace.server', 'off');
  await client.setTrace(Trace.fromString(level));
}
