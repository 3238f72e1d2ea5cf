/** What is written on command lines: of the server, and of tasks. Nothing here knows VS Code. */

/** What a task does. */
export const TASKS = ['lint', 'fmt', 'build', 'mem', 'sim'] as const;

/** A task, as it stands in tasks.json. */
export interface Task {
  command: string;
  project?: string;
  arguments?: string[];
}

/** The program that a setting names: `~` is the home folder, `${workspaceFolder}` the first folder that is open. */
export function program(setting: string, home: string, workspace: string | undefined): string {
  const path = setting.trim() || 'acrc';
  const named = workspace === undefined ? path : path.replaceAll('${workspaceFolder}', workspace);
  return /^~(?=[/\\]|$)/.test(named) ? home + named.slice(1) : named;
}

/** The arguments of a task. Findings are written a line each, so that the problem matchers read them. */
export function taskArguments(task: Task): string[] {
  const further = task.arguments ?? [];
  const format = task.command === 'lint' && !further.some(argument => argument.startsWith('--format'));
  return ['--color', 'never', task.command, ...(format ? ['--format', 'concise'] : []), ...further, ...(task.project ? [task.project] : [])];
}

/** The name under which a task is offered. */
export function taskName(task: Task): string {
  return task.project ? `${task.command} ${task.project}` : task.command;
}

/** Why a text is not the address of a controller; nothing when it is one. */
export function wrongAddress(text: string): string | undefined {
  const address = /^(\[[0-9A-Fa-f:]+\]|[A-Za-z0-9.-]+)(?::([0-9]{1,5}))?$/.exec(text.trim());
  if (!address) {
    return 'An address such as 192.168.100.1, with a port if need be.';
  }
  return address[2] !== undefined && Number(address[2]) > 65535 ? 'A port is at most 65535.' : undefined;
}
