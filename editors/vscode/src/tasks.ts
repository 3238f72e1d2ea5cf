/** Tasks that run `acrc`, whose findings become problems. */
import * as vscode from 'vscode';
import { acrc } from './client';
import { TASKS, taskArguments, taskName, type Task } from './commandLine';

const TYPE = 'acrc';
/** The problem matchers of package.json. */
const MATCHERS = ['$acrc', '$acrc-advice'];

type Definition = vscode.TaskDefinition & Task;

export const provider: vscode.TaskProvider = {
  provideTasks() {
    const folders = vscode.workspace.workspaceFolders ?? [];
    return folders.flatMap(folder => TASKS.map(command => task({ type: TYPE, command }, folder)));
  },
  resolveTask(asked) {
    const definition = asked.definition as Definition;
    return typeof definition.command === 'string' ? task(definition, asked.scope ?? vscode.TaskScope.Workspace) : undefined;
  },
};

function task(definition: Definition, scope: vscode.WorkspaceFolder | vscode.TaskScope): vscode.Task {
  const execution = new vscode.ProcessExecution(acrc(), taskArguments(definition));
  const made = new vscode.Task(definition, scope, taskName(definition), TYPE, execution, MATCHERS);
  made.group = definition.command === 'build' || definition.command === 'lint' ? vscode.TaskGroup.Build : undefined;
  return made;
}
