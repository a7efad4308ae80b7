import { existsSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { expect, test } from '@jest/globals';
import { filterFiles, refuseName } from './filter-template.ts';

test.each([
  ['dark-corners', null],
  ['sepia', 'already'],
  ['Dark Corners', 'lower-case words'],
])('the name %s', (name, refusal) => {
  const said = refuseName(name, new Set(['filter/sepia']));
  if (refusal === null) expect(said).toBeNull();
  else expect(said).toContain(refusal);
});

test('its test is beside those of the other filters, and its imports exist', () => {
  const path = 'tests/browser/dark-corners.test.ts';
  const { [path]: text = '' } = filterFiles('dark-corners');
  const imports = [...text.matchAll(/from '(\.[^']+)'/g)].map(([, from = '']) => join(dirname(path), from));
  expect(imports).toHaveLength(4);
  expect(imports.filter((file) => !existsSync(file))).toEqual([]);
  expect(existsSync('tests/browser/filters.test.ts')).toBe(true);
});
