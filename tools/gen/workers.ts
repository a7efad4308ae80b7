import { existsSync } from 'node:fs';
import { readdir, rm } from 'node:fs/promises';
import { join } from 'node:path';
import { build, type Plugin } from 'esbuild';
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
  const kept = new Set([...found.map(({ type }) => workerFile(type)), DECODER_FILE]);
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
  if (existsSync(join(root, DECODER))) {
    const text = await bundleText(root, `import { serve } from './${DECODER}';\nserve(self);\n`, 'decode-radiance.ts', [LITTLE_THREE]);
    await writeIfChanged(join(folder, DECODER_FILE), `${HEADER}\nexport const text = ${JSON.stringify(text)};\n`);
  }
  return problems;
}

/** The worker that decodes panoramas of radiance, which belongs to no node. */
const DECODER = 'export/runtime/scenes/environments/radiance-worker.ts';
const DECODER_FILE = 'decode-radiance.gen.ts';

/** What the loaders of three.js need of it: 3 KB instead of 250. Their base class loads files, which the worker does not. */
const LITTLE_THREE: Plugin = {
  name: 'little three.js',
  setup: ({ onResolve, onLoad, initialOptions }) => {
    onResolve({ filter: /^three$/ }, () => ({ path: 'three', namespace: 'little' }));
    onLoad({ filter: /.*/, namespace: 'little' }, () => ({
      contents: `export * from 'three/src/constants.js';
export { DataUtils } from 'three/src/extras/DataUtils.js';
export class DataTextureLoader {}
`,
      resolveDir: initialOptions.absWorkingDir ?? '',
    }));
  },
};

function bundleWorker(root: string, type: string, hasRuntime: boolean): Promise<string> {
  return bundleText(root, hasRuntime ? serveNode(type) : servePixels(type), `${type}.ts`);
}

async function bundleText(root: string, contents: string, sourcefile: string, plugins: readonly Plugin[] = []): Promise<string> {
  const { outputFiles } = await build({
    stdin: { contents, resolveDir: root, sourcefile, loader: 'ts' },
    plugins: [...plugins],
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
