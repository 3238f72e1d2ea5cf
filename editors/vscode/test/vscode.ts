/**
 * As much of the module `vscode` as the extension and the language client need to run outside of VS Code. What is
 * registered is kept, so that a test can ask for it as VS Code would.
 */
import { URI } from 'vscode-uri';

type Listener<T> = (event: T) => unknown;

export class Disposable {
  constructor(private readonly end: () => unknown = () => undefined) {}
  static from(...parts: { dispose(): unknown }[]): Disposable {
    return new Disposable(() => parts.forEach(part => part.dispose()));
  }
  dispose(): void {
    this.end();
  }
}

export class EventEmitter<T> {
  private readonly listeners = new Set<Listener<T>>();
  readonly event = (listener: Listener<T>, self?: unknown, parts?: Disposable[]): Disposable => {
    const bound: Listener<T> = event => listener.call(self, event);
    this.listeners.add(bound);
    const disposable = new Disposable(() => this.listeners.delete(bound));
    parts?.push(disposable);
    return disposable;
  };
  fire(event: T): void {
    [...this.listeners].forEach(listener => listener(event));
  }
  dispose(): void {
    this.listeners.clear();
  }
}

/** Events that never happen here. */
const never = new EventEmitter<never>().event;

export class CancellationTokenSource {
  private readonly emitter = new EventEmitter<void>();
  readonly token = { isCancellationRequested: false, onCancellationRequested: this.emitter.event };
  cancel(): void {
    this.token.isCancellationRequested = true;
    this.emitter.fire();
  }
  dispose(): void {}
}

export class CancellationError extends Error {}

export class Position {
  constructor(
    readonly line: number,
    readonly character: number,
  ) {}
}

export class Range {
  readonly start: Position;
  readonly end: Position;
  constructor(start: Position | number, end: Position | number, line?: number, character?: number) {
    this.start = typeof start === 'number' ? new Position(start, end as number) : start;
    this.end = typeof start === 'number' ? new Position(line!, character!) : (end as Position);
  }
}

/** A class that keeps what it is made of, under names. */
function plain(...names: string[]): new (...values: unknown[]) => Record<string, unknown> {
  return class {
    [name: string]: unknown;
    constructor(...values: unknown[]) {
      names.forEach((name, index) => (this[name] = values[index]));
    }
  };
}

class CodeActionKind {
  static readonly Empty = new CodeActionKind('');
  static readonly QuickFix = new CodeActionKind('quickfix');
  static readonly Refactor = new CodeActionKind('refactor');
  static readonly RefactorExtract = new CodeActionKind('refactor.extract');
  static readonly RefactorInline = new CodeActionKind('refactor.inline');
  static readonly RefactorRewrite = new CodeActionKind('refactor.rewrite');
  static readonly Source = new CodeActionKind('source');
  static readonly SourceOrganizeImports = new CodeActionKind('source.organizeImports');
  constructor(readonly value: string) {}
  append(part: string): CodeActionKind {
    return new CodeActionKind(this.value ? `${this.value}.${part}` : part);
  }
}

class WorkspaceEdit {
  readonly changes = new Map<string, { range: Range; newText: string }[]>();
  set(uri: URI, edits: { range: Range; newText: string }[]): void {
    this.changes.set(uri.toString(), edits);
  }
}

class MarkdownString {
  constructor(public value = '') {}
  appendMarkdown(text: string): this {
    this.value += text;
    return this;
  }
  appendCodeblock(text: string): this {
    this.value += text;
    return this;
  }
}

class FoldingRangeKind {
  static readonly Comment = new FoldingRangeKind('comment');
  static readonly Imports = new FoldingRangeKind('imports');
  static readonly Region = new FoldingRangeKind('region');
  constructor(readonly value: string) {}
}

export class Document {
  version = 1;
  readonly isClosed = false;
  readonly isDirty = false;
  readonly languageId: string;
  constructor(
    readonly uri: URI,
    private text: string,
  ) {
    this.languageId = uri.path.endsWith('.8K') ? 'acrobasic' : 'plaintext';
  }
  get fileName(): string {
    return this.uri.fsPath;
  }
  getText(): string {
    return this.text;
  }
  offsetAt(position: Position): number {
    const lines = this.text.split('\n').slice(0, position.line);
    return lines.reduce((sum, line) => sum + line.length + 1, 0) + position.character;
  }
  /** Changes a part of the text, as a person does. */
  edit(range: Range, text: string): void {
    const [start, end] = [this.offsetAt(range.start), this.offsetAt(range.end)];
    this.text = this.text.slice(0, start) + text + this.text.slice(end);
    this.version += 1;
    const change = { range, rangeOffset: start, rangeLength: end - start, text };
    changed.fire({ document: this, contentChanges: [change] });
  }
}

/** What a test looks at. */
export const seen = {
  commands: new Map<string, (...given: unknown[]) => unknown>(),
  diagnostics: new Map<string, { code?: unknown; message: string; range: Range }[]>(),
  messages: [] as string[],
  output: [] as string[],
  panels: [] as { title: string; html: string }[],
  providers: new Map<string, unknown[]>(),
  status: {} as Record<string, unknown>,
  taskProviders: new Map<string, unknown>(),
  /** What is chosen when a question is asked. */
  choice: undefined as string | undefined,
  configuration: {} as Record<string, unknown>,
};

const changed = new EventEmitter<unknown>();
const opened = new EventEmitter<Document>();
const tabs = new EventEmitter<unknown>();
const reconfigured = new EventEmitter<unknown>();

class TabInputText {
  constructor(readonly uri: URI) {}
}

/** Opens a text in front. */
export function open(path: string, text: string): Document {
  const document = new Document(URI.file(path), text);
  const tab = { input: new TabInputText(document.uri), isActive: true };
  const editor = { document };
  workspace.textDocuments.push(document);
  window.visibleTextEditors.push(editor);
  window.activeTextEditor = editor;
  window.tabGroups.all[0]!.tabs.push(tab);
  opened.fire(document);
  tabs.fire({ opened: [tab], closed: [], changed: [] });
  return document;
}

/** Changes a setting. */
export function configure(name: string, value: unknown): void {
  seen.configuration[name] = value;
  reconfigured.fire({ affectsConfiguration: (section: string) => name === section || name.startsWith(`${section}.`) });
}

/** The settings below a section, as a tree. */
function settings(section: string): Record<string, unknown> {
  const tree: Record<string, unknown> = {};
  for (const [name, value] of Object.entries(seen.configuration)) {
    const path = name.split('.');
    let place: Record<string, unknown> = tree;
    for (const part of path.slice(0, -1)) {
      place = (place[part] ??= {}) as Record<string, unknown>;
    }
    place[path.at(-1)!] = value;
  }
  return section.split('.').filter(Boolean).reduce((place, part) => (place[part] ?? {}) as Record<string, unknown>, tree);
}

const say = (message: string) => {
  seen.messages.push(message);
  return Promise.resolve(seen.choice);
};
const ask = (message: string, ...choices: (string | { title: string } | object)[]) => {
  seen.messages.push(message);
  return Promise.resolve(choices.find(choice => (typeof choice === 'string' ? choice : (choice as { title?: string }).title) === seen.choice));
};

const write = (text: string) => void seen.output.push(text);
const channel = {
  name: 'AcroBASIC', logLevel: 3, onDidChangeLogLevel: never,
  append: write, appendLine: write, replace: write, trace: write, debug: write, info: write, warn: write, error: write,
  clear() {}, show() {}, hide() {}, dispose() {},
};

export const window = {
  activeTextEditor: undefined as { document: Document } | undefined,
  visibleTextEditors: [] as { document: Document }[],
  tabGroups: { all: [{ tabs: [] as unknown[] }], onDidChangeTabs: tabs.event, onDidChangeTabGroups: never },
  onDidChangeActiveTextEditor: never,
  onDidChangeVisibleTextEditors: never,
  createOutputChannel: () => channel,
  showInformationMessage: ask,
  showWarningMessage: ask,
  showErrorMessage: ask,
  showInputBox: () => say('input'),
  withProgress: (_: unknown, work: (progress: unknown, token: unknown) => unknown) =>
    work({ report() {} }, new CancellationTokenSource().token),
  createWebviewPanel(_: string, title: string) {
    const panel = { title, html: '' };
    seen.panels.push(panel);
    const webview = { set html(page: string) { panel.html = page; } };
    return { webview, reveal() {}, onDidDispose: never, dispose() {} };
  },
};

export const workspace = {
  textDocuments: [] as Document[],
  notebookDocuments: [],
  workspaceFolders: undefined as { uri: URI; name: string; index: number }[] | undefined,
  getWorkspaceFolder: () => workspace.workspaceFolders?.[0],
  getConfiguration(section = '') {
    const values = settings(section);
    const get = (name: string, usual?: unknown) =>
      name.split('.').reduce<unknown>((place, part) => (place as Record<string, unknown> | undefined)?.[part], values) ?? usual;
    return Object.assign(Object.create({ get, has: () => true, inspect: () => undefined }), values);
  },
  applyEdit: () => Promise.resolve(true),
  saveAll: () => Promise.resolve(true),
  createFileSystemWatcher: () => ({ onDidCreate: never, onDidChange: never, onDidDelete: never, dispose() {} }),
  onDidOpenTextDocument: opened.event,
  onDidChangeTextDocument: changed.event,
  onDidChangeConfiguration: reconfigured.event,
  ...Object.fromEntries(
    ['DidCloseTextDocument', 'DidSaveTextDocument', 'WillSaveTextDocument', 'DidChangeWorkspaceFolders', 'DidCreateFiles', 'DidRenameFiles',
      'DidDeleteFiles', 'WillCreateFiles', 'WillRenameFiles', 'WillDeleteFiles', 'DidOpenNotebookDocument', 'DidCloseNotebookDocument',
      'DidChangeNotebookDocument', 'DidSaveNotebookDocument'].map(name => [`on${name}`, never]),
  ),
};

type Filter = { language?: string; scheme?: string; pattern?: unknown };

const languageFunctions = {
  match(selector: Filter | Filter[], document: Document): number {
    const fits = (filter: Filter) =>
      (filter.language ? filter.language === document.languageId : document.uri.path.endsWith('acrc.toml')) &&
      (!filter.scheme || filter.scheme === document.uri.scheme);
    return [selector].flat().some(fits) ? 10 : 0;
  },
  createDiagnosticCollection: () => ({
    set: (uri: URI, list: { message: string; range: Range }[] | undefined) => void seen.diagnostics.set(uri.toString(), list ?? []),
    delete: (uri: URI) => void seen.diagnostics.delete(uri.toString()),
    has: (uri: URI) => seen.diagnostics.has(uri.toString()),
    get: (uri: URI) => seen.diagnostics.get(uri.toString()),
    clear: () => seen.diagnostics.clear(),
    dispose() {},
  }),
  createLanguageStatusItem: () => Object.assign(seen.status, { dispose() {} }),
};

/** Every `register...Provider` keeps its provider under its name. */
export const languages: Record<string, unknown> = new Proxy(languageFunctions as Record<string, unknown>, {
  get(known, name: string) {
    const kind = /^register(\w+)$/.exec(name)?.[1];
    return kind === undefined ? known[name] : (...given: unknown[]) => {
      const provider = given.find(value => typeof value === 'object' && value !== null && !Array.isArray(value));
      seen.providers.set(kind, [...(seen.providers.get(kind) ?? []), provider]);
      return new Disposable();
    };
  },
});

export const commands: {
  registerCommand(name: string, act: (...given: unknown[]) => unknown): Disposable;
  executeCommand(name: string, ...given: unknown[]): unknown;
} = {
  registerCommand(name: string, act: (...given: unknown[]) => unknown): Disposable {
    if (seen.commands.has(name)) {
      throw new Error(`command '${name}' already exists`);
    }
    seen.commands.set(name, act);
    return new Disposable(() => seen.commands.delete(name));
  },
  executeCommand: (name: string, ...given: unknown[]) => seen.commands.get(name)?.(...given),
};

export const tasks = {
  registerTaskProvider(type: string, provider: unknown): Disposable {
    seen.taskProviders.set(type, provider);
    return new Disposable();
  },
};

const names = (...all: string[]) => Object.fromEntries(all.map((name, index) => [name, index]));

const module = {
  version: '1.91.0',
  env: { appName: 'test', language: 'en', openExternal: () => Promise.resolve(true) },
  Uri: URI,
  Disposable, EventEmitter, CancellationTokenSource, CancellationError, Position, Range, CodeActionKind, WorkspaceEdit,
  MarkdownString, FoldingRangeKind, TabInputText, window, workspace, languages, commands, tasks,
  CompletionItem: plain('label', 'kind'),
  CompletionList: plain('items', 'isIncomplete'),
  CodeLens: plain('range', 'command'),
  DocumentLink: plain('range', 'target'),
  Diagnostic: plain('range', 'message', 'severity'),
  CallHierarchyItem: plain('kind', 'name', 'detail', 'uri', 'range', 'selectionRange'),
  TypeHierarchyItem: plain('kind', 'name', 'detail', 'uri', 'range', 'selectionRange'),
  SymbolInformation: plain('name', 'kind', 'containerName', 'location'),
  InlayHint: plain('position', 'label', 'kind'),
  CodeAction: plain('title', 'kind'),
  Hover: plain('contents', 'range'),
  TextEdit: plain('range', 'newText'),
  SnippetString: plain('value'),
  Location: plain('uri', 'range'),
  DiagnosticRelatedInformation: plain('location', 'message'),
  RelativePattern: plain('base', 'pattern'),
  TabInputTextDiff: plain(), TabInputNotebook: plain(), TabInputCustom: plain(),
  ProcessExecution: plain('process', 'args'),
  Task: plain('definition', 'scope', 'name', 'source', 'execution', 'problemMatchers'),
  TaskGroup: { Build: { id: 'build' } },
  TaskScope: { Global: 1, Workspace: 2 },
  DiagnosticSeverity: names('Error', 'Warning', 'Information', 'Hint'),
  DiagnosticTag: { Unnecessary: 1, Deprecated: 2 },
  LanguageStatusSeverity: names('Information', 'Warning', 'Error'),
  ProgressLocation: { SourceControl: 1, Window: 10, Notification: 15 },
  ViewColumn: { Active: -1, Beside: -2 },
  LogLevel: names('Off', 'Trace', 'Debug', 'Info', 'Warning', 'Error'),
  SymbolTag: { Deprecated: 1 },
  CompletionItemTag: { Deprecated: 1 },
  CompletionItemKind: names('Text', 'Method', 'Function', 'Constructor', 'Field', 'Variable', 'Class', 'Interface', 'Module', 'Property', 'Unit',
    'Value', 'Enum', 'Keyword', 'Snippet', 'Color', 'Reference', 'File', 'Folder', 'EnumMember', 'Constant', 'Struct', 'Event', 'Operator',
    'TypeParameter'),
  CompletionTriggerKind: names('Invoke', 'TriggerCharacter', 'TriggerForIncompleteCompletions'),
  SymbolKind: { ...names('File', 'Module', 'Namespace', 'Package', 'Class', 'Method', 'Property'), TypeParameter: 25 },
  FileType: names('Unknown', 'File', 'Directory'),
  TextDocumentSaveReason: { Manual: 1, AfterDelay: 2, FocusOut: 3 },
};

/** The module; what is missing in it is named, so that it can be added. */
export default new Proxy(module, {
  get(known: Record<string, unknown>, name: string) {
    if (!(name in known) && !['__esModule', 'then', 'default', 'notebooks', 'TextDocumentContentProvider'].includes(name)) {
      throw new Error(`the test's vscode has no ${name}`);
    }
    return known[name];
  },
});
