import { findInput, type IsfShader } from '../isf/isf-shader.ts';
import { MAX_TEXT, TOO_LONG } from '../syntax/parse.ts';
import { GlslError, type Place } from '../syntax/token.ts';
import type { LinkedPass, LinkedSampler } from './linked-pass.ts';

/** `MAX_TEXTURE_IMAGE_UNITS` that every WebGL 2 device supports (§3.7.2). */
const MAX_IMAGES = 16;

/**
 * Rejects shaders that exceed guaranteed limits of WebGL 2.
 *
 * @throws GlslError, at the line of the header if that is the cause.
 */
export function checkLimits(shader: IsfShader, pass: LinkedPass): void {
  const { samplers, passIndex } = pass;
  const [beyond] = samplers.slice(MAX_IMAGES);
  if (beyond !== undefined) {
    const what = shader.passes.length > 1 ? `Pass ${passIndex}` : 'The shader';
    throw new GlslError(
      placeOf(shader, beyond),
      `${what} reads ${samplers.length} images, but WebGL 2 guarantees only ${MAX_IMAGES}. Read fewer in one pass.`,
      'SCR043',
    );
  }
  if (pass.shader.fragment.length > MAX_TEXT) throw new GlslError({ line: 1, column: 1 }, TOO_LONG, 'SCR043');
}

function placeOf(shader: IsfShader, { source }: LinkedSampler): Place {
  const input = 'input' in source ? source.input : 'param' in source ? source.param : null;
  if (input !== null) return findInput(shader, input) ?? { line: 1, column: 1 };
  return (source.kind === 'import' && shader.imported.find(({ name }) => name === source.import)) || { line: 1, column: 1 };
}
