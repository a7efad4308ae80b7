import { Worker } from 'node:worker_threads';
import type { FoundLamps } from '../../../nodes/kit/panorama/found-lamps.ts';
import { type LampOptions, lampKey, lampOptionsOf } from '../../../nodes/kit/panorama/lamp-options.ts';
import type { Operation, Program } from '../../program/program.ts';
import type { PreparedAsset } from '../assets/prepare-assets.ts';
import { bundleWorker } from '../bundle-worker.ts';
import type { LampWork } from './lamp-thread.ts';

export interface StoredLamps {
  /** The program, in which the nodes with stored lamps start no worker. */
  readonly program: Program;
  readonly assets: readonly PreparedAsset[];
}

interface LampNode {
  readonly operation: Operation & { readonly type: string };
  readonly asset: string;
  readonly options: LampOptions;
}

/**
 * Finds the lamps of the panoramas that a project has as files, so that its page neither searches them nor contains the search. A thread
 * decodes and searches. Files that only a browser decodes, such as WebP, are left to the page.
 */
export async function storeLamps(
  program: Program,
  assets: readonly PreparedAsset[],
  { root, say }: { readonly root: string; readonly say: (text: string) => void },
): Promise<StoredLamps> {
  const nodes = program.operations.flatMap((operation) => lampNode(program, operation));
  if (nodes.length === 0) return { program, assets };
  const script = await bundleWorker(root, 'export/bundle/lamps/lamp-thread.ts');
  const stored = new Map<string, Record<string, FoundLamps>>();
  for (const id of new Set(nodes.map(({ asset }) => asset))) {
    const prepared = assets.find(({ asset }) => asset.id === id);
    if (!prepared) continue;
    const options = nodes.filter(({ asset }) => asset === id).map((node) => node.options);
    say(`Finding the lamps of ${prepared.asset.path}…`);
    const found = await findApart(script, { bytes: prepared.bytes, options });
    if (found) stored.set(id, Object.fromEntries(found.map((lamps, i) => [lampKey(options[i] as LampOptions), lamps])));
  }
  const idle = new Set<Operation>(nodes.filter(({ asset }) => stored.has(asset)).map(({ operation }) => operation));
  return {
    program: {
      ...program,
      operations: program.operations.map((operation) => (idle.has(operation) ? withoutWorker(operation) : operation)),
    },
    assets: assets.map((prepared) => {
      const lamps = stored.get(prepared.asset.id);
      return lamps ? { ...prepared, asset: { ...prepared.asset, lamps } } : prepared;
    }),
  };
}

/**
 * The operation as a node that finds lamps in a panorama file; empty for all other operations. An environment from a Panorama node is the
 * file itself, because that is the node's only output.
 */
function lampNode({ operations }: Program, operation: Operation): LampNode[] {
  if (!('type' in operation) || operation.type !== 'light/from-panorama') return [];
  const [input] = operation.inputs.environment ?? [];
  if (input?.kind !== 'resource') return [];
  const source = operations.find((other) => other.writes.includes(input.resource));
  const asset = source && 'type' in source && source.type === 'source/panorama' ? source.assets.file : null;
  return asset ? [{ operation, asset, options: lampOptionsOf(operation.config as Record<keyof LampOptions, unknown>) }] : [];
}

function withoutWorker(operation: Operation): Operation {
  const { worker: _, ...rest } = operation as Operation & { worker?: true };
  return rest as Operation;
}

/** Finds the lamps of a file in a thread. Null if the file cannot be decoded here; the page then says what is wrong with it. */
async function findApart(script: string, work: LampWork): Promise<readonly FoundLamps[] | null> {
  const worker = new Worker(script, { eval: true, workerData: work });
  try {
    return await new Promise((resolve) => {
      worker.once('message', resolve);
      worker.once('error', () => resolve(null));
      worker.once('exit', () => resolve(null));
    });
  } finally {
    await worker.terminate();
  }
}
