import type { Result } from '../../../nodes/kit/diagnostics.ts';
import type { Before } from '../../glsl/link/link-above.ts';
import type { LinkedShader } from '../../program/program.ts';

/** A linked file, or what is wrong with it. */
export interface ShaderLink<T> extends Result<T> {
  /** What stands above the mistake that the file was refused for, for a driver; null where it was not, or where there is nothing above. */
  readonly above: { readonly shaders: readonly LinkedShader[]; readonly before: Before } | null;
}
