import { ShaderChunk } from 'three';
import type { ShaderPatch } from './shader-patch.ts';

const INCLUDE = '#include <shadowmap_vertex>';
const MAIN = 'void main() {';

/** Texts in three.js' shader, each with its replacement. Pages leave out those of kinds of light that they do not have. */
const REPLACEMENTS = [
  [
    'shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias',
    'scrimOffset( shadowWorldNormal, - vec3( directionalShadowMatrix[ i ][ 0 ].z, directionalShadowMatrix[ i ][ 1 ].z, directionalShadowMatrix[ i ][ 2 ].z ) ) * directionalLightShadows[ i ].shadowNormalBias',
  ],
  [
    'shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias',
    'scrimOffset( shadowWorldNormal, - ( pointShadowMatrix[ i ] * worldPosition ).xyz ) * pointLightShadows[ i ].shadowNormalBias * length( ( pointShadowMatrix[ i ] * worldPosition ).xyz )',
  ],
  [
    'shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias',
    'scrimOffset( shadowWorldNormal, scrimCenterOf( spotLightMatrix[ i ] ) - worldPosition.xyz ) * spotLightShadows[ i ].shadowNormalBias * max( ( spotLightMatrix[ i ] * worldPosition ).w, 0.0 )',
  ],
] as const;

const FUNCTIONS = /* glsl */ `
#ifdef USE_SHADOWMAP
// To the side of the surface that the light is on, which for the back of a two-sided surface is against its normal.
vec3 scrimOffset( const in vec3 normal, const in vec3 towards ) {
  #ifdef DOUBLE_SIDED
    return dot( normal, towards ) < 0.0 ? - normal : normal;
  #else
    return normal;
  #endif
}

// Where a perspective matrix projects from: the point whose x, y and w are 0, by Cramer's rule.
vec3 scrimCenterOf( const in mat4 m ) {
  vec3 x = vec3( m[ 0 ].x, m[ 1 ].x, m[ 2 ].x );
  vec3 y = vec3( m[ 0 ].y, m[ 1 ].y, m[ 2 ].y );
  vec3 w = vec3( m[ 0 ].w, m[ 1 ].w, m[ 2 ].w );
  return - ( m[ 3 ].x * cross( y, w ) + m[ 3 ].y * cross( w, x ) + m[ 3 ].w * cross( x, y ) ) / dot( x, cross( y, w ) );
}
#endif
`;

/**
 * Creates a patch that offsets shadow receivers along their normal by the size of a texel at their distance, to the side of the surface
 * that faces the light. three.js offsets by a constant along the normal: in maps of spot and point lights, whose texels grow with distance,
 * that leaves stripes far away or detaches shadows nearby; and it puts the back of a two-sided surface into its own shadow.
 */
export function createShadowOffsetPatch(): ShaderPatch {
  let chunk = ShaderChunk.shadowmap_vertex;
  const count = (chunk.match(/shadowNormalBias/g) ?? []).length;
  if (REPLACEMENTS.filter(([from]) => chunk.includes(from)).length !== count) {
    throw new Error('three.js offsets shadows in another way than expected.');
  }
  for (const [from, to] of REPLACEMENTS) {
    chunk = chunk.replace(from, to);
  }
  return {
    key: 'shadow offsets',
    apply: (shader) => {
      if (!shader.vertexShader.includes(INCLUDE)) return;
      shader.vertexShader = shader.vertexShader.replace(INCLUDE, chunk).replace(MAIN, `${FUNCTIONS}\n${MAIN}`);
    },
  };
}
