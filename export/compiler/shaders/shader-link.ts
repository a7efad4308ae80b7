import type { Result } from '../../../nodes/kit/diagnostics.ts';
import type { Before } from '../../glsl/link/link-above.ts';
import type { LinkedShader } from '../../program/program.ts';

/** A linked file, or its diagnostics. */
export interface ShaderLink<T> extends Result<T> {
  /** The text above the mistake that prevents linking, for a driver to compile; null if the file was linked or there is no such text. */
  readonly above: { readonly shaders: readonly LinkedShader[]; readonly before: Before } | null;
}
