import { readFile } from 'node:fs/promises';
import { resolve } from 'node:path';
import { expect, test } from '@jest/globals';
import { overweight, type PageBudget, weighExamples } from '../../tools/page-budget/weigh.ts';

const ROOT = resolve(import.meta.dirname, '../..');

async function readBudget(): Promise<PageBudget> {
  return JSON.parse(await readFile(resolve(ROOT, 'tools/page-budget/budget.json'), 'utf8')) as PageBudget;
}

test('the page of no example is more than 1 % heavier than its budget', async () => {
  expect(overweight(await weighExamples(ROOT), await readBudget())).toEqual([]);
}, 120_000);

test('a page that grows by more than 1 %, and one without a budget, are named', async () => {
  const budget: PageBudget = { reasons: [], pages: { a: { first: 1000, all: 2000 } } };
  expect(overweight({ a: { first: 1010, all: 2020 } }, budget)).toEqual([]);
  expect(overweight({ a: { first: 1011, all: 2020 }, b: { first: 1, all: 1 } }, budget)).toEqual([
    'a: before the first image 1011 bytes of gzip; its budget is 1000.',
    'b has no budget.',
  ]);
});

test('every raise of the budget has a reason', async () => {
  const { reasons } = await readBudget();
  expect(reasons.length).toBeGreaterThan(0);
  for (const reason of reasons) expect(reason.trim().length).toBeGreaterThan(20);
});
