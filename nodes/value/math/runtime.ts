import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

type Operation = (a: number, b: number) => number;

/** The remainder of a division, computed with floor, so that the result has the sign of `b` and is continuous when `a` passes 0. */
const remainder: Operation = (a, b) => (b === 0 ? 0 : a - b * Math.floor(a / b));

const OPERATIONS = {
  add: (a, b) => a + b,
  subtract: (a, b) => a - b,
  multiply: (a, b) => a * b,
  divide: (a, b) => (b === 0 ? 0 : a / b),
  remainder,
  power: (a, b) => finiteOr0(a ** b),
  minimum: Math.min,
  maximum: Math.max,
  sine: (a, b) => Math.sin(a * b),
  cosine: (a, b) => Math.cos(a * b),
} satisfies Record<string, Operation>;

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const compute: Operation = OPERATIONS[ctx.config.operation];
  const { a, b } = ctx.params;
  return {
    update: () => {
      ctx.outputs.result.value = compute(a.value, b.value);
    },
    dispose: () => {},
  };
}

function finiteOr0(x: number): number {
  return Number.isFinite(x) ? x : 0;
}
