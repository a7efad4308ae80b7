import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { Installation } from '../services/installation.ts';
import type { Paint } from './terminal-colors.ts';

/** One subcommand, as data for the parser and for `--help`. */
export interface Command {
  readonly name: string;
  /** What follows the name: `PROJECT --out DIR`. */
  readonly usage: string;
  /** One line for the list of commands. */
  readonly summary: string;
  /** What it does, in a few sentences. */
  readonly doc: string;
  /** Whether what it works on must be named, or may be. */
  readonly project: 'required' | 'optional';
  /** What that is, where it is no project. */
  readonly operand?: { readonly word: string; readonly doc: string; readonly many?: boolean };
  readonly options: Readonly<Record<string, Option>>;
  readonly examples: readonly Example[];
  run(call: Call, context: Context): Promise<Outcome>;
}

export interface Option {
  readonly type: 'string' | 'boolean';
  /** One letter that stands for it. */
  readonly short?: string;
  /** How its value is called in `--help`: `DIR`. */
  readonly value?: string;
  /** What an argument after it has to look like to be its value; with it, the value may be left out and is then empty. */
  readonly optionalValue?: RegExp;
  readonly doc: string;
}

export interface Example {
  readonly line: string;
  readonly says: string;
}

/** The command line, taken apart. */
export interface Call {
  /** As given; empty where none was named and none is required. */
  readonly project: string;
  /** All that were named, for a command that takes several. */
  readonly operands: readonly string[];
  text(option: string): string | null;
  flag(option: string): boolean;
}

export interface Context {
  readonly installation: Installation;
  /** Shows a progress text until the next one, in an interactive terminal only. */
  say(text: string): void;
  /** Aborts on Ctrl-C. An unfinished command leaves nothing behind. */
  readonly interrupted: AbortSignal;
  /** For diagnostics that are the answer, on standard output. */
  readonly paint: Paint;
  /** On standard output at once, for a command that goes on. */
  print(text: string): void;
}

export interface Outcome {
  /** As `EXIT` names it. */
  readonly status: 0 | 1;
  /** The one value on standard output with `--json`; undefined where the command has printed it already. */
  readonly json: unknown;
  /** Without `--json`. */
  readonly text: string;
  /** Without `--json`, on standard error. */
  readonly diagnostics: readonly Diagnostic[];
}

/** The exit status, for scripts. What a signal ends has 128 and the signal's number, as in every shell. */
export const EXIT = { done: 0, problems: 1, notUnderstood: 2, ownFault: 70, interrupted: 130, terminated: 143 } as const;

/** The command line is not understood: status 2. */
export class UsageError extends Error {
  override readonly name = 'UsageError';
}

/** The outcome of a command that could not do its work. */
export function failed(diagnostics: readonly Diagnostic[]): Outcome {
  return { status: 1, json: { ok: false, diagnostics }, text: '', diagnostics };
}
