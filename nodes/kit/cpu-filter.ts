import type { NodeDefinition } from './definition.ts';
import type { NodeContext, NodeModule } from './runtime.ts';

/**
 * The image that a CPU filter changes in place, in a worker (ADR 21). A filter is a folder `nodes/filter/cpu-NAME` with `definition.ts`
 * (lowering `cpu`) and `worker.ts`, which exports `process`.
 *
 * @example
 * export function process({ data }: Pixels, { amount }: CpuParams<typeof definition>): void {
 *   for (let i = 0; i < data.length; i += 4) data[i] = (data[i] ?? 0) * amount;
 * }
 */
export interface Pixels {
  /** The pixels of the image: premultiplied display-referred sRGB, RGBA8, rows from the bottom. */
  readonly data: Uint8Array<ArrayBuffer>;
  readonly widthPx: number;
  readonly heightPx: number;
}

/** The values of the params in the frame of the image, by name. */
export type CpuParams<D extends NodeDefinition> = {
  readonly [K in keyof NodeContext<D>['params']]: NodeContext<D>['params'][K] extends { readonly value: infer V } ? V : never;
} & NodeContext<D>['config'];

/** The bundled code of a node's worker, as text. `npm run gen` bundles it from `worker.ts`. */
export interface WorkerModule {
  readonly worker: string;
}

/** The module by which the player plays a node: a runtime in the page, which may have a worker, or only a worker. */
export type PlayedModule = (NodeModule & Partial<WorkerModule>) | WorkerModule;

/** The message to the worker; `buffer` is transferred. */
export interface CpuTask {
  readonly view: number;
  /** A number that the answer repeats, so that answers to tasks from before a reset can be dropped. */
  readonly turn: number;
  readonly buffer: ArrayBuffer;
  readonly widthPx: number;
  readonly heightPx: number;
  readonly params: Readonly<Record<string, unknown>>;
}

/** The message from the worker, with the buffer of the task transferred back. */
export interface CpuAnswer {
  readonly view: number;
  readonly turn: number;
  readonly buffer: ArrayBuffer;
  /** The message of the error that `process` threw, or null. */
  readonly failure: string | null;
}
