/** Whether the server runs, beside the name of the language in the status bar. */
import * as vscode from 'vscode';
import { State, type LanguageClient } from 'vscode-languageclient/node';
import { LANGUAGE } from './client';

export class Status implements vscode.Disposable {
  private readonly item = vscode.languages.createLanguageStatusItem('acrc', { language: LANGUAGE });

  constructor() {
    this.item.name = 'acrc';
  }

  /** Shows the state of a client from now on. */
  follow(client: LanguageClient): void {
    client.onDidChangeState(change => {
      this.item.busy = change.newState === State.Starting;
      if (change.newState === State.Running) {
        const server = client.initializeResult?.serverInfo;
        this.say(`${server?.name ?? 'acrc'} ${server?.version ?? ''}`.trim(), vscode.LanguageStatusSeverity.Information, 'output');
      } else if (change.newState === State.Stopped) {
        this.say('acrc has stopped', vscode.LanguageStatusSeverity.Warning, 'restart');
      }
    });
  }

  /** Says why there is no server. */
  fail(why: string): void {
    this.item.busy = false;
    this.say(why, vscode.LanguageStatusSeverity.Error, 'restart');
  }

  private say(text: string, severity: vscode.LanguageStatusSeverity, offered: 'output' | 'restart'): void {
    const title = offered === 'output' ? 'Output' : 'Restart';
    this.item.text = text;
    this.item.severity = severity;
    this.item.command = { title, command: `acrobasic.${offered}` };
  }

  dispose(): void {
    this.item.dispose();
  }
}
