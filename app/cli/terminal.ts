import type { CliStreams } from './run-cli.ts';
import { wantsColor } from './terminal-colors.ts';

/** As much of a stream of Node's as is written to. */
export interface TextStream {
  readonly isTTY?: boolean;
  readonly columns?: number;
  write(text: string): unknown;
}

const CLEAR_LINE = '\r\x1b[2K';

/**
 * The words of a command line on two streams. Progress is one line that is written over again, for people alone: where `err` is
 * no terminal there is none of it.
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
      // A line that wraps could not be taken back.
      const room = (err.columns ?? 80) - 1;
      err.write(`${CLEAR_LINE}${text.length > room ? `${text.slice(0, room - 1)}…` : text}`);
      shown = true;
    },
  };
}
