import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import type { ToolMain } from '../lib/tool.ts';
import { overweight, type PageBudget, weighExamples } from './weigh.ts';

/**
 * `npm run page-budget` weighs the scripts of all examples' pages and compares them with `budget.json`. `-- --raise "REASON"` stores the
 * new weights with the reason.
 */
export const main: ToolMain = async (args, { root }) => {
  const file = join(root, 'tools/page-budget/budget.json');
  const [flag, reason] = args;
  if (flag !== undefined && (flag !== '--raise' || reason === undefined || reason.trim() === '')) {
    console.error('Usage: npm run page-budget [-- --raise "REASON"]');
    return 2;
  }
  const budget = JSON.parse(await readFile(file, 'utf8')) as PageBudget;
  const weights = await weighExamples(root);
  for (const [name, { first, all }] of Object.entries(weights)) {
    const before = budget.pages[name];
    const share = before ? `${((100 * first) / before.first - 100).toFixed(1)} %` : 'new';
    console.log(`${name.padEnd(40)}${String(first).padStart(9)}${String(all).padStart(9)}  ${share}`);
  }
  if (reason !== undefined) {
    const raised: PageBudget = { reasons: [...budget.reasons, reason], pages: weights };
    await writeFile(file, `${JSON.stringify(raised, null, 2)}\n`);
    return 0;
  }
  const faults = overweight(weights, budget);
  for (const fault of faults) console.error(fault);
  if (faults.length > 0)
    console.error('Make the pages smaller, or raise the budget with a reason: npm run page-budget -- --raise "REASON"');
  return faults.length > 0 ? 1 : 0;
};
