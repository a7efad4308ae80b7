import type { ToolContext } from '../lib/tool.ts';

/**
 * One quantity worth remembering from release to release. A file `tools/bench/NAME.bench.ts` exports
 * `benches(context): Promise<readonly Bench[]>`; there is nothing to register.
 */
export interface Bench {
  /** Stable: results are compared by it. Names what is measured and at which size: `compile, 100 nodes`. */
  readonly name: string;
  readonly unit: 'ms' | 'kB' | 'count' | 'ratio';
  /** Takes one sample. */
  sample(): number | Promise<number>;
  /** How many samples to take after one that is thrown away; 1, without warming up, for what never varies. Default 15. */
  readonly samples?: number;
  /** Details that do not fit into a row; printed below the table. */
  notes?(): string | Promise<string>;
  /** Disposes what the samples share. */
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

/** How long `work` takes, in milliseconds. */
export async function timeMs(work: () => unknown): Promise<number> {
  const startMs = performance.now();
  await work();
  return performance.now() - startMs;
}

/** The nearest of the sorted samples, so that each figure is a measured one. */
export function quantile(sorted: readonly number[], q: number): number {
  return sorted[Math.min(sorted.length - 1, Math.floor(q * sorted.length))] ?? Number.NaN;
}
