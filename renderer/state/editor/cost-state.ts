import { createStore, type StoreApi } from 'zustand/vanilla';
import { type ReferenceSize, targetBytes } from '../../../export/compiler/target-bytes.ts';
import type { Program } from '../../../export/program/program.ts';
import { memoryShares, PHONE_GPU_BYTES } from '../../../nodes/kit/phone-memory.ts';
import type { MemoryCost, OperationCost } from '../../preview-costs.ts';

/** State of the performance overlay: its target device and the measurements of the preview. */
export interface CostState {
  readonly on: boolean;
  readonly device: Device;
  readonly measured: readonly OperationCost[];
  /** The GPU objects of nodes that draw themselves and of their assets. */
  readonly memory: readonly MemoryCost[];
}

export type CostStore = StoreApi<CostState>;

export type Device = 'phone' | 'headset';

interface Budget {
  readonly label: string;
  /** Size of one view, as browsers give it to a session. */
  readonly size: ReferenceSize;
  /** Full-screen passes per frame, all views. */
  readonly passes: number;
  readonly bytes: number;
  readonly draws: number;
}

/**
 * Conservative rules of thumb. A full-screen pass over the 2.6 million pixels of a phone reads and writes 20 MB. The two views of a
 * headset have 5.9 million pixels at 72 to 120 Hz, and on tiled GPUs each render target besides that of the session costs a resolve.
 * Draw calls: Meta’s guidance for Quest is 120 to 300 per frame, depending on the other work.
 */
export const BUDGETS: Readonly<Record<Device, Budget>> = {
  phone: { label: 'Phone', size: { widthPx: 1080, heightPx: 2400 }, passes: 6, bytes: 128 * 2 ** 20, draws: 300 },
  headset: { label: 'Headset', size: { widthPx: 1680, heightPx: 1760 }, passes: 4, bytes: 96 * 2 ** 20, draws: 150 },
};

export function createCostState(): CostStore {
  return createStore<CostState>(() => ({ on: false, device: 'phone', measured: [], memory: [] }));
}

/** Cost of a node per frame. */
export interface Cost {
  /** Full-screen passes. */
  readonly passes: number;
  /** Render targets besides the output. */
  readonly targets: number;
  /** Memory on the target device: render targets, and what nodes that draw themselves have on the GPU with their assets. */
  readonly bytes: number;
  readonly draws: number;
  /** GPU time on this computer at the size of the preview; null if not measured. */
  readonly gpuMs: number | null;
}

export const NO_COST: Cost = { passes: 0, targets: 0, bytes: 0, draws: 0, gpuMs: null };

/** Costs by node id of the program (`outer/inner`). Nodes without a cost are absent. */
export function costsOf(
  program: Program,
  { measured, memory, device }: Pick<CostState, 'measured' | 'memory' | 'device'>,
): ReadonlyMap<string, Cost> {
  const byId = new Map(measured.map((cost) => [cost.id, cost]));
  const bytes = targetBytes(program, BUDGETS[device].size);
  const views = device === 'headset' ? 2 : 1;
  const costs = new Map<string, Cost>();
  const add = (node: string, cost: Partial<Cost>) => costs.set(node, sumOf(costs.get(node) ?? NO_COST, { ...NO_COST, ...cost }));
  for (const operation of program.operations) {
    const seen = byId.get(operation.id);
    const written = operation.writes.filter((id) => bytes.has(id));
    const isPass = operation.kind === 'pass';
    if (!isPass && seen === undefined && written.length === 0) continue;
    add(operation.node, {
      passes: isPass ? (operation.view === 'each' ? views : 1) : 0,
      targets: written.length,
      bytes: written.reduce((sum, id) => sum + (bytes.get(id) ?? 0), 0),
      draws: seen?.draws ?? 0,
      gpuMs: seen?.gpuMs ?? null,
    });
  }
  for (const { node, bytes } of memoryOf(program, memory)) add(node, { bytes });
  return costs;
}

/** Memory by node. The first node that uses an asset has all of it. Assets are reduced to their shares, as pages do on phones and headsets. */
function memoryOf({ assets, operations }: Program, memory: readonly MemoryCost[]): { readonly node: string; readonly bytes: number }[] {
  const living = memory.filter(({ isLeft }) => !isLeft);
  const places = assets.filter(({ kind }) => kind === 'capture' || kind === 'splats');
  const files = living.filter(({ kind, name }) => kind === 'asset' && places.some(({ path }) => path === name));
  const shares = memoryShares(
    files.map(({ bytes }) => bytes),
    PHONE_GPU_BYTES,
  );
  const firstUser = (path: string): string | undefined => {
    const ids = new Set(places.filter((place) => place.path === path).map(({ id }) => id));
    return operations.find((operation) => 'assets' in operation && Object.values(operation.assets).some((id) => id !== null && ids.has(id)))
      ?.node;
  };
  return living.flatMap(({ kind, name, bytes }) => {
    if (kind === 'node') return operations.some(({ node }) => node === name) ? [{ node: name, bytes }] : [];
    const node = firstUser(name);
    const share = shares[files.findIndex((file) => file.kind === kind && file.name === name)] ?? bytes;
    return node === undefined ? [] : [{ node, bytes: Math.min(bytes, share) }];
  });
}

/** Messages about GPU objects that remain of removed nodes and assets; empty if there are none. */
export function leftObjects(memory: readonly MemoryCost[]): readonly string[] {
  return memory
    .filter(({ isLeft }) => isLeft)
    .map(({ kind, name, objects, bytes }) => {
      const of = kind === 'node' ? 'removed node' : 'removed file';
      return `${counted(objects, 'GPU object', 'GPU objects')} (${megabytes(bytes)}) of the ${of} ${name} remain. This is a mistake of the node type.`;
    });
}

export function sumOf(a: Cost, b: Cost): Cost {
  return {
    passes: a.passes + b.passes,
    targets: a.targets + b.targets,
    bytes: a.bytes + b.bytes,
    draws: a.draws + b.draws,
    gpuMs: a.gpuMs === null ? b.gpuMs : a.gpuMs + (b.gpuMs ?? 0),
  };
}

/** The sum of all costs. */
export function totalOf(costs: Iterable<Cost>): Cost {
  let total = NO_COST;
  for (const cost of costs) total = sumOf(total, cost);
  return total;
}

/** Cost of a node of the open graph; for a subgraph, the sum of its contents. Null if it has none. */
export function costAt(costs: ReadonlyMap<string, Cost>, path: string): Cost | null {
  const inside = [...costs].filter(([node]) => node === path || node.startsWith(`${path}/`)).map(([, cost]) => cost);
  return inside.length === 0 ? null : totalOf(inside);
}

/** Text of a cost on a node, such as `2 passes · 9.9 MB`. */
export function costWords({ passes, bytes, draws, gpuMs }: Cost): string {
  const parts = [
    passes > 0 ? counted(passes, 'pass', 'passes') : '',
    draws > 0 && passes === 0 ? counted(draws, 'draw', 'draws') : '',
    bytes > 0 ? megabytes(bytes) : '',
    gpuMs === null ? '' : `${gpuMs.toFixed(2)} ms`,
  ].filter(Boolean);
  return parts.length === 0 ? 'free' : parts.join(' · ');
}

/** Messages about the exceeded limits of the budget; empty if there are none. */
export function overBudget(total: Cost, device: Device): readonly string[] {
  const budget = BUDGETS[device];
  const where = device === 'phone' ? 'a phone' : 'a headset';
  return [
    total.passes > budget.passes ? `${total.passes} passes per frame exceed the budget of about ${budget.passes} for ${where}.` : '',
    total.bytes > budget.bytes
      ? `${megabytes(total.bytes)} of graphics memory exceed the budget of ${megabytes(budget.bytes)} for ${where}.`
      : '',
    total.draws > budget.draws ? `${total.draws} draw calls per frame exceed the budget of about ${budget.draws} for ${where}.` : '',
  ].filter(Boolean);
}

export function megabytes(bytes: number): string {
  const mb = bytes / 2 ** 20;
  return `${mb < 10 ? mb.toFixed(1) : Math.round(mb)} MB`;
}

function counted(count: number, one: string, many: string): string {
  return `${count} ${count === 1 ? one : many}`;
}
