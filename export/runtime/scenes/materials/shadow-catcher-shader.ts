/**
 * The surface of a phantom as a shadow: premultiplied colour, whose alpha is the blocked part of the light that would reach it.
 *
 * Light is weighted as a matt surface receives it, by its luminance, its distance and the cosine to the normal, so that a lamp
 * behind a wall neither darkens nor lightens it, and one of two lamps alone makes half a shadow. Where light only grazes the surface
 * the real one is dim by itself, and the shadow fades.
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

const SHADOW_COLOR = /* glsl */ `
uniform float strength;
// Display-referred sRGB, straight alpha: it is not lit, so it is not encoded either.
uniform vec4 shadowColor;`;

const ARRIVING = /* glsl */ `
// Cosine below which light counts as grazing: 6 degrees.
#define GRAZING 0.1

varying vec3 vPositionWorld;

// x: light that a matt surface receives; y: cosine to its normal.
vec2 arriving( const in vec3 normal, const in vec4 place, const in vec4 cone, const in vec3 fall ) {
  vec3 way = place.xyz - place.w * vPositionWorld;
  float distanceM = length( way );
  vec3 towards = way / distanceM;
  float facing = dot( normal, towards );
  float light = fall.x;
  if ( place.w > 0.0 ) {
    light /= max( distanceM * distanceM, 0.01 );
    if ( fall.y > 0.0 ) {
      float left = clamp( 1.0 - pow( distanceM / fall.y, 4.0 ), 0.0, 1.0 );
      light *= left * left;
    }
    if ( cone.w > -1.0 ) light *= smoothstep( cone.w, fall.z, dot( towards, cone.xyz ) );
  }
  return vec2( max( facing, 0.0 ) * light, facing );
}

float unlessGrazing( const in vec2 light, const in float lit ) {
  return light.x * smoothstep( 0.0, GRAZING, light.y ) * ( 1.0 - lit );
}
`;

const NORMAL = 'vec3 normal = normalize( cross( dFdx( vPositionWorld ), dFdy( vPositionWorld ) ) );';

function arrives(light: number): string {
  return `light = arriving( normal, lightPlace[ ${light} ], lightCone[ ${light} ], lightFall[ ${light} ] );`;
}

function writeShadow(blockedPart: string): string {
  return /* glsl */ `float alpha = clamp( strength * shadowColor.a * ( ${blockedPart} ), 0.0, 1.0 );
  gl_FragColor = vec4( shadowColor.rgb * alpha, alpha );`;
}

/** Lights that a catcher is written for: those with a map of one side, with a cube of six, and with none, in this order. */
export interface CatcherLights {
  readonly flat: number;
  readonly cube: number;
  readonly plain: number;
}

/** Written out light by light, because samplers in arrays take constant indices only. */
export function catcherFragment({ flat, cube, plain }: CatcherLights): string {
  const count = flat + cube + plain;
  const lines = (from: number, number: number, line: (light: number, map: number) => string): string =>
    Array.from({ length: number }, (_, i) => line(from + i, i)).join('\n  ');
  return /* glsl */ `
${SHADOW_COLOR}
${count > 0 ? lightUniforms(count) : ''}
${flat > 0 ? flatUniforms(flat) : ''}
${cube > 0 ? cubeUniforms(cube) : ''}
${ARRIVING}
${flat > 0 ? FLAT_LIT : ''}
${cube > 0 ? CUBE_LIT : ''}
void main() {
  ${NORMAL}
  vec2 light;
  float all = 0.0;
  float blocked = 0.0;
  ${lines(0, flat, (i, m) => `${arrives(i)} all += light.x; blocked += unlessGrazing( light, litByFlat( flatMaps[ ${m} ], mapFromWorld[ ${m} ], flatBias[ ${m} ], normal ) );`)}
  ${lines(flat, cube, (i, m) => `${arrives(i)} all += light.x; blocked += unlessGrazing( light, litByCube( cubeMaps[ ${m} ], lightPlace[ ${i} ].xyz, cubeReach[ ${m} ], normal ) );`)}
  ${lines(flat + cube, plain, (i) => `${arrives(i)} all += light.x;`)}
  ${writeShadow('all > 0.0 ? blocked / all : 0.0')}
}
`;
}

/** What one of so many lights gives a surface, as a part of all: what is missing where it is blocked, in the red channel. */
export function blockedFragment(count: number, light: number): string {
  return /* glsl */ `
${lightUniforms(count)}
${ARRIVING}
void main() {
  ${NORMAL}
  vec2 light;
  float all = 0.0;
  float blocked = 0.0;
  ${Array.from({ length: count }, (_, i) => `${arrives(i)} all += light.x;${i === light ? ' blocked = unlessGrazing( light, 0.0 );' : ''}`).join('\n  ')}
  gl_FragColor = vec4( all > 0.0 ? blocked / all : 0.0 );
}
`;
}

/** A shadow whose blocked part is known per pixel of the view. */
export const KNOWN_SHADOW_FRAGMENT = /* glsl */ `
${SHADOW_COLOR}
// Red: the blocked part of the light, pixel by pixel of the viewport, which begins here.
uniform sampler2D blockedPart;
uniform ivec2 viewportStart;

void main() {
  ${writeShadow('texelFetch( blockedPart, ivec2( gl_FragCoord.xy ) - viewportStart, 0 ).r')}
}
`;

function lightUniforms(count: number): string {
  return /* glsl */ `
// xyz: unit vector towards the light, or with w = 1 its place; world.
uniform vec4 lightPlace[ ${count} ];
// xyz: unit vector against the beam, world; w: cosine at the cone's edge, -2 without a cone.
uniform vec4 lightCone[ ${count} ];
// x: luminance; y: range in metres, 0 without end; z: cosine where the cone is in full light.
uniform vec3 lightFall[ ${count} ];`;
}

function flatUniforms(count: number): string {
  return /* glsl */ `
uniform sampler2DShadow flatMaps[ ${count} ];
uniform mat4 mapFromWorld[ ${count} ];
// x: texel in UV, y: depth bias, z: along the normal, times the map's w: metres, or per metre of distance.
uniform vec3 flatBias[ ${count} ];`;
}

function cubeUniforms(count: number): string {
  return /* glsl */ `
uniform samplerCubeShadow cubeMaps[ ${count} ];
// x: near, y: far, metres; z: texel at one metre; w: along the normal per metre of distance.
uniform vec4 cubeReach[ ${count} ];`;
}

const FLAT_LIT = /* glsl */ `
// Nine comparisons, each over four texels in hardware: a smooth edge about four texels wide, without noise.
float litByFlat( const in sampler2DShadow map, const in mat4 fromWorld, const in vec3 bias, const in vec3 normal ) {
  float reach = ( fromWorld * vec4( vPositionWorld, 1.0 ) ).w;
  // Behind a lamp there is none of its light.
  if ( reach <= 0.0 ) return 1.0;
  vec4 at = fromWorld * vec4( vPositionWorld + normal * bias.z * reach, 1.0 );
  at.xyz /= at.w;
  if ( at.x < 0.0 || at.x > 1.0 || at.y < 0.0 || at.y > 1.0 ) return 1.0;
  // Beyond the map's far end everything in it still stands before.
  float depth = min( at.z - bias.y, 1.0 );
  float lit = 0.0;
  for ( int y = -1; y <= 1; y ++ ) {
    for ( int x = -1; x <= 1; x ++ ) lit += texture( map, vec3( at.xy + vec2( x, y ) * bias.x, depth ) );
  }
  return lit / 9.0;
}
`;

const CUBE_LIT = /* glsl */ `
// The same around a lamp. A face holds depth along its own axis, so each comparison is with the point at the receiver's distance
// in its own direction.
float litByCube( const in samplerCubeShadow map, const in vec3 place, const in vec4 reach, const in vec3 normal ) {
  vec3 offset = vPositionWorld - place;
  offset += normal * reach.w * length( offset );
  float distanceM = length( offset );
  vec3 middle = offset / distanceM;
  vec3 side = normalize( abs( middle.x ) > abs( middle.z ) ? vec3( -middle.y, middle.x, 0.0 ) : vec3( 0.0, -middle.z, middle.y ) );
  vec3 up = cross( middle, side );
  float lit = 0.0;
  for ( int y = -1; y <= 1; y ++ ) {
    for ( int x = -1; x <= 1; x ++ ) {
      vec3 direction = middle + ( side * float( x ) + up * float( y ) ) * reach.z;
      vec3 size = abs( direction );
      float axisM = distanceM * max( max( size.x, size.y ), size.z );
      float depth = ( reach.y - reach.x * reach.y / axisM ) / ( reach.y - reach.x );
      lit += texture( map, vec4( direction, clamp( depth, 0.0, 1.0 ) ) );
    }
  }
  return lit / 9.0;
}
`;
