import { spawn } from 'node:child_process';
import { appendFile } from 'node:fs/promises';
import { basename } from 'node:path';
import process from 'node:process';
import { createInterface } from 'node:readline';
import { endGroupWithProcess } from '../end-with-process.ts';
import { refusal } from '../file-errors.ts';

export interface ToolRun {
  /** Absolute path of the executable file. */
  readonly tool: string;
  /** Passed as they are: no shell reads them. */
  readonly args: readonly string[];
  /** Everything that the tool prints is appended to this file; null: it is not kept. */
  readonly log: string | null;
  /** Ends a tool that runs longer, as a program that waits for input. Absent: it may run as long as it wants. */
  readonly limitMs?: number;
  /** Whether any exit status is a success, as of programs that fail when they print their help. Default: false. */
  readonly anyStatus?: boolean;
  /** Called with each line that the tool prints. */
  readonly onLine: (line: string) => void;
  readonly interrupted: AbortSignal;
}

/** Time for a tool to end by itself after it was asked to. */
const GRACE_MS = 2000;
/** Lines that are kept for the message of a failure. */
const KEPT_LINES = 3;
/** Of more lines, the first ones are forgotten; the log has all. */
const MOST_LINES = 10_000;

/**
 * Runs a tool until it ends.
 *
 * @returns What it printed.
 * @throws SCR078 if it does not start, runs too long, or with its last lines if it fails; system errors if the log cannot be written, after
 * the tool was ended; the reason of the signal after it was ended on an interrupt
 */
export async function runTool({ tool, args, log, limitMs, anyStatus = false, onLine, interrupted }: ToolRun): Promise<readonly string[]> {
  interrupted.throwIfAborted();
  let written = Promise.resolve();
  const write = (line: string): void => {
    if (log === null) return;
    written = written.then(() => appendFile(log, `${line}\n`));
    // It is awaited when the tool has ended.
    written.catch(() => cancel());
  };
  const isWindows = process.platform === 'win32';
  // A group of its own, so that the processes that the tool starts end with it.
  const child = spawn(tool, [...args], {
    stdio: ['ignore', 'pipe', 'pipe'],
    detached: !isWindows,
    // Tools with windows need no screen.
    env: { ...process.env, QT_QPA_PLATFORM: 'offscreen' },
  });
  // Killed, this process could not end the tool, which would write beside that of the next process.
  const ended = child.pid === undefined ? () => {} : endGroupWithProcess(child.pid);
  const end = (signal: 'SIGTERM' | 'SIGKILL'): void => {
    if (child.pid === undefined) return;
    try {
      if (isWindows) child.kill(signal);
      else process.kill(-child.pid, signal);
    } catch {
      // It has ended already.
    }
  };
  const endAtOnce = () => end('SIGKILL');
  let killer: NodeJS.Timeout | undefined;
  const cancel = () => {
    end('SIGTERM');
    killer = setTimeout(endAtOnce, GRACE_MS);
  };
  write(`\n$ ${[tool, ...args].map((part) => JSON.stringify(part)).join(' ')}`);
  interrupted.addEventListener('abort', cancel, { once: true });
  let isLate = false;
  const late = () => {
    isLate = true;
    cancel();
  };
  const limit = limitMs === undefined ? undefined : setTimeout(late, limitMs);
  process.once('exit', endAtOnce);
  const lines: string[] = [];
  const read = async (stream: NodeJS.ReadableStream): Promise<void> => {
    for await (const line of createInterface({ input: stream })) {
      write(line);
      lines.push(line);
      if (lines.length > MOST_LINES) lines.splice(0, MOST_LINES / 2);
      onLine(line);
    }
  };
  try {
    const closed = new Promise<number | string | null>((resolve, reject) => {
      child.on('error', ({ message }) =>
        reject(refusal('SCR078', `${tool} does not start: ${message}.`, 'Install it again, or name another file.')),
      );
      child.on('close', (code, signal) => resolve(signal ?? code));
    });
    const [status] = await Promise.all([closed, read(child.stdout), read(child.stderr)]);
    await written;
    interrupted.throwIfAborted();
    const name = `${basename(tool)} ${args[0] ?? ''}`.trim();
    if (isLate) throw refusal('SCR078', `${name} did not end within ${Math.round((limitMs ?? 0) / 1000)} s.`, 'Name another file.');
    if (status === 0 || (anyStatus && typeof status === 'number')) return lines;
    const last = lines.filter((line) => line.trim() !== '').slice(-KEPT_LINES);
    const how = typeof status === 'number' ? `with status ${status}` : `by ${status}`;
    throw refusal(
      'SCR078',
      `${name} ended ${how}: ${last.join(' ').trim() || 'it printed nothing'}`,
      [status === 'SIGKILL' && MEMORY_FIX, log && `Read ${log}.`].filter((text) => text).join(' ') ||
        'Name another file, or install it again.',
    );
  } finally {
    ended();
    clearTimeout(limit);
    clearTimeout(killer);
    interrupted.removeEventListener('abort', cancel);
    process.off('exit', endAtOnce);
  }
}

const MEMORY_FIX = 'The system may have ended it because memory ran out: use fewer or smaller photographs.';
