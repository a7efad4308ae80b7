import { readdirSync, readFileSync } from 'node:fs';

/** Linux reports CPU time in ticks of 10 ms (`sysconf(_SC_CLK_TCK)` is 100 on all systems that Node supports). */
const TICK_MS = 10;

/**
 * CPU time in milliseconds of all child processes and their threads; null without `/proc`. If images are drawn on the CPU, it is the
 * cost of a frame, independent of the load of the machine.
 */
export function childrenCpuMs(): number | null {
  const stats = readStats();
  if (stats.size === 0) return null;
  let sum = 0;
  for (const [pid, { ticks }] of stats) if (isBelow(pid, stats)) sum += ticks;
  return sum * TICK_MS;
}

interface Stat {
  readonly parent: number;
  readonly ticks: number;
}

function readStats(): Map<number, Stat> {
  const stats = new Map<number, Stat>();
  for (const name of entriesOf('/proc')) {
    if (!/^\d+$/.test(name)) continue;
    const stat = parseStat(name);
    if (stat) stats.set(Number(name), stat);
  }
  return stats;
}

function entriesOf(folder: string): readonly string[] {
  try {
    return readdirSync(folder);
  } catch {
    return [];
  }
}

/**
 * Parent and CPU time of a process, from `/proc/PID/stat` (proc(5)): after the name in parentheses follow state and parent; user and system
 * time are fields 14 and 15.
 */
function parseStat(pid: string): Stat | null {
  try {
    const text = readFileSync(`/proc/${pid}/stat`, 'utf8');
    const fields = text.slice(text.lastIndexOf(')') + 2).split(' ');
    return { parent: Number(fields[1]), ticks: Number(fields[11]) + Number(fields[12]) };
  } catch {
    // The process has ended.
    return null;
  }
}

function isBelow(pid: number, stats: ReadonlyMap<number, Stat>): boolean {
  let at: number | undefined = stats.get(pid)?.parent;
  while (at !== undefined && at > 1) {
    if (at === process.pid) return true;
    at = stats.get(at)?.parent;
  }
  return false;
}
