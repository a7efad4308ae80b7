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

/** For so many lights with a map, and without; written out, because samplers in arrays take constant indices only. */
export function catcherFragment(shadowed: number, plain: number): string {
  const lines = (count: number, line: (i: number) => string): string => Array.from({ length: count }, (_, i) => line(i)).join('\n');
  return /* glsl */ `
// Cosine below which light counts as grazing: 6 degrees.
#define GRAZING 0.1

uniform float strength;
// Display-referred sRGB, straight alpha: it is not lit, so it is not encoded either.
uniform vec4 shadowColor;
${shadowed > 0 ? shadowUniforms(shadowed) : ''}
${plain > 0 ? `uniform vec4 plainLights[ ${plain} ];` : ''}
varying vec3 vPositionWorld;

// Nine comparisons, each over four texels in hardware: a smooth edge about four texels wide, without noise.
float litPart( const in sampler2DShadow map, const in vec3 at, const in float texel ) {
  if ( at.x < 0.0 || at.x > 1.0 || at.y < 0.0 || at.y > 1.0 ) return 1.0;
  // Beyond the map's far end everything in it still stands before.
  float depth = min( at.z, 1.0 );
  float lit = 0.0;
  for ( int y = -1; y <= 1; y ++ ) {
    for ( int x = -1; x <= 1; x ++ ) lit += texture( map, vec3( at.xy + vec2( x, y ) * texel, depth ) );
  }
  return lit / 9.0;
}

// x: light that a matt surface receives; y: how much of it is blocked.
vec2 receive( const in vec4 light, const in vec3 normal, const in sampler2DShadow map, const in mat4 mapFromWorld, const in vec3 bias ) {
  float facing = dot( normal, light.xyz );
  if ( facing <= 0.0 ) return vec2( 0.0 );
  vec3 at = ( mapFromWorld * vec4( vPositionWorld + normal * bias.z, 1.0 ) ).xyz;
  at.z -= bias.y;
  return facing * light.w * vec2( 1.0, smoothstep( 0.0, GRAZING, facing ) * ( 1.0 - litPart( map, at, bias.x ) ) );
}

void main() {
  vec3 normal = normalize( cross( dFdx( vPositionWorld ), dFdy( vPositionWorld ) ) );
  vec2 light = vec2( 0.0 );
  ${lines(shadowed, (i) => `light += receive( shadowedLights[ ${i} ], normal, shadowMaps[ ${i} ], mapFromWorld[ ${i} ], mapBias[ ${i} ] );`)}
  ${lines(plain, (i) => `light.x += max( dot( normal, plainLights[ ${i} ].xyz ), 0.0 ) * plainLights[ ${i} ].w;`)}
  float alpha = light.x > 0.0 ? clamp( strength * shadowColor.a * light.y / light.x, 0.0, 1.0 ) : 0.0;
  gl_FragColor = vec4( shadowColor.rgb * alpha, alpha );
}
`;
}

function shadowUniforms(count: number): string {
  return /* glsl */ `
uniform sampler2DShadow shadowMaps[ ${count} ];
uniform mat4 mapFromWorld[ ${count} ];
// x: texel in UV, y: depth bias, z: metres along the normal.
uniform vec3 mapBias[ ${count} ];
// xyz: unit vector towards the light, world; w: luminance.
uniform vec4 shadowedLights[ ${count} ];`;
}
