import { createStore, type StoreApi } from 'zustand/vanilla';
import { type ReferenceSize, targetBytes, targetsOf } from '../../../export/compiler/target-bytes.ts';
import type { Program } from '../../../export/program/program.ts';
import type { OperationCost } from '../../preview-protocol.ts';

/** Whether costs are drawn on the graph, for which device, and what the preview measured. */
export interface CostState {
  readonly on: boolean;
  readonly device: Device;
  readonly measured: readonly OperationCost[];
}

export type CostStore = StoreApi<CostState>;

export type Device = 'phone' | 'headset';

interface Budget {
  readonly label: string;
  /** Of one view, as browsers give it to a session. */
  readonly size: ReferenceSize;
  /** Full-screen passes a frame, all views. */
  readonly passes: number;
  readonly bytes: number;
  readonly draws: number;
}

/**
 * Rules of thumb, on the careful side. A full-screen pass over a phone's 2.6 million pixels reads and writes 20 MB; a headset's two
 * views have 5.9 million, at 72 to 120 frames per second, and every target besides the session's own costs a resolve on tiled GPUs.
 * Draws: Meta's guidance for Quest asks for 120 to 300 a frame, by how much else there is to do.
 */
export const BUDGETS: Readonly<Record<Device, Budget>> = {
  phone: { label: 'Phone', size: { widthPx: 1080, heightPx: 2400 }, passes: 6, bytes: 128 * 2 ** 20, draws: 300 },
  headset: { label: 'Headset', size: { widthPx: 1680, heightPx: 1760 }, passes: 4, bytes: 96 * 2 ** 20, draws: 150 },
};

export function createCostState(): CostStore {
  return createStore<CostState>(() => ({ on: false, device: 'phone', measured: [] }));
}

/** What a node asks of the GPU in each frame. */
export interface Cost {
  /** Full-screen passes, a frame. */
  readonly passes: number;
  /** Pictures that it draws into, besides the screen. */
  readonly targets: number;
  /** Texture memory of these on the chosen device. */
  readonly bytes: number;
  readonly draws: number;
  /** On this computer, in the preview's size. */
  readonly gpuMs: number | null;
}

export const NO_COST: Cost = { passes: 0, targets: 0, bytes: 0, draws: 0, gpuMs: null };

/** By node, as the program names it: `outer/inner`. Only those that cost something. */
export function costsOf(program: Program, measured: readonly OperationCost[], device: Device): ReadonlyMap<string, Cost> {
  const byId = new Map(measured.map((cost) => [cost.id, cost]));
  const targets = new Map(targetsOf(program).map((target) => [target.id, target]));
  const views = device === 'headset' ? 2 : 1;
  const costs = new Map<string, Cost>();
  const add = (node: string, cost: Partial<Cost>) => costs.set(node, sumOf(costs.get(node) ?? NO_COST, { ...NO_COST, ...cost }));
  for (const operation of program.operations) {
    const seen = byId.get(operation.id);
    const written = operation.writes.flatMap((id) => targets.get(id) ?? []);
    const isPass = operation.kind === 'pass';
    if (!isPass && seen === undefined && written.length === 0) continue;
    add(operation.node, {
      passes: isPass ? (operation.view === 'each' ? views : 1) : 0,
      targets: written.length,
      bytes: written.reduce((sum, target) => sum + (targetBytes(target, program, BUDGETS[device].size) ?? 0), 0),
      draws: seen?.draws ?? 0,
      gpuMs: seen?.gpuMs ?? null,
    });
  }
  return costs;
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

/** Of all nodes together. */
export function totalOf(costs: Iterable<Cost>): Cost {
  let total = NO_COST;
  for (const cost of costs) total = sumOf(total, cost);
  return total;
}

/** Of a node of the open graph, with all that is in it where it stands for a subgraph; null where it costs nothing. */
export function costAt(costs: ReadonlyMap<string, Cost>, path: string): Cost | null {
  const inside = [...costs].filter(([node]) => node === path || node.startsWith(`${path}/`)).map(([, cost]) => cost);
  return inside.length === 0 ? null : totalOf(inside);
}

/** A line on a node. */
export function costWords({ passes, targets, bytes, draws, gpuMs }: Cost): string {
  const parts = [
    passes > 0 ? counted(passes, 'pass', 'passes') : '',
    draws > 0 && passes === 0 ? counted(draws, 'draw', 'draws') : '',
    targets > 0 ? megabytes(bytes) : '',
    gpuMs === null ? '' : `${gpuMs.toFixed(2)} ms`,
  ].filter(Boolean);
  return parts.length === 0 ? 'free' : parts.join(' · ');
}

/** What is over the budget, in words; nothing where all is well. */
export function overBudget(total: Cost, device: Device): readonly string[] {
  const budget = BUDGETS[device];
  const where = device === 'phone' ? 'a phone' : 'a headset';
  return [
    total.passes > budget.passes ? `${total.passes} passes: ${where} has time for about ${budget.passes} in each frame.` : '',
    total.bytes > budget.bytes ? `${megabytes(total.bytes)} of pictures: ${where} should need at most ${megabytes(budget.bytes)}.` : '',
    total.draws > budget.draws ? `${total.draws} draws: ${where} has time for about ${budget.draws} in each frame.` : '',
  ].filter(Boolean);
}

export function megabytes(bytes: number): string {
  const mb = bytes / 2 ** 20;
  return `${mb < 10 ? mb.toFixed(1) : Math.round(mb)} MB`;
}

function counted(count: number, one: string, many: string): string {
  return `${count} ${count === 1 ? one : many}`;
}
