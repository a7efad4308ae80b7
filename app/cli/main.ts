import process from 'node:process';
import manifest from '../../package.json';
import { installationAt } from '../services/installation.ts';
import { EXIT } from './command.ts';
import { runCli } from './run-cli.ts';
import { createTerminal } from './terminal.ts';

/** Runs the command line of the Scrim at `root`. Bundled to dist/cli/main.mjs and called by bin/scrim.mjs. */
export async function main(args: readonly string[], root: string): Promise<number> {
  const terminal = createTerminal(process.stdout, process.stderr, process.env);
  leaveWithReader();
  const interruption = new AbortController();
  let ended: number | null = null;
  for (const [signal, status] of SIGNALS) {
    process.on(signal, () => {
      // A second signal ends the process at once.
      if (ended !== null) process.exit(status);
      ended = status;
      interruption.abort();
    });
  }
  try {
    const status = await runCli(args, installationAt(root, manifest.version), terminal, interruption.signal);
    // Ctrl-C is the normal way to end the served editor.
    return ended === null || args[0] === 'open' ? status : ended;
  } catch (error) {
    terminal.err(`Scrim has an internal error: ${error instanceof Error ? (error.stack ?? error.message) : String(error)}`);
    return EXIT.ownFault;
  }
}

const SIGNALS = [
  ['SIGINT', EXIT.interrupted],
  ['SIGTERM', EXIT.terminated],
] as const;

/** Exits quietly when the reader of a pipe closes it, as in `scrim plan … | head`. */
function leaveWithReader(): void {
  process.stdout.on('error', (error: NodeJS.ErrnoException) => {
    if (error.code === 'EPIPE') process.exit(EXIT.done);
    throw error;
  });
}
