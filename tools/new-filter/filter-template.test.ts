import { expect, test } from '@jest/globals';
import { refuseName } from './filter-template.ts';

test.each([
  ['dark-corners', null],
  ['sepia', 'already'],
  ['Dark Corners', 'lower-case words'],
])('the name %s', (name, refusal) => {
  const said = refuseName(name, new Set(['filter/sepia']));
  if (refusal === null) expect(said).toBeNull();
  else expect(said).toContain(refusal);
});
