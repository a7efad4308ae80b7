import { helpersFor, IMAGE_SUFFIXES, type Image, type ImageUse } from '../link/images.ts';
import type { Names } from '../link/names.ts';
import type { Reach } from '../link/reach.ts';
import { GlslError } from '../syntax/token.ts';
import type { TechniqueShader } from './technique-shader.ts';

/** The layers that a technique may read, by the author's name; those in `absent` are unconnected and transparent. */
export function techniqueImages(
  { inputs, imported }: TechniqueShader,
  absent: ReadonlySet<string>,
  names: Names,
): ReadonlyMap<string, Image> {
  const images = new Map<string, Image>();
  for (const { name, type } of inputs) {
    if (type !== 'image') continue;
    const sampler = names.fresh(name, IMAGE_SUFFIXES);
    images.set(name, {
      name,
      kind: absent.has(name) ? 'absent' : 'input',
      isCube: false,
      isRoom: false,
      buffer: '',
      sampler,
      hasDepth: false,
      repeat: false,
      sound: null,
    });
  }
  // Read as stored, as buffers of filters are.
  for (const { name, path } of imported) {
    images.set(name, {
      name,
      kind: 'buffer',
      isCube: false,
      isRoom: false,
      buffer: path,
      sampler: names.fresh(name, IMAGE_SUFFIXES),
      hasDepth: false,
      repeat: true,
      sound: null,
    });
  }
  return images;
}

/** Declarations and functions of the images that a stage reads. Colors are linear with straight alpha. */
export function techniqueImageText({ images }: Reach): string[] {
  const texts = [...images].map(([image, uses]) => imageText(image, uses));
  if (texts.length === 0) return [];
  const all = texts.join('\n');
  return [...(all.includes('scrim_linear(') ? [LINEAR] : []), ...helpersFor(all, false), all];
}

function imageText({ name, kind, sampler }: Image, uses: ReadonlySet<ImageUse>): string {
  if (uses.has('depth')) {
    throw new GlslError({ line: 1, column: 1 }, `Techniques read the colors of “${name}”, not its depth.`, 'SCR043');
  }
  const size = uses.has('size') ? [kind === 'absent' ? `const vec2 ${sampler}_size = vec2(1.0);` : `uniform vec2 ${sampler}_size;`] : [];
  if (kind === 'buffer')
    return [...size, `uniform sampler2D ${sampler};\nvec4 ${sampler}_at(vec2 uv) { return texture(${sampler}, uv); }`].join('\n');
  if (kind === 'absent') return [...size, `vec4 ${sampler}_at(vec2 uv) { return vec4(0.0); }`].join('\n');
  const color = `uniform sampler2D ${sampler};
uniform mat3 ${sampler}_uvFromViewUv;
vec4 ${sampler}_at(vec2 uv) {
  vec2 at = scrim_place(${sampler}_uvFromViewUv, uv);
  return scrim_inside(at) ? scrim_linear(scrim_straight(textureLod(${sampler}, at, 0.0))) : vec4(0.0);
}`;
  return [...size, color].join('\n');
}

/**
 * GLSL function that converts a color from sRGB to linear light (IEC 61966-2-1): layers are display-referred, and techniques shade in
 * linear light.
 */
const LINEAR = `vec4 scrim_linear(vec4 color) {
  vec3 low = color.rgb / 12.92;
  vec3 high = pow((max(color.rgb, 0.0) + 0.055) / 1.055, vec3(2.4));
  return vec4(mix(high, low, lessThanEqual(color.rgb, vec3(0.04045))), color.a);
}`;
