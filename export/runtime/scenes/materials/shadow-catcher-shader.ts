/**
 * The surface of a phantom as a shadow: premultiplied colour, whose alpha is the blocked part of the light that would reach it.
 *
 * Light is weighted as a matt surface receives it, by its luminance and the cosine to the normal, so that a lamp behind a wall
 * neither darkens nor lightens it, and one of two lamps alone makes half a shadow. Where light only grazes the surface the real
 * one is dim by itself, and the shadow fades.
 *
 * Normals are those of the triangles (screen-space derivatives): scanned and detected surfaces come without.
 */
export const CATCHER_VERTEX = /* glsl */ `
#include <common>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
varying vec3 vPositionWorld;

void main() {
  #include <morphinstance_vertex>
  #include <skinbase_vertex>
  #include <begin_vertex>
  #include <morphtarget_vertex>
  #include <skinning_vertex>
  #include <project_vertex>
  vec4 positionWorld = vec4( transformed, 1.0 );
  #ifdef USE_INSTANCING
    positionWorld = instanceMatrix * positionWorld;
  #endif
  vPositionWorld = ( modelMatrix * positionWorld ).xyz;
}
`;

export const CATCHER_FRAGMENT = /* glsl */ `
// Cosine below which light counts as grazing: 6 degrees.
#define GRAZING 0.1

uniform float strength;
// Display-referred sRGB, straight alpha: it is not lit, so it is not encoded either.
uniform vec4 shadowColor;
#if SHADOWED > 0
  uniform sampler2DShadow shadowMaps[ SHADOWED ];
  uniform mat4 mapFromWorld[ SHADOWED ];
  // x: texel in UV, y: depth bias, z: metres along the normal.
  uniform vec3 mapBias[ SHADOWED ];
  // xyz: unit vector towards the light, world; w: luminance.
  uniform vec4 shadowedLights[ SHADOWED ];
#endif
#if PLAIN > 0
  uniform vec4 plainLights[ PLAIN ];
#endif
varying vec3 vPositionWorld;

// Nine comparisons, each over four texels in hardware: a smooth edge about four texels wide, without noise.
float litPart( sampler2DShadow map, vec3 at, float texel ) {
  if ( at.x < 0.0 || at.x > 1.0 || at.y < 0.0 || at.y > 1.0 ) return 1.0;
  // Beyond the map's far end everything in it still stands before.
  float depth = min( at.z, 1.0 );
  float lit = 0.0;
  for ( int y = -1; y <= 1; y ++ ) {
    for ( int x = -1; x <= 1; x ++ ) lit += texture( map, vec3( at.xy + vec2( x, y ) * texel, depth ) );
  }
  return lit / 9.0;
}

void main() {
  vec3 normal = normalize( cross( dFdx( vPositionWorld ), dFdy( vPositionWorld ) ) );
  float received = 0.0;
  float blocked = 0.0;
  float facing;
  float light;
  vec3 at;
  #if SHADOWED > 0
    #pragma unroll_loop_start
    for ( int i = 0; i < SHADOWED; i ++ ) {
      facing = max( dot( normal, shadowedLights[ i ].xyz ), 0.0 );
      light = facing * shadowedLights[ i ].w;
      at = ( mapFromWorld[ i ] * vec4( vPositionWorld + normal * mapBias[ i ].z, 1.0 ) ).xyz;
      at.z -= mapBias[ i ].y;
      received += light;
      blocked += light * smoothstep( 0.0, GRAZING, facing ) * ( 1.0 - litPart( shadowMaps[ i ], at, mapBias[ i ].x ) );
    }
    #pragma unroll_loop_end
  #endif
  #if PLAIN > 0
    for ( int i = 0; i < PLAIN; i ++ ) received += max( dot( normal, plainLights[ i ].xyz ), 0.0 ) * plainLights[ i ].w;
  #endif
  float alpha = received > 0.0 ? clamp( strength * shadowColor.a * blocked / received, 0.0, 1.0 ) : 0.0;
  gl_FragColor = vec4( shadowColor.rgb * alpha, alpha );
}
`;
