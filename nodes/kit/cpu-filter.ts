import type { NodeDefinition } from './definition.ts';
import type { NodeContext, NodeModule } from './runtime.ts';

/**
 * Between a CPU filter, which works in a worker, and the runtime that carries pictures there and back (ADR 21). A filter is a folder
 * `nodes/filter/cpu-NAME` with `definition.ts` (lowering `cpu`) and `worker.ts`, which exports `process`.
 *
 * @example
 * export function process({ data }: Pixels, { amount }: CpuParams<typeof definition>): void {
 *   for (let i = 0; i < data.length; i += 4) data[i] = (data[i] ?? 0) * amount;
 * }
 */
export interface Pixels {
  /** Premultiplied display-referred sRGB, RGBA, rows from the bottom: to be changed in place. */
  readonly data: Uint8Array<ArrayBuffer>;
  readonly widthPx: number;
  readonly heightPx: number;
}

/** Values of the frame in which the picture was taken, by the names of the params. */
export type CpuParams<D extends NodeDefinition> = {
  readonly [K in keyof NodeContext<D>['params']]: NodeContext<D>['params'][K] extends { readonly value: infer V } ? V : never;
} & NodeContext<D>['config'];

/** The text of a worker, as `npm run gen` makes it of `worker.ts`. */
export interface WorkerModule {
  readonly worker: string;
}

/** What plays a node: its behavior in the page, or in a worker. */
export type PlayedModule = NodeModule | WorkerModule;

/** To the worker; `buffer` is transferred. */
export interface CpuTask {
  readonly view: number;
  /** Given back with the answer, so that one from before a reset is known. */
  readonly turn: number;
  readonly buffer: ArrayBuffer;
  readonly widthPx: number;
  readonly heightPx: number;
  readonly params: Readonly<Record<string, unknown>>;
}

/** From the worker; the same buffer, transferred back. */
export interface CpuAnswer {
  readonly view: number;
  readonly turn: number;
  readonly buffer: ArrayBuffer;
  /** What went wrong, as the message of the error that was thrown, or null. */
  readonly failure: string | null;
}
