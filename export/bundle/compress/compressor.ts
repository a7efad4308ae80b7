import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { Worker } from 'node:worker_threads';
import type { Plugin } from 'esbuild';
import { bundleWorker } from '../bundle-worker.ts';
import type { CompressedModel, WorkerAnswer } from './compressed-model.ts';

/** Compresses models in a worker thread, which starts with the first model. */
export interface Compressor {
  /** Compresses one model; call it for one at a time. Rejects with an `Error` whose message is text for the user. */
  compress(bytes: Uint8Array): Promise<CompressedModel>;
  dispose(): Promise<void>;
}

/** @param root Absolute path of the folder with Scrim's sources and `node_modules`. */
export function createCompressor(root: string): Compressor {
  let worker: Promise<Worker> | null = null;
  const drop = async () => {
    const dropped = worker;
    worker = null;
    await (await dropped?.catch(() => null))?.terminate();
  };
  return {
    compress: async (bytes) => {
      worker ??= bundleCompressor(root).then(startWorker);
      const answer = await ask(await worker, bytes).catch(async (error: unknown) => {
        // Start a new worker for the next model, because this one may have run out of memory.
        await drop();
        throw error;
      });
      if (answer.ok) return answer.model;
      throw new Error(answer.reason);
    },
    dispose: drop,
  };
}

function bundleCompressor(root: string): Promise<string> {
  const encoder = join(root, 'node_modules/ktx2-encoder/dist/basis/basis_encoder.js');
  return bundleWorker(root, 'export/bundle/compress/compress-worker.ts', {
    // The encoder loads its WebAssembly from the folder of its own file.
    define: { 'import.meta.url': JSON.stringify(pathToFileURL(encoder).href) },
    mainFields: ['main', 'module'],
    plugins: [WITHOUT_SHARP],
  });
}

/** Replaces sharp, a native image library that glTF-Transform imports but does not use here. It fails to load in Electron's older Node. */
const WITHOUT_SHARP: Plugin = {
  name: 'without-sharp',
  setup: ({ onResolve, onLoad }) => {
    onResolve({ filter: /^sharp$/ }, ({ path }) => ({ path, namespace: 'left-out' }));
    onLoad({ filter: /.*/, namespace: 'left-out' }, () => ({ contents: 'export default null;' }));
  },
};

function startWorker(script: string): Worker {
  // The encoder prints to standard output, which may belong to a program.
  const worker = new Worker(script, { eval: true, stdout: true, stderr: true });
  worker.unref();
  return worker;
}

function ask(worker: Worker, bytes: Uint8Array): Promise<WorkerAnswer> {
  return new Promise((resolve, reject) => {
    const end = (settle: () => void) => {
      worker.off('message', onMessage).off('error', onError).off('exit', onExit);
      worker.unref();
      settle();
    };
    const onMessage = (answer: WorkerAnswer) => end(() => resolve(answer));
    const onError = (error: unknown) => end(() => reject(error instanceof Error ? error : new Error(String(error))));
    const onExit = () => end(() => reject(new Error('the compressor ended')));
    worker.on('message', onMessage).on('error', onError).on('exit', onExit);
    worker.ref();
    worker.postMessage(bytes);
  });
}
