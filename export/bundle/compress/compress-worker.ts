import { parentPort } from 'node:worker_threads';
import { compressModel } from './compress-model.ts';
import type { WorkerAnswer } from './compressed-model.ts';

/** Entry of the worker thread, which compresses one model per message. */
parentPort?.on('message', (bytes: Uint8Array) => {
  void answer(bytes).then((reply) => parentPort?.postMessage(reply));
});

async function answer(bytes: Uint8Array): Promise<WorkerAnswer> {
  try {
    return { ok: true, model: await compressModel(bytes) };
  } catch (error) {
    return { ok: false, reason: error instanceof Error ? error.message : String(error) };
  }
}
