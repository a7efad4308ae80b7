import { readdir, rm } from 'node:fs/promises';
import { join } from 'node:path';
import { build } from 'esbuild';
import { writeIfChanged } from '../lib/files.ts';
import type { Found } from './find-nodes.ts';
import { HEADER } from './header.ts';

/** Folder of the bundled workers in `nodes/generated/`. */
export const WORKERS_FOLDER = 'workers';

/** File name of the bundled worker of a node type: `filter/cpu-x` → `filter-cpu-x.gen.ts`. */
export function workerFile(type: string): string {
  return `${type.replace('/', '-')}.gen.ts`;
}

/**
 * Writes one module per `worker.ts`. The module exports the bundled worker as text, and the runtime of the node if there is one. Pages
 * start the worker from a blob, because a page that is opened from a disk cannot start a worker from a file.
 * @returns Problems of workers that cannot be bundled.
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

/** Source of the worker of a CPU filter. `process` of its `worker.ts` changes pixels. */
function servePixels(type: string): string {
  return `import { servePixels } from './nodes/kit/serve-pixels.ts';
import { process } from './nodes/${type}/worker.ts';
servePixels(self, process);
`;
}

/** Source of the worker of a node with a runtime. `serve` of its `worker.ts` handles the messages of the runtime. */
function serveNode(type: string): string {
  return `import { serve } from './nodes/${type}/worker.ts';
serve(self);
`;
}
