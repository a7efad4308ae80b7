import type { ToolContext } from '../lib/tool.ts';

/**
 * A measured quantity. Each file `tools/bench/NAME.bench.ts` exports `benches(context): Promise<Bench[]>`; there is no registration.
 */
export interface Bench {
  /** Stable name, by which results are compared. Contains the subject and the size: `compile, 100 nodes`. */
  readonly name: string;
  readonly unit: 'ms' | 'kB' | 'count' | 'ratio';
  /** Takes one sample. */
  sample(): number | Promise<number>;
  /** Number of samples after a discarded warm-up. 1, without warm-up, for constant quantities. Default: 15. */
  readonly samples?: number;
  /** Details that do not fit into a row. Printed below the table. */
  notes?(): string | Promise<string>;
  /** Disposes resources that the samples share. */
  dispose?(): void | Promise<void>;
}

/** The module type of each `*.bench.ts`. */
export interface BenchFile {
  benches(context: ToolContext): Promise<readonly Bench[]>;
}

export interface Measured {
  readonly name: string;
  readonly unit: Bench['unit'];
  readonly median: number;
  readonly p95: number;
  readonly notes?: string;
}

export async function measure(bench: Bench): Promise<Measured> {
  const count = bench.samples ?? 15;
  try {
    if (count > 1) await bench.sample();
    const samples: number[] = [];
    for (let i = 0; i < count; i++) samples.push(await bench.sample());
    samples.sort((a, b) => a - b);
    const notes = await bench.notes?.();
    return {
      name: bench.name,
      unit: bench.unit,
      median: quantile(samples, 0.5),
      p95: quantile(samples, 0.95),
      ...(notes !== undefined && { notes }),
    };
  } finally {
    await bench.dispose?.();
  }
}

/** Duration of `work` in milliseconds. */
export async function timeMs(work: () => unknown): Promise<number> {
  const startMs = performance.now();
  await work();
  return performance.now() - startMs;
}

/** The sample at the quantile `q` of sorted samples, without interpolation, so that each figure was measured. */
export function quantile(sorted: readonly number[], q: number): number {
  return sorted[Math.min(sorted.length - 1, Math.floor(q * sorted.length))] ?? Number.NaN;
}
