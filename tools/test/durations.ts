import { readFile } from 'node:fs/promises';
import { relative, sep } from 'node:path';

/** Shorter files are not recorded: their order makes no difference. */
const RECORDED_FROM_S = 5;

/** Test file, relative to the root → seconds. */
export type Durations = Readonly<Record<string, number>>;

/** The part of Jest's `--json` report with the times of files. */
interface TimedReport {
  readonly testResults: readonly { readonly name: string; readonly startTime: number; readonly endTime: number; readonly status: string }[];
}

/** Reads how long the passed files of a run took; null if Jest wrote no report. */
export async function readDurations(reportFile: string, root: string): Promise<Durations | null> {
  const text = await readFile(reportFile, 'utf8').catch(() => null);
  if (text === null) return null;
  const passed = (JSON.parse(text) as TimedReport).testResults.filter(({ status }) => status === 'passed');
  return Object.fromEntries(
    passed.map(({ name, startTime, endTime }) => [relative(root, name).split(sep).join('/'), Math.round((endTime - startTime) / 1000)]),
  );
}

/** Replaces what was recorded of the measured files. Returns the long files that `exists` accepts, the longest first. */
export function mergeDurations(recorded: Durations, measured: Durations, exists: (path: string) => boolean): Durations {
  const all = Object.entries({ ...recorded, ...measured });
  return Object.fromEntries(
    all.filter(([path, seconds]) => seconds >= RECORDED_FROM_S && exists(path)).sort(([a, m], [b, n]) => n - m || (a < b ? -1 : 1)),
  );
}
