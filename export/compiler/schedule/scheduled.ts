import type { CpuOperation, DrawOperation, LinkedShader, NodeOperation, PassOperation, ShadowMapOperation } from '../../program/program.ts';
import type { ShaderLink } from '../shaders/shader-link.ts';

/** A pass that holds its shader itself; *link* puts an index in its place. */
export type ScheduledPass = Omit<PassOperation, 'shader'> & { readonly shader: LinkedShader };

export type ScheduledOperation = NodeOperation | DrawOperation | CpuOperation | ShadowMapOperation | ScheduledPass;

/** A shader to try a technique with, and the technique's node. */
export interface ScheduledTrial {
  readonly shader: LinkedShader;
  readonly node: string;
}

/** Shaders of what stands above a mistake in the file of a node. */
export interface ScheduledAbove extends NonNullable<ShaderLink<unknown>['above']> {
  readonly node: string;
}

/** An operation and what has to run before it, as ids of operations. */
export interface Step {
  readonly operation: ScheduledOperation;
  readonly after: readonly string[];
}

export function isPass(operation: ScheduledOperation): operation is ScheduledPass {
  return operation.kind === 'pass';
}

export function isDrawOperation(operation: ScheduledOperation): operation is DrawOperation {
  return operation.kind === 'draw';
}
