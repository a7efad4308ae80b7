import type { CliStreams } from './run-cli.ts';
import { wantsColor } from './terminal-colors.ts';

/** The used part of a writable stream of Node. */
export interface TextStream {
  readonly isTTY?: boolean;
  readonly columns?: number;
  write(text: string): unknown;
}

const CLEAR_LINE = '\r\x1b[2K';

/**
 * Writes the output of a command to two streams. Progress overwrites a single line on `err`, and is omitted if `err` is not a
 * terminal.
 */
export function createTerminal(out: TextStream, err: TextStream, env: Readonly<Record<string, string | undefined>>): CliStreams {
  const interactive = err.isTTY === true;
  let shown = false;
  const clear = () => {
    if (shown) err.write(CLEAR_LINE);
    shown = false;
  };
  return {
    interactive,
    colored: { out: wantsColor(out.isTTY === true, env), err: wantsColor(interactive, env) },
    out: (text) => {
      clear();
      out.write(`${text}\n`);
    },
    err: (text) => {
      clear();
      err.write(`${text}\n`);
    },
    progress: (text) => {
      if (!interactive) return;
      if (text === null) return clear();
      // A wrapped line could not be erased.
      const room = (err.columns ?? 80) - 1;
      err.write(`${CLEAR_LINE}${text.length > room ? `${text.slice(0, room - 1)}…` : text}`);
      shown = true;
    },
  };
}
