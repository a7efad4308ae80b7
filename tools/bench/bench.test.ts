import { describe, expect, test } from '@jest/globals';
import { measure, quantile } from './bench.ts';
import { appendResults, printTable, type Recorded, readResults } from './results.ts';

const RECORDED: Recorded = {
  date: '2026-01-02',
  version: '0.1.0',
  commit: 'abc1234',
  name: 'compile, "small"',
  unit: 'ms',
  median: 10,
  p95: 12,
};

describe('bench', () => {
  test('the first sample warms up and does not count', async () => {
    const samples = [100, 3, 1, 2];
    const measured = await measure({ name: 'x', unit: 'ms', samples: 3, sample: () => samples.shift() ?? 0 });
    expect(measured).toEqual({ name: 'x', unit: 'ms', median: 2, p95: 3 });
  });

  test('what never varies is taken once, and what was shared is freed', async () => {
    let taken = 0;
    let disposed = 0;
    await measure({ name: 'x', unit: 'kB', samples: 1, sample: () => ++taken, dispose: () => void disposed++ });
    expect([taken, disposed]).toEqual([1, 1]);
  });

  test('quantiles are samples', () => {
    expect(quantile([1, 2, 3, 4], 0.5)).toBe(3);
    expect(quantile([1, 2, 3, 4], 0.95)).toBe(4);
  });

  test('rows come back from the file as they went in', () => {
    const csv = appendResults(appendResults('', [RECORDED]), [{ ...RECORDED, median: 11 }]);
    expect(csv.split('\n')[0]).toBe('date,version,commit,name,unit,median,p95');
    expect(readResults(csv)).toEqual([RECORDED, { ...RECORDED, median: 11 }]);
  });

  test('the table compares with the last record and keeps quiet below 5 %', () => {
    const rows = printTable(
      [
        { ...RECORDED, median: 12.5 },
        { ...RECORDED, name: 'new', median: 1.23456 },
      ],
      [RECORDED, { ...RECORDED, median: 12 }],
    ).split('\n');
    expect(rows[2]).toBe('| compile, "small" | 12.5 ms | 12 ms | 12 |  |');
    expect(rows[3]).toBe('| new | 1.235 ms | 12 ms |  |  |');
    expect(printTable([{ ...RECORDED, median: 9 }], [RECORDED])).toContain('| −10 % |');
  });
});
