import { cpus, loadavg } from 'node:os';
import type { Bench } from './bench.ts';

/** A row with the load of the machine per core in the last minute, by which a reader judges the rows before it: above 1, others worked, too. */
export function machineLoad(during: string): Bench {
  return { name: `load of the machine per core, ${during}`, unit: 'ratio', samples: 1, sample: () => (loadavg()[0] ?? 0) / cpus().length };
}
