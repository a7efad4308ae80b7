import { Worker } from 'node:worker_threads';
import type { FoundLamps } from '../../../nodes/kit/panorama/found-lamps.ts';
import { type Exposures, exposuresKey, type LampOptions, lampKey, lampOptionsOf } from '../../../nodes/kit/panorama/lamp-options.ts';
import type { Operation, Program } from '../../program/program.ts';
import type { PreparedAsset } from '../assets/prepared-asset.ts';
import { bundleWorker } from '../bundle-worker.ts';
import type { LampWork } from './lamp-thread.ts';

export interface StoredLamps {
  /** The program, in which the nodes with stored lamps start no worker. */
  readonly program: Program;
  readonly assets: readonly PreparedAsset[];
}

interface LampNode {
  readonly operation: Operation;
  /** The asset that stores the lamps. */
  readonly asset: string;
  /** The shots that are merged to the panorama; null if the panorama is one file. */
  readonly exposures: Exposures | null;
  readonly options: LampOptions;
  /** Whether visitors take other panoramas, which the page searches. */
  readonly alsoTaken: boolean;
}

/**
 * Finds the lamps of the panoramas that a project has as files, or as shots that it merges, so that its page neither searches them nor,
 * unless visitors take others, contains the search. A thread decodes, merges and searches. Files that only a browser decodes, such as
 * WebP, are left to the page.
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
  const idle = new Set<Operation>();
  for (const searched of groupBy(nodes, panoramaOf)) {
    const [{ asset, exposures }] = searched;
    const files = (exposures?.shots ?? [asset]).map((id) => assets.find((one) => one.asset.id === id));
    const [first] = files;
    if (!first || files.includes(undefined)) continue;
    const options = searched.map((node) => node.options);
    say(`Finding the lamps of ${first.asset.path}…`);
    const bytes = files.flatMap((file) => file?.bytes ?? []);
    const found = await findApart(script, { files: bytes, stopsApart: exposures?.stopsApart ?? 0, options });
    if (!found) continue;
    const start = exposures ? exposuresKey(exposures) : '';
    const lamps = Object.fromEntries(found.map((one, i) => [start + lampKey(options[i] as LampOptions), one]));
    stored.set(asset, { ...stored.get(asset), ...lamps });
    for (const { operation, alsoTaken } of searched) if (!alsoTaken) idle.add(operation);
  }
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

/** Groups by a key, in the order of the first of each group. */
function groupBy<T>(all: readonly T[], keyOf: (one: T) => string): readonly (readonly [T, ...T[]])[] {
  const groups = new Map<string, [T, ...T[]]>();
  for (const one of all) {
    const group = groups.get(keyOf(one));
    if (group) group.push(one);
    else groups.set(keyOf(one), [one]);
  }
  return [...groups.values()];
}

function panoramaOf({ asset, exposures }: LampNode): string {
  return exposures ? exposuresKey(exposures) : asset;
}

/**
 * The operation as a node that finds lamps in panorama files; empty for all other operations. The environment of a Panorama node is the
 * file itself, and that of Capture panorama until one is taken.
 */
function lampNode({ operations }: Program, operation: Operation): LampNode[] {
  if (!('type' in operation) || operation.type !== 'light/from-panorama') return [];
  const [input] = operation.inputs.environment ?? [];
  if (input?.kind !== 'resource') return [];
  const source = operations.find((other) => other.writes.includes(input.resource));
  if (!source || !('type' in source)) return [];
  const exposures = source.type === 'source/panorama-exposures' ? exposuresOf(source) : null;
  const alsoTaken = source.type === 'source/panorama-capture';
  const asset = alsoTaken || source.type === 'source/panorama' ? source.assets.file : exposures?.shots[0];
  const options = lampOptionsOf(operation.config as Record<keyof LampOptions, unknown>);
  return asset ? [{ operation, asset, exposures, options, alsoTaken }] : [];
}

/** The shots of a Panorama from exposures; null if it has only one, which it shows as it is. */
function exposuresOf({ assets, config }: Extract<Operation, { readonly type: string }>): Exposures | null {
  const { file, file2, file3 } = assets;
  const shots = [file, file2, config.shots === '3' ? file3 : null].filter((id) => typeof id === 'string');
  return shots.length > 1 ? { shots, stopsApart: Number(config.stopsApart) } : null;
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
