/** The commands of the server, asked for in the palette or by a line above a program. */
import * as vscode from 'vscode';
import { ExecuteCommandRequest, type LanguageClient } from 'vscode-languageclient/node';
import { LANGUAGE } from './client';
import { wrongAddress } from './commandLine';
import * as report from './report';

/** What a command is about: some file of a project, and what the command needs besides. */
interface Target {
  uri: string;
  program?: string;
  until?: string;
  to?: string;
}

/** What a command answers. */
interface Answer {
  status?: number | null;
  summary?: string;
  report?: string;
  output?: string;
  errors?: string;
}

const TITLES: Record<string, string> = {
  'acrc.sim': 'Dry run',
  'acrc.mem': 'Counting memory',
  'acrc.download': 'Download',
  'acrc.report': 'Report',
};

export class Actions {
  constructor(
    private readonly client: () => LanguageClient | undefined,
    private readonly output: vscode.LogOutputChannel,
  ) {}

  /** Runs a command about the file in front, or about what a line above a program names. */
  async run(command: string, given?: Partial<Target>): Promise<Answer | undefined> {
    const client = this.client();
    const target = await this.target(command, given);
    if (!client || !target) {
      return undefined;
    }
    // The server reads the files on disk.
    if (!(await vscode.workspace.saveAll(false))) {
      return undefined;
    }
    const progress = { location: vscode.ProgressLocation.Notification, title: TITLES[command] ?? command, cancellable: true };
    try {
      const params = { command, arguments: [target] };
      const answer: Answer | null = await vscode.window.withProgress(progress, (_, token) =>
        client.sendRequest(ExecuteCommandRequest.type, params, token),
      );
      if (answer) {
        await this.show(command, answer);
      }
      return answer ?? undefined;
    } catch (error) {
      if (!(error instanceof vscode.CancellationError)) {
        void vscode.window.showErrorMessage(error instanceof Error ? error.message : String(error));
      }
      return undefined;
    }
  }

  private async target(command: string, given: Partial<Target> | undefined): Promise<Target | undefined> {
    const document = vscode.window.activeTextEditor?.document;
    const uri = given?.uri ?? (document?.languageId === LANGUAGE ? document.uri.toString() : undefined);
    if (uri === undefined) {
      void vscode.window.showInformationMessage('Open a program of the project first.');
      return undefined;
    }
    const settings = vscode.workspace.getConfiguration('acrc', vscode.Uri.parse(uri));
    const target: Target = { ...given, uri };
    if (command === 'acrc.sim') {
      target.until ??= settings.get<string>('sim.until') || undefined;
    }
    if (command === 'acrc.download') {
      target.to ??= await vscode.window.showInputBox({
        title: 'Download to a controller',
        prompt: 'Its address. What would be sent is shown before anything is.',
        value: settings.get<string>('download.to', ''),
        validateInput: wrongAddress,
      });
      if (!target.to) {
        return undefined;
      }
    }
    return target;
  }

  private async show(command: string, answer: Answer): Promise<void> {
    for (const text of [answer.output, answer.errors]) {
      if (text?.trim()) {
        this.output.appendLine(text.trimEnd());
      }
    }
    if (command === 'acrc.sim' && answer.report !== undefined) {
      const SHOW = 'Show report';
      const say = answer.status === 0 ? vscode.window.showInformationMessage : vscode.window.showWarningMessage;
      const page = answer.report;
      // Nobody waits for the answer.
      void say(answer.summary ?? 'The dry run is over.', SHOW).then(choice => (choice === SHOW ? report.show(page) : undefined));
    } else if (command === 'acrc.mem' || command === 'acrc.download') {
      this.output.show(true);
    }
  }
}
