import { join, resolve } from 'node:path';
import { expect, test } from '@jest/globals';
import { weighScripts } from './bare-page.ts';

const ROOT = resolve(import.meta.dirname, '../..');

test('the scripts of the first example have at most 1.15 times the bytes of a page by hand that does the same in plain three.js', async () => {
  const { first, all, wholeThree, bare } = await weighScripts(ROOT, join(ROOT, 'examples/first-light'));
  expect(all.gzip / bare.gzip).toBeLessThan(1.15);
  expect(first.gzip).toBeLessThan(all.gzip);
  // What is left out of three.js is worth its rules.
  expect(all.gzip / wholeThree.gzip).toBeLessThan(0.9);
}, 60_000);
