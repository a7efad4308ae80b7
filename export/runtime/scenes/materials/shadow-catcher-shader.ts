import { MAX_GLOW_SPOTS } from '../../../../nodes/kit/scene-look.ts';
import { BEHIND_TRANSLUCENT } from '../lights/translucent-shadow.ts';
import { contourParts, cubeContour, flatContour } from './shadow-contours.ts';
import { type CubeLight, cubeLit, cubeParts, type FlatLight, flatLit, flatParts } from './shadow-filter-shader.ts';
import { GAP, gapOf, strokeParts } from './shadow-strokes.ts';

/**
 * Vertex shader of shadow catchers. They draw the surface of a phantom as a shadow: premultiplied color whose alpha is the blocked fraction
 * of the light that would reach the surface.
 *
 * Lights are weighted by luminance, distance and the cosine to the normal, as a matte surface receives them, so that a light behind a wall
 * has no effect, and one of two equal lights gives half a shadow. At grazing light the real surface is dim, so the shadow fades.
 *
 * Normals are those of the triangles (screen-space derivatives), because scanned and detected surfaces have none.
 */
export const CATCHER_VERTEX = /* glsl */ `
#include <common>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
varying vec3 vPositionWorld;
// As the depth pass declares it, so that both have the same depth.
invariant gl_Position;

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
// Cosine below which light is grazing: 6 degrees.
#define GRAZING 0.1

// Of the surface.
vec3 positionWorld;

// x: light that a matte surface receives; y: cosine to its normal.
vec2 arriving( const in vec3 normal, const in vec4 place, const in vec4 cone, const in vec3 fall ) {
  vec3 way = place.xyz - place.w * positionWorld;
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

/**
 * GLSL of a negative shadow: light on the surfaces around objects, which shadows interrupt (ARPAS 2018, section 4). Shadows dim it in
 * linear light; its alpha is 0.
 */
const GLOW = /* glsl */ `
// -1: no light is drawn.
uniform int glowCount;
uniform vec4 glowColor;
uniform float glowBorder;
// xy: center; zw: unit vector along the first axis; world x and z.
uniform vec4 glowPlaces[ ${MAX_GLOW_SPOTS} ];
// xy: semi-axes; z: height; w: distance above and below at which it has faded.
uniform vec4 glowSizes[ ${MAX_GLOW_SPOTS} ];

vec4 glow( const in float blockedPart ) {
  float bright = 0.0;
  for ( int i = 0; i < ${MAX_GLOW_SPOTS}; i++ ) {
    if ( i >= glowCount ) break;
    vec2 away = positionWorld.xz - glowPlaces[ i ].xy;
    vec2 along = glowPlaces[ i ].zw;
    float radius = length( vec2( dot( away, along ), dot( away, vec2( - along.y, along.x ) ) ) / glowSizes[ i ].xy );
    float off = abs( positionWorld.y - glowSizes[ i ].z ) / glowSizes[ i ].w;
    bright = max( bright, ( 1.0 - smoothstep( 1.0 - glowBorder, 1.0, radius ) ) * ( 1.0 - smoothstep( 0.5, 1.0, off ) ) );
  }
  vec3 base = mix( pow( ( glowColor.rgb + 0.055 ) / 1.055, vec3( 2.4 ) ), glowColor.rgb / 12.92, vec3( lessThanEqual( glowColor.rgb, vec3( 0.04045 ) ) ) );
  vec3 light = base * glowColor.a * bright * ( 1.0 - clamp( strength * blockedPart, 0.0, 1.0 ) );
  return vec4( mix( 1.055 * pow( light, vec3( 1.0 / 2.4 ) ) - 0.055, light * 12.92, vec3( lessThanEqual( light, vec3( 0.0031308 ) ) ) ), 0.0 );
}
`;

const GEOMETRY = {
  declarations: 'varying vec3 vPositionWorld;',
  find: `positionWorld = vPositionWorld;
  vec3 normal = normalize( cross( dFdx( vPositionWorld ), dFdy( vPositionWorld ) ) );`,
  drop: '',
};

function arrives(light: number): string {
  return `light = arriving( normal, lightPlace[ ${light} ], lightCone[ ${light} ], lightFall[ ${light} ] );`;
}

function writeShadow(blockedPart: string): string {
  return /* glsl */ `float alpha = clamp( strength * shadowColor.a * ( ${blockedPart} ), 0.0, 1.0 );
    gl_FragColor = vec4( shadowColor.rgb * alpha, alpha );`;
}

/** The lights in the shader, in this order: those with a flat map, those with a cube map, and (as a number) those without a map. */
export interface CatcherLights {
  readonly flat: readonly FlatLight[];
  readonly cube: readonly CubeLight[];
  readonly plain: number;
}

/**
 * How a catcher finds its surface: declarations, statements that set `positionWorld` and `normal`, and a last statement that discards
 * fragments without surface.
 */
export type CatcherSurface = typeof GEOMETRY;

/**
 * Fragment shader of a shadow catcher for the given lights. The code is unrolled per light, because arrays of samplers require constant
 * indices. `glows` adds the negative shadow; with `strokes`, shadows are drawn as strokes.
 */
export function catcherFragment(
  { flat, cube, plain }: CatcherLights,
  { declarations, find, drop }: CatcherSurface = GEOMETRY,
  glows = false,
  strokes = false,
): string {
  const count = flat.length + cube.length + plain;
  const extras = flat.flatMap(({ extra, translucent, last }) => [extra, translucent, last]).filter((index) => index >= 0).length;
  const add = (light: number): string =>
    strokes
      ? `all += light.x; gapM[ ${light} ] = - 1.0; fullPart[ ${light} ] = light.x; ownPart[ ${light} ] = unlessGrazing( light, lit ); blocked += ownPart[ ${light} ];`
      : 'all += light.x; blocked += unlessGrazing( light, lit );';
  const addPlain = (light: number): string =>
    strokes
      ? `fullPart[ ${light} ] = light.x; ownPart[ ${light} ] = 0.0; gapM[ ${light} ] = - 1.0; contours[ ${light} ] = vec4( 1.0, 0.0, 0.0, 1.0 );`
      : '';
  const lines = [
    ...flat.map((light, i) => `${arrives(i)} ${flatLit(light, i)} ${add(i)}${strokes ? gapOf(light.last, i) + flatContour(i) : ''}`),
    ...cube.map((light, i) => {
      const at = flat.length + i;
      return `${arrives(at)} ${cubeLit(light, i, at)} ${add(at)}${strokes ? cubeContour(i, at) : ''}`;
    }),
    ...Array.from(
      { length: plain },
      (_, i) => `${arrives(flat.length + cube.length + i)} all += light.x; ${addPlain(flat.length + cube.length + i)}`,
    ),
  ];
  return /* glsl */ `
${SHADOW_COLOR}
${count > 0 ? lightUniforms(count) : ''}
${declarations}
${ARRIVING}
${glows ? GLOW : ''}
${strokes ? strokeParts(count) : ''}
${BEHIND_TRANSLUCENT}
${flatParts(flat, extras)}
${strokes && flat.length > 0 ? GAP : ''}
${cubeParts(cube)}
${strokes ? contourParts(flat, cube) : ''}
void main() {
  ${find}
  vec2 light;
  vec3 at;
  float lit;
  float all = 0.0;
  float blocked = 0.0;
  ${lines.join('\n  ')}
  float part = all > 0.0 ? blocked / all : 0.0;
  ${glows ? 'if ( glowCount >= 0 ) gl_FragColor = glow( part ); else' : ''} {
    ${writeShadow(strokes ? 'strokeInk( normal, all )' : 'part')}
  }
  ${drop}
}
`;
}

/**
 * Fragment shader that writes the contribution of one light as a fraction of all light: the part that is missing where that light is
 * blocked.
 */
export function blockedFragment(count: number, light: number): string {
  return /* glsl */ `
${lightUniforms(count)}
${GEOMETRY.declarations}
${ARRIVING}
void main() {
  ${GEOMETRY.find}
  vec2 light;
  float all = 0.0;
  float blocked = 0.0;
  ${Array.from({ length: count }, (_, i) => `${arrives(i)} all += light.x;${i === light ? ' blocked = unlessGrazing( light, 0.0 );' : ''}`).join('\n  ')}
  gl_FragColor = vec4( all > 0.0 ? blocked / all : 0.0 );
}
`;
}

/** Fragment shader that draws a shadow whose blocked fraction was drawn before, to a texture with a texel per pixel of the view. */
export const KNOWN_SHADOW_FRAGMENT = /* glsl */ `
${SHADOW_COLOR}
// Red: the blocked fraction of the light per pixel of the viewport.
uniform sampler2D blockedPart;
uniform ivec2 viewportStart;

void main() {
  ${writeShadow('texelFetch( blockedPart, ivec2( gl_FragCoord.xy ) - viewportStart, 0 ).r')}
}
`;

function lightUniforms(count: number): string {
  return /* glsl */ `
// xyz: unit vector towards the light, or with w = 1 its position; world.
uniform vec4 lightPlace[ ${count} ];
// xyz: unit vector against the beam, world; w: cosine at the cone's edge, -2 without a cone.
uniform vec4 lightCone[ ${count} ];
// x: luminance; y: range in meters, 0 for infinite; z: cosine of the fully lit cone.
uniform vec3 lightFall[ ${count} ];`;
}
