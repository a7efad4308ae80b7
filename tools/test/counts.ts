import { readFile } from 'node:fs/promises';

/** The part of Jest's `--json` report that the summary reads. */
interface JestReport {
  readonly numPassedTests: number;
  readonly numFailedTests: number;
  readonly numPendingTests: number;
  /** Number of test files that failed before their tests could run. */
  readonly numRuntimeErrorTestSuites: number;
  readonly testResults: readonly { readonly name: string; readonly assertionResults: readonly { readonly status: string }[] }[];
}

export interface Counts {
  readonly passed: number;
  readonly failed: number;
  readonly skipped: number;
  /** One line per project, such as `unit: 89 passed, 0 failed`. */
  readonly lines: readonly string[];
}

/** Reads the counts from the report of a run; null if Jest wrote none. A test file that could not run counts as one failed test. */
export async function readCounts(file: string): Promise<Counts | null> {
  const report = await readReport(file);
  if (report === null) return null;
  return {
    passed: report.numPassedTests,
    failed: report.numFailedTests + report.numRuntimeErrorTestSuites,
    skipped: report.numPendingTests,
    lines: perProject(report),
  };
}

/** Those of `paths` that match no test file of the run. Paths are patterns without regard to case, as Jest takes them. */
export async function unmatchedPaths(file: string, paths: readonly string[]): Promise<readonly string[]> {
  const names = (await readReport(file))?.testResults.map(({ name }) => name) ?? [];
  return paths.filter((path) => !names.some((name) => new RegExp(path, 'i').test(name)));
}

async function readReport(file: string): Promise<JestReport | null> {
  const text = await readFile(file, 'utf8').catch(() => null);
  return text === null ? null : (JSON.parse(text) as JestReport);
}

function perProject(report: JestReport): string[] {
  const statuses = new Map<string, string[]>();
  for (const { name, assertionResults } of report.testResults) {
    const project = /\/tests\/(browser|xr|electron|slow)\//.exec(name)?.[1] ?? 'unit';
    const found = assertionResults.length === 0 ? ['failed'] : assertionResults.map((result) => result.status);
    statuses.set(project, [...(statuses.get(project) ?? []), ...found]);
  }
  return [...statuses].map(([project, all]) => {
    const count = (status: string) => all.filter((s) => s === status).length;
    const skipped = count('pending');
    return `${project}: ${count('passed')} passed, ${count('failed')} failed${skipped > 0 ? `, ${skipped} skipped` : ''}`;
  });
}
