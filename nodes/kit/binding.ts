import type { Clock, NumberView, ToggleView, VectorView, Writable } from './runtime.ts';

/**
 * What the runtimes in `nodes/binding/` see: they play params that are bound to an expression or a track, and are no nodes that a
 * designer places. The compiler makes their operations and knows what is in `config`.
 */
export interface BindingContext {
  /** `value` is the param's own. */
  readonly outputs: Readonly<Record<string, unknown>>;
  readonly config: Readonly<Record<string, unknown>>;
  readonly clock: Pick<Clock, 'timeS' | 'frame'>;
}

/** Whatever type a param has, its value is made of numbers. */
export type BoundValue = Writable<NumberView> | Writable<ToggleView> | Writable<VectorView>;

/** Writes as many of the numbers as the value has. */
export function writeNumbers(bound: BoundValue, numbers: Float64Array): void {
  if (typeof bound.value === 'object') bound.value = numbers;
  else if (typeof bound.value === 'boolean') bound.value = numbers[0] !== 0;
  else bound.value = numbers[0] ?? 0;
}
