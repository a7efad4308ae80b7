import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { hostname } from 'node:os';
import { performance } from 'node:perf_hooks';
import process from 'node:process';

/** Matches an owner within a file's name: machine, process, when that process began. */
export const OWNER_PATTERN = '[0-9a-f]{8}-[0-9]+-[0-9]+';

/** This process, as it signs its files in a project. When it began tells it from another that had the same number. */
export const OWNER = ownerOf(process.pid);

/** Nothing can be asked about a process of another machine: after a day, what it left counts as left. */
const ELSEWHERE_MS = 24 * 3600 * 1000;

/** A process of this machine that runs, as it signs its files. */
export function ownerOf(pid: number): string {
  return `${machineTag()}-${pid}-${startOf(pid) ?? Math.round(performance.timeOrigin)}`;
}

/** Whether the process that signed a file has ended. `touchedMs`: when the file was last written. */
export function isGone(owner: string, touchedMs: number): boolean {
  if (owner === OWNER) return false;
  // A date in the future says as little as one of long ago.
  return isOfThisMachine(owner) ? hasEnded(owner) : Math.abs(Date.now() - touchedMs) > ELSEWHERE_MS;
}

/** Whether the process that signed is known to have ended: false for every other machine's. */
export function hasEnded(owner: string): boolean {
  if (owner === OWNER || !isOfThisMachine(owner)) return false;
  const [, pid, start] = owner.split('-');
  if (Number(pid) === process.pid || !isRunning(Number(pid))) return true;
  const now = startOf(Number(pid));
  return now !== null && now !== start;
}

function isOfThisMachine(owner: string): boolean {
  return owner.startsWith(`${machineTag()}-`);
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

/**
 * When a process began, as a number that no other process of that number has; null where the system does not say, as Windows does
 * to nobody who is in a hurry. Not a time of day: that changes under a process when the clock is set.
 */
function startOf(pid: number): string | null {
  if (process.platform === 'win32') return null;
  const said = process.platform === 'linux' ? startOnLinux(pid) : startByPs(pid);
  return said === null ? null : String(createHash('sha256').update(said).digest().readUIntBE(0, 6));
}

/** proc(5): field 22 of `stat`, counted in ticks since the system began, and which beginning that was. */
function startOnLinux(pid: number): string | null {
  try {
    const stat = readFileSync(`/proc/${pid}/stat`, 'utf8');
    // The name of the program, in brackets, may hold anything.
    const ticks = stat.slice(stat.lastIndexOf(')') + 2).split(' ')[19];
    return `${readFileSync('/proc/sys/kernel/random/boot_id', 'utf8')} ${ticks}`;
  } catch {
    return null;
  }
}

function startByPs(pid: number): string | null {
  const { stdout } = spawnSync('ps', ['-o', 'lstart=', '-p', String(pid)], { encoding: 'utf8', env: { LC_ALL: 'C', TZ: 'UTC' } });
  const said = stdout?.trim() ?? '';
  return said === '' ? null : said;
}

function machineTag(): string {
  return createHash('sha256').update(hostname()).digest('hex').slice(0, 8);
}
