import type { PassParts, WhyNotFused } from '../../glsl/link/link-parts.ts';
import type {
  CpuOperation,
  DrawEffects,
  DrawOperation,
  LinkedShader,
  NodeOperation,
  PassOperation,
  ReadbackOperation,
  ShadowMapOperation,
} from '../../program/program.ts';
import type { ShaderLink } from '../shaders/shader-link.ts';

/** A pass that contains its shader; *link* replaces it by an index. */
export type ScheduledPass = Omit<PassOperation, 'shader'> & {
  readonly shader: LinkedShader;
  /** Parts of the shader for fusion (`schedule/fuse`), or why there are none. */
  readonly parts: PassParts | WhyNotFused;
};

/** A draw whose effects contain the shader that tests them; *link* replaces it by an index. */
export type ScheduledDraw = Omit<DrawOperation, 'effects'> & { readonly effects?: ScheduledEffects };

export type ScheduledEffects = Omit<DrawEffects, 'trial'> & { readonly trial: LinkedShader };

export type ScheduledOperation = NodeOperation | ScheduledDraw | CpuOperation | ShadowMapOperation | ReadbackOperation | ScheduledPass;

/** A shader that tests a technique, and the node of the technique. */
export interface ScheduledTrial {
  readonly shader: LinkedShader;
  readonly node: string;
}

/** Shaders made of the text above a mistake, and the node of the shader. */
export interface ScheduledAbove extends NonNullable<ShaderLink<unknown>['above']> {
  readonly node: string;
}

/** An operation and the ids of the operations that must run before it. */
export interface Step {
  readonly operation: ScheduledOperation;
  readonly after: readonly string[];
}

export function isPass(operation: ScheduledOperation): operation is ScheduledPass {
  return operation.kind === 'pass';
}

export function isDrawOperation(operation: ScheduledOperation): operation is ScheduledDraw {
  return operation.kind === 'draw';
}
