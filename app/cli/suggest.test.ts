import { expect, test } from '@jest/globals';
import { didYouMean, nearest } from './suggest.ts';

const WORDS = ['open', 'new', 'check', 'plan', 'export', 'render'];

test.each([
  ['exprot', 'export'],
  ['chekc', 'check'],
  ['Export', 'export'],
  ['ceck', 'check'],
  ['rendr', 'render'],
  ['opne', 'open'],
  ['nw', 'new'],
])('%s is taken for %s', (given, word) => {
  expect(nearest(given, WORDS)).toBe(word);
  expect(didYouMean(given, WORDS)).toBe(` Did you mean "${word}"?`);
});

test.each(['build', 'nope', '', 'x', 'reexported'])('%s is near to nothing', (given) => {
  expect(nearest(given, WORDS)).toBeNull();
  expect(didYouMean(given, WORDS)).toBe('');
});
