import { existsSync, readFileSync } from 'node:fs';
import { expect, test } from '@jest/globals';

const TEXT = readFileSync('docs/SECURITY.md', 'utf8');

/** Rows of the tables that have promises: a table whose head says so, to its end. */
function promises(): readonly (readonly [promise: string, tests: readonly string[]])[] {
  const tables = TEXT.split('| promise | test |\n|---|---|\n').slice(1);
  const rows = tables.flatMap((table) => (table.split('\n\n')[0] ?? '').trim().split('\n'));
  return rows.map((row) => {
    const [, promise = '', tests = ''] = row.split('|').map((cell) => cell.trim());
    return [promise, [...tests.matchAll(/`([^`]+)`/g)].map((match) => match[1] ?? '')];
  });
}

test('every promise names the tests that hold it', () => {
  expect(promises().length).toBeGreaterThan(15);
  for (const [promise, tests] of promises()) expect([promise, tests.length > 0]).toEqual([promise, true]);
});

test('every test that is named is there', () => {
  const named = [...TEXT.matchAll(/`([^`]+\.test\.ts)`/g)].map((match) => match[1] ?? '');
  expect(named.filter((path) => !existsSync(path))).toEqual([]);
});
