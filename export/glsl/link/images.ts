import { ROOM_DEPTH_TEXT } from '../../../nodes/kit/room-depth-glsl.ts';
import type { TableType } from '../../../nodes/kit/wire-types.ts';
import { TABLE_WIDTH_PX } from '../../program/texture-sizes.ts';
import type { IsfShader } from '../isf/isf-shader.ts';
import type { LinkedSampler, LinkedSound } from './linked-pass.ts';
import { FINITE_TEXT } from './prelude.ts';

/** An image that a pass may read. */
export interface Image {
  readonly name: string;
  readonly kind: 'input' | 'room' | 'buffer' | 'sound' | 'picture' | 'cube' | TableType | 'absent';
  /** Whether the image is a cube, which is read by a direction. Also true if its input is not connected. */
  readonly isCube: boolean;
  /** Whether the image is room depth. Also true if its input is not connected. */
  readonly isRoom: boolean;
  /** For buffers: the version in this pass, see `plan-passes.ts`. */
  readonly buffer: string;
  /** Name of its sampler in the printed text. */
  readonly sampler: string;
  /** Whether the layer of an input has depth. */
  readonly hasDepth: boolean;
  /** Whether it repeats beyond its edges. */
  readonly repeat: boolean;
  /** How a sound is analyzed, also if its input is not connected; null for other images. */
  readonly sound: LinkedSound | null;
}

/** What a shader reads of an image. */
export type ImageUse = 'color' | 'size' | 'depth' | TableType;

/** Suffixes that the functions below add to the name of a sampler. */
export const IMAGE_SUFFIXES = [
  '_at',
  '_size',
  '_uvFromViewUv',
  '_interpolate',
  '_depthAt',
  '_depth',
  '_depth_uvFromViewUv',
  '_depth_decode',
  '_depth_size',
  '_valueAt',
] as const;

/** The function that reads the color of an image in the printed text. */
export function colorFunction(image: Image): string {
  return `${image.sampler}_at`;
}

export function depthFunction(image: Image): string {
  return `${image.sampler}_depthAt`;
}

/** The function that reads a curve or a gradient in the printed text. */
export function tableFunction(image: Image): string {
  return `${image.sampler}_valueAt`;
}

export function sizeUniform(image: Image): string {
  return `${image.sampler}_size`;
}

/** The sampler that a use of the image needs. */
export function samplerFor(image: Image, use: ImageUse): LinkedSampler | null {
  if (image.kind === 'absent') return null;
  if (isTable(image)) return { name: image.sampler, source: { kind: 'table', of: image.kind, param: image.name } };
  if (use === 'depth') {
    if (image.kind === 'room') return { name: image.sampler, source: { kind: 'room-depth', input: image.name } };
    if (image.kind === 'input' && image.hasDepth)
      return { name: `${image.sampler}_depth`, source: { kind: 'input-depth', input: image.name } };
    return null;
  }
  if (image.kind === 'buffer') return { name: image.sampler, source: { kind: 'buffer', target: image.buffer } };
  if (image.sound !== null) return { name: image.sampler, source: { kind: 'sound', input: image.name, ...image.sound } };
  if (image.kind === 'picture' || image.kind === 'cube') return { name: image.sampler, source: { kind: 'import', import: image.name } };
  return { name: image.sampler, source: { kind: 'input', input: image.name } };
}

/**
 * GLSL declarations and read functions of one image. A layer is read at a position on the view, from (0, 0) at the bottom left to (1, 1);
 * positions beyond the view are clamped to its edge, or wrapped if the image repeats. Where the layer does not cover the view, the color is
 * transparent and the depth 0. A cube takes a direction, a curve or a gradient one number. The mip level is explicit and there are no derivatives, so
 * reads are allowed in any control flow.
 *
 * @param uses Which functions the shader calls; only these are declared.
 * @param reading How colors are returned: `premultiplied`: as stored; otherwise alpha is divided out, except in buffers. `readsScene`:
 * colors of layers are unclamped and finite.
 * @param isAligned Whether the texture of a layer is a target that covers the view, so that positions on both are equal.
 */
export function imageText(image: Image, uses: ReadonlySet<ImageUse>, reading: Reading, isAligned = false): string {
  const parts: string[] = [];
  if (image.kind === 'absent') {
    if (uses.has('size')) parts.push(`const vec2 ${sizeUniform(image)} = vec2(1.0);`);
    const nothing = image.sound?.analysis === 'waveform' ? 'vec4(0.5, 0.5, 0.5, 1.0)' : 'vec4(0.0)';
    if (uses.has('color')) parts.push(`vec4 ${colorFunction(image)}(${image.isCube ? 'vec3' : 'vec2'} uv) { return ${nothing}; }`);
    if (uses.has('depth')) parts.push(`float ${depthFunction(image)}(vec2 uv) { return 0.0; }`);
    return parts.join('\n');
  }
  if (isTable(image)) return tableText(image);
  const type = image.kind === 'cube' ? 'samplerCube' : 'sampler2D';
  if (uses.has('color') || uses.has('size')) parts.push(`uniform ${type} ${image.sampler};`);
  if (uses.has('size')) parts.push(`uniform vec2 ${sizeUniform(image)};`);
  if (uses.has('color')) parts.push(colorText(image, reading, isAligned));
  if (uses.has('depth')) parts.push(depthText(image));
  return parts.join('\n');
}

/** How a file reads colors. */
export type Reading = Pick<IsfShader, 'premultiplied' | 'readsScene'>;

function colorText(image: Image, reading: Reading, isAligned: boolean): string {
  const { premultiplied } = reading;
  const read = `textureLod(${image.sampler}, uv, 0.0)`;
  switch (image.kind) {
    case 'buffer':
      // A node's own buffer is read as written.
      return `vec4 ${colorFunction(image)}(vec2 uv) { return ${read}; }`;
    case 'sound':
      return `vec4 ${colorFunction(image)}(vec2 uv) { return vec4(${read}.rrr, 1.0); }`;
    case 'picture':
      return `vec4 ${colorFunction(image)}(vec2 uv) { return ${premultiplied ? read : `scrim_straight(${read})`}; }`;
    case 'cube':
      return `vec4 ${colorFunction(image)}(vec3 uv) { return ${premultiplied ? read : `scrim_straight(${read})`}; }`;
    default:
      return inputColor(image, reading, isAligned);
  }
}

/**
 * Prints the function that reads the color of a layer: fitted to the view, transparent outside of the layer, with straight alpha unless the
 * file reads it as stored.
 */
function inputColor(image: Image, { premultiplied, readsScene }: Reading, isAligned: boolean): string {
  const { sampler } = image;
  if (isAligned) {
    const texel = `textureLod(${sampler}, ${image.repeat ? 'fract(uv)' : 'clamp(uv, 0.0, 1.0)'}, 0.0)`;
    const color = readsScene ? `scrim_finite(${texel})` : texel;
    return `vec4 ${colorFunction(image)}(vec2 uv) { return ${premultiplied ? color : `scrim_straight(${color})`}; }`;
  }
  const read = `textureLod(${sampler}, at, 0.0)`;
  return `uniform mat3 ${sampler}_uvFromViewUv;
vec4 ${colorFunction(image)}(vec2 uv) {
  vec2 at = scrim_place(${sampler}_uvFromViewUv, ${image.repeat ? 'fract(uv)' : 'uv'});
  vec4 color = scrim_inside(at) ? ${readsScene ? `scrim_finite(${read})` : read} : vec4(0.0);
  return ${premultiplied ? 'color' : 'scrim_straight(color)'};
}`;
}

function isTable(image: Image): image is Image & { readonly kind: TableType } {
  return image.kind === 'curve' || image.kind === 'gradient';
}

/**
 * Prints the function that reads a curve or a gradient from its texture. The values are at the centers of texels, the first for x = 0 and
 * the last for x = 1; beyond, they are constant.
 */
function tableText(image: Image & { readonly kind: TableType }): string {
  const at = `vec2((clamp(x, 0.0, 1.0) * ${TABLE_WIDTH_PX - 1}.0 + 0.5) / ${TABLE_WIDTH_PX}.0, 0.5)`;
  const read = `textureLod(${image.sampler}, ${at}, 0.0)`;
  return `uniform sampler2D ${image.sampler};
${image.kind === 'curve' ? 'float' : 'vec4'} ${tableFunction(image)}(float x) {
  return ${image.kind === 'curve' ? `${read}.r` : `scrim_straight(${read})`};
}`;
}

function depthText(image: Image): string {
  if (image.kind === 'room') {
    const { sampler } = image;
    return `uniform sampler2D ${sampler};
uniform mat3 ${sampler}_uvFromViewUv;
uniform bool ${sampler}_interpolate;
float ${depthFunction(image)}(vec2 uv) {
  vec2 at = scrim_place(${sampler}_uvFromViewUv, uv);
  return scrim_inside(at) ? scrim_roomM(${sampler}, ${sampler}_interpolate, at) : 0.0;
}`;
  }
  if (!image.hasDepth) return `float ${depthFunction(image)}(vec2 uv) { return 0.0; }`;
  const sampler = `${image.sampler}_depth`;
  return `uniform sampler2D ${sampler};
uniform mat3 ${sampler}_uvFromViewUv;
uniform vec4 ${sampler}_decode;
float ${depthFunction(image)}(vec2 uv) {
  vec2 at = scrim_place(${sampler}_uvFromViewUv, uv);
  return scrim_inside(at) ? scrim_meters(${sampler}_decode, textureLod(${sampler}, at, 0.0).r) : 0.0;
}`;
}

/**
 * GLSL functions that the read functions of all images of a text share.
 *
 * `scrim_meters` decodes the red channel `d` of a depth sampler with its `NAME_decode`:
 * - meters: `decode = (scale, offset, 0, 0)`, usually (1, 0, 0, 0); m = d scale + offset;
 * - a depth buffer drawn with the projection `P` (column-major): `decode = (P[10], P[14], 0, 1)`. Clip z = P10 z + P14 and clip w = -z, so
 *   with m = -z meters 2 d - 1 = P14 / m - P10, and m = P14 / (2 d - 1 + P10); this holds for off-axis and infinite projections too. A d of
 *   1 means that nothing was drawn and gives 0.
 */
const IMAGE_HELPERS = {
  scrim_place: `vec2 scrim_place(mat3 uvFromViewUv, vec2 uv) {
  vec3 at = uvFromViewUv * vec3(clamp(uv, 0.0, 1.0), 1.0);
  return at.xy / at.z;
}`,
  scrim_inside: `bool scrim_inside(vec2 at) {
  return all(lessThanEqual(abs(at - 0.5), vec2(0.50001)));
}`,
  scrim_finite: FINITE_TEXT,
  scrim_straight: `vec4 scrim_straight(vec4 color) {
  return color.a > 0.0 ? vec4(color.rgb / color.a, color.a) : vec4(0.0);
}`,
  scrim_meters: `float scrim_meters(vec4 decode, float d) {
  if (decode.w == 0.0) return d * decode.x + decode.y;
  return d < 1.0 ? decode.y / (2.0 * d - 1.0 + decode.x) : 0.0;
}`,
  scrim_roomM: ROOM_DEPTH_TEXT,
  scrim_project: `vec2 scrim_project(vec3 at) { return at.xy / at.z; }
vec2 scrim_project(vec4 at) { return at.xy / at.w; }`,
} as const;

/** The helpers that the images' text calls, ordered by dependency. */
export function helpersFor(imageTexts: string, projects: boolean): string[] {
  return Object.entries(IMAGE_HELPERS)
    .filter(([name]) => imageTexts.includes(`${name}(`) || (projects && name === 'scrim_project'))
    .map(([, helper]) => helper);
}
