import type { TableType } from '../../../nodes/kit/wire-types.ts';
import { TEXTURE_FUNCTIONS } from '../check/builtin-functions.ts';
import { isImageFunction } from '../check/check-call.ts';
import type { CallExpression } from '../syntax/ast.ts';
import { GlslError } from '../syntax/token.ts';
import type { ImageUse } from './images.ts';

/**
 * What a call reads of an image. A size with `isStored` is that of its texture, which may differ from the size of the view. The argument `position`: `here` is the current pixel; `norm` is (0, 0) to (1, 1), or a direction for
 * cubes; `pixel` is in pixels; `direction` is for cubes only; the others are the positions of GLSL's own texture functions.
 */
export type ImageCall =
  | { readonly use: 'color'; readonly position: 'here' | 'norm' | 'pixel' | 'projected' | 'texel' | 'offset' | 'direction' }
  | { readonly use: 'size'; readonly whole: boolean; readonly isStored?: true }
  | { readonly use: 'depth'; readonly room: boolean }
  | { readonly use: TableType };

/** Whether a read is one of a table, which is the same for all pixels. */
export function isTableRead(read: ImageCall): read is Extract<ImageCall, { use: TableType }> {
  return read.use === 'curve' || read.use === 'gradient';
}

const NORM = /^texture(2D)?(Lod|LodEXT|Grad|GradEXT)?$/;
const CUBE = /^textureCube(Lod|LodEXT|GradEXT)?$/;
const PROJECTED = /^texture(2D)?Proj(Lod|LodEXT|Grad|GradEXT)?$/;

/**
 * How a call reads an image; null if it reads none.
 *
 * @throws GlslError for reads that layers do not support.
 */
export function classifyImageCall(call: CallExpression): ImageCall | null {
  const name = call.token.text;
  if (call.symbol !== null || !(isImageFunction(name) || TEXTURE_FUNCTIONS.has(name))) return null;
  switch (name) {
    case 'IMG_THIS_PIXEL':
    case 'IMG_THIS_NORM_PIXEL':
    case 'IMG_NORM_THIS_PIXEL':
      return { use: 'color', position: 'here' };
    case 'IMG_NORM_PIXEL':
      return { use: 'color', position: 'norm' };
    case 'IMG_PIXEL':
    case 'texture2DRect':
      return { use: 'color', position: 'pixel' };
    case 'IMG_SIZE':
      return { use: 'size', whole: false };
    case 'IMG_SAMPLES':
      return { use: 'size', whole: false, isStored: true };
    case 'textureSize':
      return { use: 'size', whole: true };
    case 'LAYER_DEPTH':
      return { use: 'depth', room: false };
    case 'ROOM_DEPTH':
      return { use: 'depth', room: true };
    case 'CURVE':
      return { use: 'curve' };
    case 'GRADIENT':
      return { use: 'gradient' };
    case 'texelFetch':
      return { use: 'color', position: 'texel' };
    case 'textureOffset':
    case 'textureLodOffset':
      return { use: 'color', position: 'offset' };
    default:
      if (NORM.test(name)) return { use: 'color', position: 'norm' };
      if (PROJECTED.test(name)) return { use: 'color', position: 'projected' };
      if (CUBE.test(name)) return { use: 'color', position: 'direction' };
      throw new GlslError(call.token, `"${name}" cannot be used on a layer: read it with IMG_NORM_PIXEL or IMG_PIXEL.`, 'SCR043');
  }
}

/** The data that a call needs of its image: reading the color at a position in pixels also needs the size. */
export function usesOf(call: ImageCall): readonly ImageUse[] {
  if (call.use === 'size' && call.isStored) return ['color', 'size'];
  if (call.use !== 'color') return [call.use];
  return call.position === 'pixel' || call.position === 'texel' || call.position === 'offset' ? ['color', 'size'] : ['color'];
}

/** Number of arguments after the image. */
export function positionCount(call: ImageCall): number {
  if (call.use === 'size') return 0;
  if (call.use !== 'color') return 1;
  return call.position === 'here' ? 0 : 1;
}
