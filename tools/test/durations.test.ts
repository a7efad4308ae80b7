import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { mergeDurations, readDurations } from './durations.ts';

/** The part of Jest's sequencers that is called here. */
type SequencerClass = new (options: object) => { sort(tests: readonly object[]): readonly { readonly path: string }[] };

describe('recorded durations', () => {
  let folder: string;
  beforeAll(() => {
    folder = mkdtempSync(join(tmpdir(), 'scrim-durations-'));
    const result = (path: string, seconds: number, status = 'passed') => ({
      name: join(folder, path),
      status,
      startTime: 1000,
      endTime: 1000 + 1000 * seconds,
    });
    const testResults = [result('tests/xr/a.test.ts', 41.6), result('nodes/b.test.ts', 2), result('tests/xr/c.test.ts', 0.1, 'failed')];
    writeFileSync(join(folder, 'run.json'), JSON.stringify({ testResults }));
  });
  afterAll(() => rmSync(folder, { recursive: true }));

  test('are whole seconds of the files that passed', async () => {
    expect(await readDurations(join(folder, 'run.json'), folder)).toEqual({ 'tests/xr/a.test.ts': 42, 'nodes/b.test.ts': 2 });
    expect(await readDurations(join(folder, 'missing.json'), folder)).toBeNull();
  });

  test('keep the files that did not run, and leave out those that are short or gone, the longest first', () => {
    const merged = mergeDurations({ gone: 90, kept: 7, short: 8, slow: 20 }, { slow: 30, short: 1, long: 60 }, (path) => path !== 'gone');
    expect(Object.entries(merged)).toEqual([
      ['long', 60],
      ['slow', 30],
      ['kept', 7],
    ]);
  });

  test('start the longest file first where Jest has not run yet', async () => {
    const config = { rootDir: folder, cacheDirectory: folder, id: 'fresh', cache: true, haste: {} };
    const context = { config, hasteFS: { getSize: () => 1 } };
    const tests = ['nodes/unrecorded.test.ts', 'tests/xr/first-light.test.ts', 'tests/slow/electron-story.test.ts'];
    const sequencer: string = resolve(import.meta.dirname, '../../tests/support/longest-first.mjs');
    const { default: LongestFirst } = (await import(sequencer)) as { default: SequencerClass };
    const order = new LongestFirst({}).sort(tests.map((path) => ({ path: join(folder, path), context })));
    expect(order.map(({ path }) => path.slice(folder.length + 1))).toEqual(tests.reverse());
  });
});
