import { COEFFICIENTS, type Splats } from '../splats/splats.ts';

/** Real spherical harmonics above degree 0, in the order and with the signs of Kerbl et al. 2023; `d` is the direction from the eye. */
const BASIS = [
  '-0.4886025119 * d.y',
  '0.4886025119 * d.z',
  '-0.4886025119 * d.x',
  '1.0925484306 * d.x * d.y',
  '-1.0925484306 * d.y * d.z',
  '0.3153915653 * (2.0 * s.z - s.x - s.y)',
  '-1.0925484306 * d.x * d.z',
  '0.5462742153 * (s.x - s.y)',
  '-0.5900435899 * d.y * (3.0 * s.x - s.y)',
  '2.8906114426 * d.x * d.y * d.z',
  '-0.4570457995 * d.y * (4.0 * s.z - s.x - s.y)',
  '0.3731763326 * d.z * (2.0 * s.z - 3.0 * s.x - 3.0 * s.y)',
  '-0.4570457995 * d.x * (4.0 * s.z - s.x - s.y)',
  '1.4453057213 * d.z * (s.x - s.y)',
  '-0.5900435899 * d.x * (s.x - 3.0 * s.y)',
];

/**
 * GLSL ES 3.00 function that adds up the harmonics of a splat: `vec3 harmonicsAt(ivec2 texel, vec3 direction)`. The coefficients are bytes,
 * of which 128 is 0.
 *
 * @example
 * const text = harmonicsGlsl(2);
 */
export function harmonicsGlsl(degree: Splats['degree']): string {
  const terms = BASIS.slice(0, COEFFICIENTS[degree]).map((basis, i) => {
    const bytes = [0, 1, 2].map((channel) => byteAt(3 * i + channel));
    return `  sum += ranges[${bandOf(i)}] * (${basis}) * (vec3(${bytes.join(', ')}) - 128.0);`;
  });
  const texels = Array.from({ length: degree }, (_, i) => `  uvec4 t${i} = texelFetch(harmonics, texel + ivec2(${i}, 0), 0);`);
  return /* glsl */ `uniform usampler2D harmonics;
uniform vec3 ranges;
vec3 harmonicsAt(ivec2 texel, vec3 d) {
  vec3 s = d * d;
  vec3 sum = vec3(0.0);
${[...texels, ...terms].join('\n')}
  return sum / 127.0;
}`;
}

function byteAt(index: number): string {
  const word = Math.floor(index / 4);
  return `(t${Math.floor(word / 4)}.${'xyzw'[word % 4]} >> ${8 * (index % 4)}) & 255u`;
}

function bandOf(coefficient: number): number {
  return [3, 8, 15].findIndex((end) => coefficient < end);
}
