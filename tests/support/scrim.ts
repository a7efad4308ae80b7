import { resolve } from 'node:path';
import { runCli } from '../../app/cli/run-cli.ts';
import { installationAt } from '../../app/services/installation.ts';

const INSTALLATION = installationAt(resolve(import.meta.dirname, '../..'), '1.2.3');

export interface Said {
  /** Exit status. */
  readonly status: number;
  /** Lines of standard output and standard error. */
  readonly out: string;
  readonly err: string;
}

/** Runs the command line as in a script: not interactive, not colored. */
export async function scrim(...args: string[]): Promise<Said> {
  const out: string[] = [];
  const err: string[] = [];
  const streams = { out: (text: string) => out.push(text), err: (text: string) => err.push(text), interactive: false };
  const status = await runCli(args, INSTALLATION, streams);
  return { status, out: out.join('\n'), err: err.join('\n') };
}

/** Runs the command line, and fails the test unless it succeeds. */
export async function succeed(...args: string[]): Promise<void> {
  const { status, out, err } = await scrim(...args);
  if (status !== 0) throw new Error(`scrim ${args.join(' ')}:\n${out}\n${err}`);
}
