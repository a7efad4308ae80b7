import { ShaderChunk } from 'three';
import type { ShaderPatch } from './shader-patch.ts';

const INCLUDE = '#include <shadowmap_vertex>';

/** Shader text of three.js and its replacement. */
const REPLACEMENTS = [
  [
    'shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias',
    'shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias * length( ( pointShadowMatrix[ i ] * worldPosition ).xyz )',
  ],
  [
    'shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias',
    'shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias * max( ( spotLightMatrix[ i ] * worldPosition ).w, 0.0 )',
  ],
] as const;

/**
 * Scales the normal bias of spot and point lights by the distance from the light, because pixels of their maps grow with it. A constant
 * bias leaves stripes far away or detaches shadows nearby.
 */
export function createLocalShadowPatch(): ShaderPatch {
  let chunk = ShaderChunk.shadowmap_vertex;
  for (const [from, to] of REPLACEMENTS) {
    if (!chunk.includes(from)) throw new Error('three.js offsets shadows in another way than expected.');
    chunk = chunk.replace(from, to);
  }
  return {
    key: 'local shadows',
    apply: (shader) => {
      shader.vertexShader = shader.vertexShader.replace(INCLUDE, chunk);
    },
  };
}
