import { readdir, rm } from 'node:fs/promises';
import { join } from 'node:path';
import { build } from 'esbuild';
import { writeIfChanged } from '../lib/files.ts';
import type { Found } from './find-nodes.ts';
import { HEADER } from './header.ts';

/** Folder in `nodes/generated/`. */
export const WORKERS_FOLDER = 'workers';

/** `filter/cpu-x` → `filter-cpu-x.gen.ts`. */
export function workerFile(type: string): string {
  return `${type.replace('/', '-')}.gen.ts`;
}

/**
 * One module per `worker.ts`, with the text of a whole worker and the runtime of the node, if there is one: pages start it from a blob, because those opened from a disk get none
 * from a file. Gives what is wrong with those that cannot be bundled.
 */
export async function writeWorkers(root: string, { nodes }: Found): Promise<string[]> {
  const folder = join(root, 'nodes', 'generated', WORKERS_FOLDER);
  const found = nodes.filter(({ hasWorker }) => hasWorker);
  const kept = new Set(found.map(({ type }) => workerFile(type)));
  for (const file of await readdir(folder).catch(() => [])) if (!kept.has(file)) await rm(join(folder, file));
  const problems: string[] = [];
  for (const { type, hasRuntime } of found) {
    try {
      const text = await bundleWorker(root, type, hasRuntime);
      const played = hasRuntime ? `export { create } from '../../${type}/runtime.ts';\n` : '';
      await writeIfChanged(join(folder, workerFile(type)), `${HEADER}\n${played}export const worker = ${JSON.stringify(text)};\n`);
    } catch (error) {
      problems.push(`nodes/${type}/worker.ts: ${error instanceof Error ? error.message : String(error)}`);
    }
  }
  return problems;
}

async function bundleWorker(root: string, type: string, hasRuntime: boolean): Promise<string> {
  const { outputFiles } = await build({
    stdin: {
      contents: hasRuntime ? serveNode(type) : servePixels(type),
      resolveDir: root,
      sourcefile: `${type}.ts`,
      loader: 'ts',
    },
    absWorkingDir: root,
    bundle: true,
    write: false,
    minify: true,
    format: 'iife',
    platform: 'browser',
    target: 'es2022',
    charset: 'utf8',
    logLevel: 'silent',
  });
  return outputFiles[0]?.text ?? '';
}

/** A CPU filter: `process` changes pixels. */
function servePixels(type: string): string {
  return `import { servePixels } from './nodes/kit/serve-pixels.ts';
import { process } from './nodes/${type}/worker.ts';
servePixels(self, process);
`;
}

/** A worker of its own kind: `serve` listens to its runtime. */
function serveNode(type: string): string {
  return `import { serve } from './nodes/${type}/worker.ts';
serve(self);
`;
}
