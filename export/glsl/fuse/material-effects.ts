import type { TargetFormat } from '../../program/program.ts';
import { createLineWriter } from '../link/line-writer.ts';
import { composePasses, DRAWN_COLOR, ROUNDING, ROUNDING_TEXT } from './fuse-passes.ts';
import type { FusedPart } from './fused-part.ts';
import { MOVED_POSITION, mainName } from './moved-layers.ts';

/**
 * Composes the text for the fragment shaders of materials that compute passes over the layer of their objects. It defines
 * `vec4 scrimEffects(vec4 color)`: from the color that a material would write to that layer, whose alpha is 1, to the color that the last
 * pass would write. Between them, colors are rounded as in fused passes.
 *
 * @param passes In drawing order. All images that they read are the layer (`drawn`) or layers of earlier passes, at the current pixel.
 * @param format Format of the layer of the objects.
 *
 * @example
 * const text = materialEffects([{ ...sepia, drawn: new Set(['a_inputImage']) }], 'rgba8');
 */
export function materialEffects(passes: readonly FusedPart[], format: TargetFormat): string {
  const rounding = ROUNDING[format];
  // A material has no position in an image; reads of the layer ignore it.
  const { declarations, printPasses } = composePasses(passes, new Map(), new Set(passes.keys()));
  const isDefined = rounding === null || declarations.includes(ROUNDING_TEXT[rounding]);
  const writer = createLineWriter(0);
  const given = [`vec4 ${DRAWN_COLOR};`, 'vec4 scrim_output;', ...(isDefined ? [] : [ROUNDING_TEXT[rounding]])];
  writer.own([...given, ...declarations].join('\n'));
  printPasses(writer);
  const calls = passes.map((_, i) => `  ${mainName(i)}();`);
  const drawn = rounding === null ? 'color' : `${rounding}(color)`;
  const start = [`  ${DRAWN_COLOR} = ${drawn};`, `  ${MOVED_POSITION} = vec2(0.5);`];
  writer.own(['vec4 scrimEffects(vec4 color) {', ...start, ...calls, '  return scrim_output;', '}'].join('\n'));
  return `${writer.lines.join('\n')}\n`;
}
