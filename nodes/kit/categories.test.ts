import { expect, test } from '@jest/globals';
import { categoryLabel } from './categories.ts';

test.each([
  ['filter/sepia', 'filter'],
  ['operator/over', 'composite'],
  ['technique/toon', 'material'],
  ['graph/soft-look', 'subgraph'],
  ['combination/room-shadow', 'recipe'],
])('%s is shown under %s', (type, label) => {
  expect(categoryLabel(type)).toBe(label);
});
