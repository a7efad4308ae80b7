import { ShaderChunk } from 'three';
import type { ShaderPatch } from './shader-patch.ts';

const INCLUDE = '#include <shadowmap_vertex>';

/** What three writes, and what takes its place. */
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
 * Reads the normal bias of spot and point lights as meters per meter of distance from the light: a pixel of their maps covers the more the farther
 * away it lies, and one distance for all either leaves stripes far off or lifts shadows off their objects nearby.
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
