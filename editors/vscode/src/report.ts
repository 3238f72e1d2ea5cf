/** The page of a dry run, beside the text. */
import { readFile } from 'node:fs/promises';
import { basename } from 'node:path';
import * as vscode from 'vscode';

/** Panels by the path of their page. */
const panels = new Map<string, vscode.WebviewPanel>();

/** Shows a page that `acrc sim --report` has written; a panel that shows it already shows it anew. */
export async function show(path: string): Promise<void> {
  const page = await readFile(path, 'utf8');
  const panel = panels.get(path) ?? open(path);
  panel.webview.html = page;
  panel.reveal(undefined, true);
}

function open(path: string): vscode.WebviewPanel {
  // The page holds all that it needs; nothing else may be read.
  const options = { enableScripts: true, localResourceRoots: [], retainContextWhenHidden: true };
  const title = basename(path, '.html').replace(/^run-\d+-/, '');
  const beside = { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true };
  const panel = vscode.window.createWebviewPanel('acrcReport', `Dry run of ${title}`, beside, options);
  panels.set(path, panel);
  panel.onDidDispose(() => panels.delete(path));
  return panel;
}
