import { spawn } from 'node:child_process';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import process from 'node:process';
import { listFiles } from '../lib/files.ts';
import type { ToolContext } from '../lib/tool.ts';

/** Number of compilers that run at once. The compiler itself is parallel, and a third process gains nothing on two cores. */
const AT_ONCE = 2;

interface Check {
  readonly config: string;
  readonly ok: boolean;
  readonly output: string;
}

/** Runs the TypeScript compiler over every `tsconfig*.json`, or over those whose path starts with one of the arguments. */
export async function main(args: readonly string[], { root }: ToolContext): Promise<number> {
  const configs = (await findConfigs(root)).filter((path) => args.length === 0 || args.some((arg) => path.startsWith(arg)));
  const checks = await inTurns(configs, AT_ONCE, (config) => check(root, config));
  const failed = checks.filter((c) => !c.ok);
  for (const { config, output } of failed) console.error(`${config}:\n${output.trimEnd()}\n`);
  const summary = `Types: ${checks.length - failed.length} of ${checks.length} configurations are right`;
  console.log(failed.length === 0 ? `${summary}.` : `${summary}; wrong: ${failed.map((c) => c.config).join(', ')}.`);
  return failed.length === 0 ? 0 : 1;
}

/** Paths of all tsconfig files except the base that the others extend. */
async function findConfigs(root: string): Promise<string[]> {
  const files = await listFiles(root, (path) => path === 'tests/output');
  return files.filter((path) => /(^|\/)tsconfig[^/]*\.json$/.test(path) && path !== 'tsconfig.base.json');
}

function check(root: string, config: string): Promise<Check> {
  const tsc = createRequire(join(root, 'package.json')).resolve('typescript/package.json').replace('package.json', 'bin/tsc');
  return new Promise((resolve, reject) => {
    const child = spawn(process.execPath, [tsc, '-p', config, '--pretty', 'false'], { cwd: root });
    let output = '';
    child.stdout.on('data', (chunk) => {
      output += chunk;
    });
    child.stderr.on('data', (chunk) => {
      output += chunk;
    });
    child.on('error', reject);
    child.on('close', (code) => resolve({ config, ok: code === 0 || isEmpty(output), output }));
  });
}

/** Whether the only error is TS18003: the layer has no files yet. */
function isEmpty(output: string): boolean {
  const lines = output.trim().split('\n');
  return lines.length === 1 && lines[0]?.includes('TS18003') === true;
}

async function inTurns<T, R>(items: readonly T[], atOnce: number, work: (item: T) => Promise<R>): Promise<R[]> {
  const results: R[] = [];
  let next = 0;
  const turn = async () => {
    while (next < items.length) {
      const index = next++;
      results[index] = await work(items[index] as T);
    }
  };
  await Promise.all(Array.from({ length: atOnce }, turn));
  return results;
}
