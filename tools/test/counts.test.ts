import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { readCounts, unmatchedPaths } from './counts.ts';

/** As Jest 30 writes it, cut down to what is read. */
const REPORT = {
  numPassedTests: 3,
  numFailedTests: 1,
  numPendingTests: 1,
  numRuntimeErrorTestSuites: 1,
  testResults: [
    { name: '/repo/export/graph/load.test.ts', assertionResults: [{ status: 'passed' }, { status: 'passed' }] },
    { name: '/repo/tests/browser/x.test.ts', assertionResults: [{ status: 'passed' }, { status: 'failed' }] },
    {
      name: '/repo/tests/electron/app.test.ts',
      assertionResults: [{ status: 'pending', ancestorTitles: ['the app'], title: 'no display' }],
    },
    { name: '/repo/tests/xr/broken.test.ts', assertionResults: [] },
  ],
};

describe('counts', () => {
  let folder: string;
  let file: string;
  beforeAll(() => {
    folder = mkdtempSync(join(tmpdir(), 'scrim-counts-'));
    file = join(folder, 'test.json');
    writeFileSync(file, JSON.stringify(REPORT));
    writeFileSync(join(folder, 'good.json'), JSON.stringify({ ...REPORT, numFailedTests: 0, numRuntimeErrorTestSuites: 0 }));
  });
  afterAll(() => rmSync(folder, { recursive: true }));

  test('a file that could not run counts as failed, and each project has its line', async () => {
    expect(await readCounts(file)).toEqual({
      passed: 3,
      failed: 2,
      skipped: 1,
      lines: [
        'unit: 2 passed, 0 failed',
        'browser: 1 passed, 1 failed',
        'electron: 0 passed, 0 failed, 1 skipped',
        'xr: 0 passed, 1 failed',
      ],
    });
  });

  test('no file gives no counts', async () => {
    expect(await readCounts(join(folder, 'missing.json'))).toBeNull();
  });

  function lastLine(...args: string[]): { line: string; status: number | null } {
    const { stdout, status } = spawnSync(process.execPath, ['tools/count.mjs', ...args], { encoding: 'utf8' });
    return { line: stdout.trim().split('\n').at(-1) ?? '', status };
  }

  test('the last line of CI sums the runs', () => {
    const good = join(folder, 'good.json');
    expect(lastLine('0', good, '0', good)).toEqual({ line: '6 passed, 0 failed', status: 0 });
    expect(lastLine('1', file, '0', good)).toEqual({ line: '6 passed, 2 failed', status: 1 });
  });

  test('what was skipped stands above the last line of CI, with its reason', () => {
    const { stdout } = spawnSync(process.execPath, ['tools/count.mjs', '1', file], { encoding: 'utf8' });
    expect(stdout.trim().split('\n')).toEqual([
      expect.stringMatching(/^skipped: .*app\.test\.ts › the app › no display$/),
      '3 passed, 2 failed',
    ]);
  });

  test('a path that no test file has is named', async () => {
    expect(await unmatchedPaths(file, ['graph/load', 'tests/browser', 'no-such'])).toEqual(['no-such']);
    expect(await unmatchedPaths(join(folder, 'missing.json'), ['load'])).toEqual(['load']);
  });

  test('a script that failed with all tests passing, and a run that never came about, count as one failure each', () => {
    const good = join(folder, 'good.json');
    expect(lastLine('1', good, '0', good)).toEqual({ line: '6 passed, 1 failed', status: 1 });
    expect(lastLine('1', join(folder, 'missing.json'), '1', join(folder, 'missing.json'))).toEqual({
      line: '0 passed, 2 failed',
      status: 1,
    });
  });

  test('a run that found no tests counts as none, not as a failure', async () => {
    const none = { numPassedTests: 0, numFailedTests: 0, numPendingTests: 0, numRuntimeErrorTestSuites: 0, testResults: [] };
    const empty = join(folder, 'empty.json');
    writeFileSync(empty, JSON.stringify(none));
    expect(await readCounts(empty)).toEqual({ passed: 0, failed: 0, skipped: 0, lines: [] });
    expect(lastLine('0', join(folder, 'good.json'), '0', empty)).toEqual({ line: '3 passed, 0 failed', status: 0 });
  });

  test('the script of CI is a shell script without mistakes of syntax', () => {
    expect(() => execFileSync('bash', ['-n', '.ci/run'])).not.toThrow();
  });
});
