import { Worker } from 'node:worker_threads';
import type { NodeDefinition } from '../../../nodes/kit/definition.ts';
import type { Compiled, CompileInput } from '../../compiler/compile.ts';
import type { CompileOptions } from '../../compiler/compile-options.ts';
import { bundleWorker } from '../bundle-worker.ts';

/** Input of the compiler as data that can be sent to a thread. */
export interface CompileWork {
  /**
   * The project after `migrateNodes`. It cannot be migrated in the thread, because migrations are functions, which cannot be sent to
   * threads.
   */
  readonly project: CompileInput['project'];
  readonly definitions: readonly NodeDefinition[];
  readonly shaders: Readonly<Record<string, string>>;
  readonly options: CompileOptions;
}

/**
 * Compiles in a worker thread, so that a server can handle other requests. If interrupted, ends the thread and rejects with the reason of
 * the signal.
 *
 * @param root Absolute path of the folder with Scrim's sources.
 */
export async function compileApart(root: string, work: CompileWork, interrupted?: AbortSignal): Promise<Compiled> {
  const script = await bundleWorker(root, 'export/bundle/compile/compile-worker.ts');
  interrupted?.throwIfAborted();
  const worker = new Worker(script, { eval: true, workerData: { ...work, definitions: work.definitions.map(withoutMigrations) } });
  const end = new AbortController();
  try {
    return await new Promise((resolve, reject) => {
      interrupted?.addEventListener('abort', () => reject(interrupted.reason), { signal: end.signal });
      worker.once('message', resolve);
      worker.once('error', reject);
      worker.once('exit', () => reject(new Error('The compiler ended without an answer.')));
    });
  } finally {
    end.abort();
    await worker.terminate();
  }
}

function withoutMigrations({ migrations: _, ...definition }: NodeDefinition): NodeDefinition {
  return definition;
}
