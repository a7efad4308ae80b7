import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { hostname } from 'node:os';
import { performance } from 'node:perf_hooks';
import process from 'node:process';

/** Matches an owner in a file name: machine, process id, start time of the process. */
export const OWNER_PATTERN = '[0-9a-f]{8}-[0-9]+-[0-9]+';

/** Identifies this process in file names. The start time distinguishes it from an earlier process with the same id. */
export const OWNER = ownerOf(process.pid);

/** Processes of other machines cannot be checked. Their files count as abandoned after a day. */
const ELSEWHERE_MS = 24 * 3600 * 1000;

/** Owner string of a running process of this machine. */
export function ownerOf(pid: number): string {
  return `${machineTag()}-${pid}-${startOf(pid) ?? Math.round(performance.timeOrigin)}`;
}

/** Whether the owner of a file has ended. `touchedMs`: modification time of the file. */
export function isGone(owner: string, touchedMs: number): boolean {
  if (owner === OWNER) return false;
  // A date in the future is as unreliable as an old one.
  return isOfThisMachine(owner) ? hasEnded(owner) : Math.abs(Date.now() - touchedMs) > ELSEWHERE_MS;
}

/** Whether the owner is known to have ended. False for other machines. */
export function hasEnded(owner: string): boolean {
  if (owner === OWNER || !isOfThisMachine(owner)) return false;
  const [, pid, start] = owner.split('-');
  if (Number(pid) === process.pid || !isRunning(Number(pid))) return true;
  const now = startOf(Number(pid));
  return now !== null && now !== start;
}

/** An owner in messages. */
export function wordsOf(owner: string): string {
  if (owner === OWNER) return 'Another window of this Scrim';
  return isOfThisMachine(owner) ? `Another Scrim (process ${owner.split('-')[1]})` : 'A Scrim on another computer';
}

function isOfThisMachine(owner: string): boolean {
  return owner.startsWith(`${machineTag()}-`);
}

function isRunning(pid: number): boolean {
  try {
    // Signal 0 is not sent; it only checks whether the process exists.
    process.kill(pid, 0);
    return true;
  } catch (error) {
    return (error as NodeJS.ErrnoException).code === 'EPERM';
  }
}

/**
 * Start time of a process, in an arbitrary unit; null if the system does not provide it quickly, as on Windows. Not the time of day,
 * which changes when the clock is set.
 */
function startOf(pid: number): string | null {
  if (process.platform === 'win32') return null;
  const said = process.platform === 'linux' ? startOnLinux(pid) : startByPs(pid);
  return said === null ? null : String(createHash('sha256').update(said).digest().readUIntBE(0, 6));
}

/** proc(5): field 22 of `stat` in clock ticks since boot, combined with the boot id. */
function startOnLinux(pid: number): string | null {
  try {
    const stat = readFileSync(`/proc/${pid}/stat`, 'utf8');
    // The program name in parentheses may contain any character.
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
