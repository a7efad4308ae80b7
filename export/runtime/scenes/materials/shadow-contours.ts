import type { CubeLight, FlatLight } from './shadow-filter-shader.ts';

/**
 * GLSL body that sets `contour`, the part of the light that arrives and its change per pixel to the right and upward. Both are of a Gaussian
 * over the view whose standard deviation is a few texels of the map, and at least more than a pixel: the steps of texels do not show in a
 * level of it. `lit` is an expression that compares at `offset`, in pixels of the view; `texelPx` is the size of a texel there.
 */
function smoothed(lit: string): string {
  return /* glsl */ `
  float spread = clamp( CONTOUR_TEXELS * texelPx, CONTOUR_PX.x, CONTOUR_PX.y );
  vec3 contour = vec3( 0.0 );
  // Whether light and shadow are near at all.
  float least = 1.0;
  float most = 0.0;
  for ( int i = 0; i < 13; i ++ ) {
    float turn = 0.7853982 * float( i );
    vec2 offset = ( i == 12 ? 0.0 : i < 8 ? 2.5 : 1.2 ) * spread * vec2( cos( turn ), sin( turn ) );
    float lit = ${lit};
    least = min( least, lit );
    most = max( most, lit );
  }
  contour.x = least;
  if ( most - least > 0.02 ) {
    contour = vec3( 0.0 );
    float sum = 0.0;
    // Steps of a texel, or hardware's comparisons of four texels would miss some.
    for ( int y = - 4; y <= 4; y ++ ) {
      for ( int x = - 4; x <= 4; x ++ ) {
        vec2 offset = spread / CONTOUR_TEXELS * vec2( x, y );
        float weight = exp( - 0.5 * dot( offset, offset ) / ( spread * spread ) );
        float lit = ${lit};
        contour += weight * lit * vec3( 1.0, offset / ( spread * spread ) );
        sum += weight;
      }
    }
    contour /= sum;
  }
  return vec4( contour, spread );`;
}

/** GLSL of contours of shadows; it follows that of flat and of cube maps. */
export function contourParts(flat: readonly FlatLight[], cube: readonly CubeLight[]): string {
  return /* glsl */ `
// Standard deviation of the filter, texels of the map, and its limits, pixels of the view.
const float CONTOUR_TEXELS = 1.6;
const vec2 CONTOUR_PX = vec2( 1.3, 24.0 );
${
  flat.length === 0
    ? ''
    : /* glsl */ `
vec4 contourInFlat( const in sampler2DShadow map, const in vec3 at, const in vec3 perX, const in vec3 perY, const in float texel ) {
  float texelPx = texel / max( min( length( perX.xy ), length( perY.xy ) ), 1e-6 );
  // Beyond the border of the map everything is lit.
  vec2 reach = 2.5 * clamp( CONTOUR_TEXELS * texelPx, CONTOUR_PX.x, CONTOUR_PX.y ) * ( abs( perX.xy ) + abs( perY.xy ) );
  if ( any( lessThan( min( at.xy, 1.0 - at.xy ), reach ) ) ) return vec4( 1.0, 0.0, 0.0, 1.0 );
  ${smoothed('textureLod( map, at + perX * offset.x + perY * offset.y, 0.0 )')}
}
`
}${
  cube.length === 0
    ? ''
    : /* glsl */ `
vec4 contourInCube( const in samplerCubeShadow map, const in vec3 perX, const in vec3 perY, const in vec3 place, const in vec4 reach, const in vec3 normal ) {
  float texelPx = reach.z * distance( positionWorld, place ) / max( min( length( perX ), length( perY ) ), 1e-6 );
  ${smoothed('litByCube( map, positionWorld + perX * offset.x + perY * offset.y, place, reach, normal, 0, false )')}
}
`
}`;
}

/** GLSL statement that sets the contour of a light with a flat map; it follows the one that sets `at`. */
export function flatContour(i: number): string {
  return ` contours[ ${i} ] = contourInFlat( flatMaps[ ${i} ], at, dFdx( at ), dFdy( at ), flatBias[ ${i} ].x );`;
}

/** GLSL statement that sets the contour of a light with a cube map, at an index among all lights. */
export function cubeContour(i: number, light: number): string {
  return ` contours[ ${light} ] = contourInCube( cubeMaps[ ${i} ], dFdx( positionWorld ), dFdy( positionWorld ), lightPlace[ ${light} ].xyz, cubeReach[ ${i} ], normal );`;
}
