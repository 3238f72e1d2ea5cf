/** AcroBASIC in VS Code: `acrc lsp` as language server, its commands, tasks, and the page of dry runs. */
import * as vscode from 'vscode';
import type { LanguageClient, Middleware } from 'vscode-languageclient/node';
import { Actions } from './actions';
import { acrc, create, follow, probe } from './client';
import * as report from './report';
import { Status } from './status';
import { provider } from './tasks';

let session: Session | undefined;

export async function activate(context: vscode.ExtensionContext): Promise<Session> {
  session = new Session();
  context.subscriptions.push(session);
  await session.start();
  return session;
}

export async function deactivate(): Promise<void> {
  await session?.stop();
}

/** The server of this window and what belongs to it. */
export class Session implements vscode.Disposable {
  client: LanguageClient | undefined;
  private readonly output = vscode.window.createOutputChannel('AcroBASIC', { log: true });
  private readonly status = new Status();
  readonly actions = new Actions(() => this.client, this.output);
  private readonly parts: vscode.Disposable[];

  constructor() {
    const command = (name: string, act: (...given: never[]) => unknown) => vscode.commands.registerCommand(`acrobasic.${name}`, act);
    this.parts = [
      this.output,
      this.status,
      vscode.tasks.registerTaskProvider('acrc', provider),
      ...['sim', 'mem', 'download', 'report'].map(name => command(name, () => this.actions.run(`acrc.${name}`))),
      command('restart', () => this.restart()),
      command('output', () => this.output.show()),
      vscode.workspace.onDidChangeConfiguration(change => this.adapt(change)),
    ];
  }

  async start(): Promise<void> {
    try {
      await probe();
      const client = create(this.output, this.middleware());
      this.status.follow(client);
      this.client = client;
      await client.start();
      await follow(client);
    } catch (error) {
      this.client = undefined;
      await this.explain(error);
    }
  }

  async stop(): Promise<void> {
    const client = this.client;
    this.client = undefined;
    await client?.dispose();
  }

  dispose(): void {
    vscode.Disposable.from(...this.parts).dispose();
  }

  private async restart(): Promise<void> {
    await this.stop();
    await this.start();
  }

  private async adapt(change: vscode.ConfigurationChangeEvent): Promise<void> {
    if (change.affectsConfiguration('acrc.path')) {
      await this.restart();
    } else if (change.affectsConfiguration('acrc.trace.server') && this.client) {
      await follow(this.client);
    }
  }

  /** What comes from the server or from a line above a program takes the ways of this extension. */
  private middleware(): Middleware {
    return {
      executeCommand: (command, [target]) => this.actions.run(command, target),
      window: {
        async showDocument(params, token, next) {
          const uri = vscode.Uri.parse(params.uri);
          if (uri.scheme === 'file' && uri.path.endsWith('.html')) {
            await report.show(uri.fsPath);
            return { success: true };
          }
          return next(params, token);
        },
      },
    };
  }

  private async explain(error: unknown): Promise<void> {
    const why = error instanceof Error ? error.message : String(error);
    this.status.fail(`${acrc()} does not start`);
    this.output.error(why);
    const SETTINGS = 'Open settings';
    const text = `The language server did not start: ${why}. Install acrc, or say in acrc.path where it is.`;
    // Nobody waits for the answer.
    void vscode.window.showErrorMessage(text, SETTINGS).then(choice => {
      if (choice === SETTINGS) {
        void vscode.commands.executeCommand('workbench.action.openSettings', 'acrc.path');
      }
    });
  }
}
