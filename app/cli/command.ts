import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { Installation } from '../services/installation.ts';

/** One subcommand, as data for the parser and for `--help`. */
export interface Command {
  readonly name: string;
  /** What follows the name: `PROJECT --out DIR`. */
  readonly usage: string;
  /** One line for the list of commands. */
  readonly summary: string;
  /** What it does, in a few sentences. */
  readonly doc: string;
  /** Whether a project must be, may be, or cannot be named. */
  readonly project: 'required' | 'optional';
  readonly options: Readonly<Record<string, Option>>;
  readonly examples: readonly Example[];
  run(call: Call, context: Context): Promise<Outcome>;
}

export interface Option {
  readonly type: 'string' | 'boolean';
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
  text(option: string): string | null;
  flag(option: string): boolean;
}

export interface Context {
  readonly installation: Installation;
  /** For progress: shown at once, and only where a person looks on. */
  say(text: string): void;
  /** On standard output at once, for a command that goes on. */
  print(text: string): void;
}

export interface Outcome {
  /** 0 done, 1 something is wrong with the project or the machine. */
  readonly status: 0 | 1;
  /** The one value on standard output with `--json`; undefined where the command has printed it already. */
  readonly json: unknown;
  /** Without `--json`. */
  readonly text: string;
  /** Without `--json`, on standard error. */
  readonly diagnostics: readonly Diagnostic[];
}

/** The command line is not understood: status 2. */
export class UsageError extends Error {
  override readonly name = 'UsageError';
}

/** The outcome of a command that could not do its work. */
export function failed(diagnostics: readonly Diagnostic[]): Outcome {
  return { status: 1, json: { ok: false, diagnostics }, text: '', diagnostics };
}
