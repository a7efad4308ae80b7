import { createHash } from 'node:crypto';
import { hostname } from 'node:os';
import { performance } from 'node:perf_hooks';
import process from 'node:process';

/** Matches an owner within a file's name: machine, process, when that process began. */
export const OWNER_PATTERN = '[0-9a-f]{8}-[0-9]+-[0-9]+';

/** This process, as it signs its files in a project. When it began tells it from another that had the same number. */
export const OWNER = `${machineTag()}-${process.pid}-${Math.round(performance.timeOrigin)}`;

/** Nothing can be asked about a process of another machine: after a day, what it left counts as left. */
const ELSEWHERE_MS = 24 * 3600 * 1000;

/** Whether the process that signed a file has ended. `touchedMs`: when the file was last written. */
export function isGone(owner: string, touchedMs: number): boolean {
  if (owner === OWNER) return false;
  const [machine, pid] = owner.split('-');
  if (machine !== machineTag()) return Date.now() - touchedMs > ELSEWHERE_MS;
  return Number(pid) === process.pid || !isRunning(Number(pid));
}

function isRunning(pid: number): boolean {
  try {
    // Signal 0 is never sent: the system only says whether it could be.
    process.kill(pid, 0);
    return true;
  } catch (error) {
    return (error as NodeJS.ErrnoException).code === 'EPERM';
  }
}

function machineTag(): string {
  return createHash('sha256').update(hostname()).digest('hex').slice(0, 8);
}
