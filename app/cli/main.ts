import process from 'node:process';
import manifest from '../../package.json';
import { installationAt } from '../services/installation.ts';
import { runCli } from './run-cli.ts';

/** The command line of the Scrim at `root`; bundled to dist/cli/main.mjs and called by bin/scrim.mjs. */
export async function main(args: readonly string[], root: string): Promise<number> {
  return runCli(args, installationAt(root, manifest.version), {
    out: (text) => process.stdout.write(`${text}\n`),
    err: (text) => process.stderr.write(`${text}\n`),
    interactive: process.stderr.isTTY === true,
  });
}
