import type { Clock } from './runtime.ts';
import type { NumberView, ToggleView, VectorView, Writable } from './value-views.ts';

/**
 * The context of the runtimes in `nodes/binding/`, which play params that are bound to an expression or a track. They are not nodes:
 * the compiler creates their operations and writes `config`.
 */
export interface BindingContext {
  /** The outputs of the operation; its only output, `value`, is the value of the bound param. */
  readonly outputs: Readonly<Record<string, unknown>>;
  readonly config: Readonly<Record<string, unknown>>;
  readonly clock: Pick<Clock, 'timeS' | 'frame'>;
}

/** The value of a bound param: one or more numbers, for every type of param. */
export type BoundValue = Writable<NumberView> | Writable<ToggleView> | Writable<VectorView>;

/**
 * Creates the function that copies computed numbers to a param.
 *
 * The type of the value is decided once, not every frame: a generic assignment would allocate a heap number per frame.
 *
 * @param bound The value of the param.
 * @param numbers As many numbers as the value has; read at every call of the result. A toggle is on where the number is not 0.
 * @returns Writes the numbers to the value; allocates nothing.
 *
 * @example
 * const write = createWriter(value, expression.results);
 * // Every frame, after `numbers` has changed:
 * write();
 */
export function createWriter(bound: BoundValue, numbers: Float64Array): () => void {
  switch (typeof bound.value) {
    case 'object': {
      const vector = bound as Writable<VectorView>;
      return () => {
        vector.value = numbers;
      };
    }
    case 'boolean': {
      const toggle = bound as Writable<ToggleView>;
      return () => {
        toggle.value = numbers[0] !== 0;
      };
    }
    default: {
      const number = bound as Writable<NumberView>;
      return () => {
        number.value = numbers[0] ?? 0;
      };
    }
  }
}
