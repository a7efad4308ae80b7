import type { Clock } from './runtime.ts';
import type { NumberView, ToggleView, VectorView, Writable } from './value-views.ts';

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

/**
 * What carries the numbers to the param, as many as its value has. One function per type, decided beforehand: were it decided in
 * every frame, an engine would make a heap object of each number to look at.
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
