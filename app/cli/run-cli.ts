import { type Diagnostic, formatDiagnostic } from '../../nodes/kit/diagnostics.ts';
import { HostError } from '../contract/host-error.ts';
import type { Installation } from '../services/installation.ts';
import { type Call, type Command, type Context, failed, type Outcome, UsageError } from './command.ts';
import { checkCommand } from './commands/check.ts';
import { exportCommand } from './commands/export.ts';
import { openCommand } from './commands/open.ts';
import { planCommand } from './commands/plan.ts';
import { renderCommand } from './commands/render.ts';
import { commandHelp, overviewHelp } from './help.ts';
import { parseCall } from './parse-call.ts';

export const COMMANDS: readonly Command[] = [openCommand, checkCommand, planCommand, exportCommand, renderCommand];

/** Where the words go. */
export interface CliStreams {
  out(text: string): void;
  err(text: string): void;
  /** Whether a person reads `err`: progress is for people. */
  readonly interactive: boolean;
}

/** Runs one command line and answers with the exit status: 0 done, 1 errors, 2 not understood. */
export async function runCli(args: readonly string[], installation: Installation, streams: CliStreams): Promise<number> {
  const [name, ...rest] = args;
  if (name === '--version') {
    streams.out(installation.version);
    return 0;
  }
  if (name === undefined || name === '--help' || name === 'help') {
    const command = COMMANDS.find((c) => c.name === rest[0]);
    streams.out(command ? commandHelp(command) : overviewHelp(COMMANDS));
    return name === undefined ? 2 : 0;
  }
  const command = COMMANDS.find((c) => c.name === name);
  if (!command) return refuse(streams, rest, 'scrim --help', `There is no command ${JSON.stringify(name)}.`);
  let call: Call;
  try {
    call = parseCall(command, rest);
  } catch (error) {
    if (error instanceof UsageError) return refuse(streams, rest, `scrim ${name} --help`, error.message);
    throw error;
  }
  if (call.flag('help')) {
    streams.out(commandHelp(command));
    return 0;
  }
  return runCommand(command, call, installation, streams);
}

async function runCommand(command: Command, call: Call, installation: Installation, streams: CliStreams): Promise<number> {
  const json = call.flag('json');
  const context: Context = { installation, say: (text) => streams.interactive && streams.err(text), print: streams.out };
  let outcome: Outcome;
  try {
    outcome = await command.run(call, context);
  } catch (error) {
    if (error instanceof UsageError) return refuse(streams, json ? ['--json'] : [], `scrim ${command.name} --help`, error.message);
    if (!(error instanceof HostError)) throw error;
    outcome = failed([error.diagnostic as Diagnostic]);
  }
  if (json) {
    if (outcome.json !== undefined) streams.out(JSON.stringify(outcome.json, null, 2));
  } else {
    for (const diagnostic of outcome.diagnostics) streams.err(formatDiagnostic(diagnostic));
    if (outcome.text !== '') streams.out(outcome.text);
  }
  return outcome.status;
}

function refuse(streams: CliStreams, args: readonly string[], help: string, message: string): number {
  if (args.includes('--json')) {
    streams.out(JSON.stringify({ ok: false, diagnostics: [{ code: 'SCR070', severity: 'error', message }] }, null, 2));
  } else streams.err(`${message}\nTry: ${help}`);
  return 2;
}
