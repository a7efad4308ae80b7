import { execFileSync } from 'node:child_process';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { listFiles, readIfThere, writeIfChanged } from '../lib/files.ts';
import type { ToolContext } from '../lib/tool.ts';
import { type BenchFile, type Measured, measure } from './bench.ts';
import { appendResults, printTable, readResults } from './results.ts';

/**
 * Runs `tools/bench/*.bench.ts`, or those whose name contains one of the arguments, and prints a table with the last recorded
 * results. `--record` adds the results to `bench/results.csv`, once per release.
 */
export async function main(args: readonly string[], context: ToolContext): Promise<number> {
  const { root } = context;
  const record = args.includes('--record');
  const words = args.filter((arg) => !arg.startsWith('--'));
  const names = (await listFiles(join(root, 'tools', 'bench')))
    .flatMap((path) => /^([^/]+)\.bench\.ts$/.exec(path)?.[1] ?? [])
    .filter((name) => words.length === 0 || words.some((word) => name.includes(word)));
  const measured: Measured[] = [];
  const leftOut: string[] = [];
  for (const name of names) {
    // The bundler includes all files that match this pattern.
    const file = (await import(`./${name}.bench.ts`)) as BenchFile;
    const benches = await file.benches(context);
    if (benches.length === 0) leftOut.push(name);
    for (const bench of benches) {
      console.error(`${bench.name} …`);
      measured.push(await measure(bench));
    }
  }
  const path = join(root, 'bench', 'results.csv');
  const csv = (await readIfThere(path)) ?? '';
  console.log(printTable(measured, readResults(csv)));
  for (const { notes } of measured) if (notes !== undefined) console.log(notes);
  if (leftOut.length > 0) console.log(`Not measured, because files are missing (see above): ${leftOut.join(', ')}.`);
  if (record) {
    const stamp = await stampOf(root);
    await writeIfChanged(
      path,
      appendResults(
        csv,
        // A failed measurement gives no figure.
        measured.filter(({ median }) => !Number.isNaN(median)).map((m) => ({ ...m, ...stamp })),
      ),
    );
  }
  return 0;
}

async function stampOf(root: string): Promise<{ date: string; version: string; commit: string }> {
  const { version } = JSON.parse(await readFile(join(root, 'package.json'), 'utf8')) as { version: string };
  const commit = execFileSync('git', ['rev-parse', '--short', 'HEAD'], { cwd: root, encoding: 'utf8' }).trim();
  return { date: new Date().toISOString().slice(0, 10), version, commit };
}
