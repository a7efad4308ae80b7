import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import { HostError } from '../contract/host-error.ts';
import type { Installation } from '../services/installation.ts';
import { type Call, type Command, type Context, EXIT, failed, type Outcome, UsageError } from './command.ts';
import { acquireCommand } from './commands/acquire.ts';
import { checkCommand } from './commands/check.ts';
import { exportCommand } from './commands/export.ts';
import { importCaptureCommand } from './commands/import-capture.ts';
import { newCommand } from './commands/new.ts';
import { openCommand } from './commands/open.ts';
import { planCommand } from './commands/plan.ts';
import { reconstructCommand } from './commands/reconstruct.ts';
import { renderCommand } from './commands/render.ts';
import { rephotographCommand } from './commands/rephotograph.ts';
import { scoreCommand } from './commands/score.ts';
import { shaderCheckCommand } from './commands/shader-check.ts';
import { shaderImportCommand } from './commands/shader-import.ts';
import { simplifyCommand } from './commands/simplify.ts';
import { commandHelp, overviewHelp } from './help.ts';
import { nameNodes } from './name-nodes.ts';
import { parseCall } from './parse-call.ts';
import { didYouMean } from './suggest.ts';
import { createPaint } from './terminal-colors.ts';

export const COMMANDS: readonly Command[] = [
  newCommand,
  openCommand,
  checkCommand,
  planCommand,
  exportCommand,
  renderCommand,
  acquireCommand,
  scoreCommand,
  reconstructCommand,
  simplifyCommand,
  importCaptureCommand,
  rephotographCommand,
  shaderCheckCommand,
  shaderImportCommand,
];

/** Output streams of the command line. */
export interface CliStreams {
  out(text: string): void;
  err(text: string): void;
  /** Whether a person reads `err`. Progress is shown only then. */
  readonly interactive: boolean;
  /** Replaces the progress text; null removes it. Default: lines on `err`. */
  progress?(text: string | null): void;
  /** Whether the streams are colored; by default they are not. */
  readonly colored?: { readonly out: boolean; readonly err: boolean };
}

/** Runs a command line. Returns the exit status, one of `EXIT`. */
export async function runCli(
  args: readonly string[],
  installation: Installation,
  streams: CliStreams,
  interrupted: AbortSignal = new AbortController().signal,
): Promise<number> {
  const [name, ...rest] = args;
  if (name === '--version' || name === '-v' || name === 'version') {
    streams.out(installation.version);
    return EXIT.done;
  }
  if (name === undefined || name === '--help' || name === '-h' || name === 'help') return help(name === undefined, rest, streams);
  const command = findCommand(args);
  if (!command) return refuse(streams, rest, 'scrim --help', noCommand(args));
  let call: Call;
  try {
    call = parseCall(command, args.slice(wordsOf(command)));
  } catch (error) {
    if (error instanceof UsageError) return refuse(streams, rest, `scrim ${command.name} --help`, error.message);
    throw error;
  }
  if (call.flag('help')) {
    streams.out(commandHelp(command));
    return EXIT.done;
  }
  return runCommand(command, call, installation, streams, interrupted);
}

/** Finds the command. Some names have two words. */
function findCommand(args: readonly string[]): Command | undefined {
  return COMMANDS.find((command) => args.slice(0, wordsOf(command)).join(' ') === command.name);
}

function wordsOf({ name }: Command): number {
  return name.split(' ').length;
}

function help(asError: boolean, named: readonly string[], streams: CliStreams): number {
  const command = findCommand(named);
  if (named.length > 0 && !command) return refuse(streams, [], 'scrim --help', noCommand(named));
  streams.out(command ? commandHelp(command) : overviewHelp(COMMANDS));
  return asError ? EXIT.notUnderstood : EXIT.done;
}

function noCommand([name = '']: readonly string[]): string {
  const group = COMMANDS.filter((command) => command.name.startsWith(`${name} `));
  if (group.length > 0)
    return `${name} is the first word of several commands: ${group.map((command) => `scrim ${command.name}`).join(', ')}.`;
  const names = COMMANDS.map((command) => command.name);
  return `Unknown command ${JSON.stringify(name)}.${didYouMean(name, names)}`;
}

async function runCommand(
  command: Command,
  call: Call,
  installation: Installation,
  streams: CliStreams,
  interrupted: AbortSignal,
): Promise<number> {
  const json = call.flag('json');
  const show = (text: string | null) => {
    if (streams.progress) streams.progress(text);
    else if (streams.interactive && text !== null) streams.err(text);
  };
  const paint = createPaint(streams.colored?.out === true);
  const context: Context = { installation, say: show, print: streams.out, paint, interrupted };
  let outcome: Outcome;
  try {
    outcome = await command.run(call, context);
  } catch (error) {
    if (interrupted.aborted && error === interrupted.reason) {
      show(null);
      streams.err('Interrupted. Nothing was written.');
      return EXIT.interrupted;
    }
    if (error instanceof UsageError) return refuse(streams, json ? ['--json'] : [], `scrim ${command.name} --help`, error.message);
    if (!(error instanceof HostError)) throw error;
    outcome = failed([error.diagnostic as Diagnostic]);
  }
  show(null);
  if (json) {
    if (outcome.json !== undefined) streams.out(JSON.stringify(outcome.json, null, 2));
  } else {
    const aside = createPaint(streams.colored?.err === true);
    const { files, diagnostics } = outcome;
    for (const diagnostic of files ? nameNodes(files, diagnostics) : diagnostics) streams.err(aside.diagnostic(diagnostic));
    if (outcome.text !== '') streams.out(outcome.text);
  }
  return outcome.status;
}

function refuse(streams: CliStreams, args: readonly string[], help: string, message: string): number {
  if (args.includes('--json')) {
    streams.out(JSON.stringify({ ok: false, diagnostics: [{ code: 'SCR070', severity: 'error', message }] }, null, 2));
  } else streams.err(`${message}\nTry: ${help}`);
  return EXIT.notUnderstood;
}
