import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { ProjectFiles } from '../contract/contract.ts';
import type { Installation } from '../services/installation.ts';
import type { Paint } from './terminal-colors.ts';

/** A subcommand, as data for the parser and `--help`. */
export interface Command {
  readonly name: string;
  /** Arguments after the name: `PROJECT --out DIR`. */
  readonly usage: string;
  /** Description in one line, for the list of commands. */
  readonly summary: string;
  /** Description in a few sentences. */
  readonly doc: string;
  /** Whether the project or operand is required. */
  readonly project: 'required' | 'optional';
  /** The operand of commands that take something other than a project. */
  readonly operand?: { readonly word: string; readonly doc: string; readonly many?: boolean };
  readonly options: Readonly<Record<string, Option>>;
  readonly examples: readonly Example[];
  run(call: Call, context: Context): Promise<Outcome>;
}

export interface Option {
  readonly type: 'string' | 'boolean';
  /** One-letter alias of the option. */
  readonly short?: string;
  /** Placeholder of the value in `--help`: `DIR`. */
  readonly value?: string;
  /** Pattern of an optional value. The argument after the option is its value only if it matches; otherwise the value is empty. */
  readonly optionalValue?: RegExp;
  readonly doc: string;
}

export interface Example {
  readonly line: string;
  readonly says: string;
}

/** A parsed command line. */
export interface Call {
  /** The first operand, as typed; empty if there is none. */
  readonly project: string;
  /** All operands, for commands that take several. */
  readonly operands: readonly string[];
  text(option: string): string | null;
  flag(option: string): boolean;
}

export interface Context {
  readonly installation: Installation;
  /** Shows a progress text until the next one. Interactive terminals only. */
  say(text: string): void;
  /** Aborts on Ctrl-C. An interrupted command must leave nothing behind. */
  readonly interrupted: AbortSignal;
  /** Colors for diagnostics on standard output. */
  readonly paint: Paint;
  /** Prints to standard output at once, for commands that keep running. */
  print(text: string): void;
}

export interface Outcome {
  /** Exit status of the process, one of `EXIT`. */
  readonly status: 0 | 1;
  /** The JSON value on standard output with `--json`; undefined if the command has printed it already. */
  readonly json: unknown;
  /** Text on standard output without `--json`. */
  readonly text: string;
  /** Diagnostics on standard error without `--json`. */
  readonly diagnostics: readonly Diagnostic[];
  /** Files of the project, from which the titles of nodes in the diagnostics are read. */
  readonly files?: ProjectFiles;
}

/** Exit statuses. A process that a signal ends has 128 plus the number of the signal, as in shells. */
export const EXIT = { done: 0, problems: 1, notUnderstood: 2, ownFault: 70, interrupted: 130, terminated: 143 } as const;

/** The command line is invalid. Exit status 2. */
export class UsageError extends Error {
  override readonly name = 'UsageError';
}

/** Outcome of a command that failed with diagnostics. */
export function failed(diagnostics: readonly Diagnostic[], files?: ProjectFiles): Outcome {
  return { status: 1, json: { ok: false, diagnostics }, text: '', diagnostics, ...(files && { files }) };
}
