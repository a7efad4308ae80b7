import type { ShadowFilter } from '../../../../nodes/kit/light-shadow.ts';

/** GLSL function of each filter, which returns the lit fraction in [0, 1]. */
const FILTERS: Readonly<Record<ShadowFilter, string>> = {
  basic: /* glsl */ `
// At the center of a texel, hardware compares with this texel only.
float litByBasic( const in sampler2DShadow map, const in vec3 at, const in float texel ) {
  return texture( map, vec3( ( floor( at.xy / texel ) + 0.5 ) * texel, at.z ) );
}
`,
  pcf: /* glsl */ `
// Four texels, weighted in hardware.
float litByPcf( const in sampler2DShadow map, const in vec3 at ) {
  return texture( map, at );
}
`,
  soft: /* glsl */ `
// Nine comparisons, each over four texels in hardware: a smooth edge about four texels wide, without noise.
float litBySoft( const in sampler2DShadow map, const in vec3 at, const in float texel ) {
  float lit = 0.0;
  for ( int y = -1; y <= 1; y ++ ) {
    for ( int x = -1; x <= 1; x ++ ) lit += texture( map, vec3( at.xy + vec2( x, y ) * texel, at.z ) );
  }
  return lit / 9.0;
}
`,
  vsm: /* glsl */ `
// Minimum standard deviation of depth, meters: rounding and the slope within a texel; beyond 8 m, per meter, because squares in 32 bits
// resolve less.
#define LEAST_SPREAD 0.004
#define LEAST_SPREAD_PART 0.0005
// Light leaking below this bound is cut off and the rest rescaled (Lauritzen 2007, section 8.4.3).
#define BLEEDING 0.2

// Upper bound of the fraction of casters behind the receiver (Chebyshev's inequality).
float litByVsm( const in sampler2D moments, const in vec3 at, const in vec4 reach ) {
  vec3 m = texture2D( moments, at.xy ).rgb;
  if ( m.x <= 0.0 ) return 1.0;
  float mean = m.y / m.x;
  float behind = metersFromLight( at.z, reach ) - mean;
  if ( behind <= 0.0 ) return 1.0;
  float least = max( LEAST_SPREAD, LEAST_SPREAD_PART * mean );
  float variance = max( m.z / m.x - mean * mean, least * least );
  float bound = variance / ( variance + behind * behind );
  return 1.0 - m.x * ( 1.0 - clamp( ( bound - BLEEDING ) / ( 1.0 - BLEEDING ), 0.0, 1.0 ) );
}
`,
  pcss: /* glsl */ `
#define SEARCH_TAPS 16
#define PENUMBRA_TAPS 32
// Maximum radius relative to the map's side; beyond it, samples would be too sparse.
#define WIDEST 0.35

// Evenly distributed over a disc, rotated per pixel (Vogel 1979; Jimenez 2014, interleaved gradient noise).
vec2 inDisc( const in int tap, const in float taps, const in float turn ) {
  float angle = float( tap ) * 2.399963229728653 + turn;
  return sqrt( ( float( tap ) + 0.5 ) / taps ) * vec2( cos( angle ), sin( angle ) );
}

// Radius of the penumbra in UV, by similar triangles (Fernando 2005).
float penumbra( const in float casterM, const in float receiverM, const in vec4 reach ) {
  float radius = reach.z * ( receiverM - casterM );
  return reach.w <= 0.0 ? radius : radius / casterM * reach.w / receiverM;
}

float litByPcss( const in sampler2DShadow map, const in sampler2D depths, const in vec3 at, const in float texel, const in vec4 reach ) {
  float receiverM = metersFromLight( at.z, reach );
  float turn = 6.283185307179586 * fract( 52.9829189 * fract( dot( gl_FragCoord.xy, vec2( 0.06711056, 0.00583715 ) ) ) );
  float search = clamp( penumbra( max( reach.x, 0.001 ), receiverM, reach ), texel, WIDEST );
  float casters = 0.0;
  float sum = 0.0;
  for ( int i = 0; i < SEARCH_TAPS; i ++ ) {
    float depth = 1.0 - texture2D( depths, at.xy + inDisc( i, float( SEARCH_TAPS ), turn ) * search ).r;
    if ( depth < at.z ) {
      casters += 1.0;
      sum += metersFromLight( depth, reach );
    }
  }
  if ( casters == 0.0 ) return 1.0;
  float radius = clamp( penumbra( sum / casters, receiverM, reach ), texel, WIDEST );
  float lit = 0.0;
  for ( int i = 0; i < PENUMBRA_TAPS; i ++ ) lit += texture( map, vec3( at.xy + inDisc( i, float( PENUMBRA_TAPS ), turn ) * radius, at.z ) );
  return lit / float( PENUMBRA_TAPS );
}
`,
};

/** A light with a flat map, as the shader needs it. */
export interface FlatLight {
  readonly filter: ShadowFilter;
  /** Index among the textures that do not compare (depths or moments); -1 without. */
  readonly extra: number;
  /** Index of its translucent shadow map among the same textures; -1 without. */
  readonly translucent: number;
  /** Index of the map of its last casters among the same textures; -1 without. */
  readonly last: number;
}

export interface CubeLight {
  readonly filter: ShadowFilter;
  /** Index of its translucent shadow map, or -1. */
  readonly translucent: number;
}

/** GLSL that converts a depth in a shadow map to the distance along the light's axis, meters. */
const METERS = /* glsl */ `
float metersFromLight( const in float depth, const in vec4 reach ) {
  // Directional lights measure linearly from the nearest caster.
  return reach.w <= 0.0 ? depth * reach.y : reach.x * reach.y / ( reach.y - depth * ( reach.y - reach.x ) );
}
`;

/**
 * GLSL that reads the fraction of light behind transparent casters, averaged over nine texels. Receivers in front of the nearest
 * transparent caster are not dimmed. No normal bias is needed, because receivers are not transparent themselves.
 */
const TRANSLUCENT_SHADOW = /* glsl */ `
float metersToPoint( const in mat4 fromWorld, const in vec4 reach, const in vec3 positionWorld ) {
  vec4 at = fromWorld * vec4( positionWorld, 1.0 );
  return reach.w <= 0.0 ? at.z * reach.y : at.w;
}

float throughTranslucent( const in sampler2D translucent, const in vec3 at, const in float texel, const in float meters ) {
  float through = 0.0;
  for ( int y = -1; y <= 1; y ++ ) {
    for ( int x = -1; x <= 1; x ++ ) {
      vec4 v = texture2D( translucent, at.xy + vec2( x, y ) * texel );
      through += isBehindTranslucent( meters, v.a ) ? v.r : 1.0;
    }
  }
  return through / 9.0;
}
`;

const CUBE_TRANSLUCENT_SHADOW = /* glsl */ `
float throughCubeTranslucent( const in samplerCube translucent, const in vec3 positionWorld, const in vec3 place ) {
  vec3 offset = positionWorld - place;
  vec3 size = abs( offset );
  vec4 v = textureCube( translucent, offset );
  return isBehindTranslucent( max( max( size.x, size.y ), size.z ), v.a ) ? v.r : 1.0;
}
`;

/** GLSL declarations and functions for lights with a flat map. */
export function flatParts(lights: readonly FlatLight[], extras: number): string {
  if (lights.length === 0) return '';
  const filters = [...new Set(lights.map(({ filter }) => filter))].sort();
  return /* glsl */ `
uniform sampler2DShadow flatMaps[ ${lights.length} ];
uniform mat4 mapFromWorld[ ${lights.length} ];
// x: texel in UV; y: depth bias; z: normal bias, times the map's w: meters, or per meter of distance.
uniform vec3 flatBias[ ${lights.length} ];
// x: near, y: far, meters; z and w as \`ShadowMap.source\`.
uniform vec4 flatReach[ ${lights.length} ];
${extras > 0 ? `uniform sampler2D flatExtras[ ${extras} ];` : ''}
// UV and depth of the receiver in a map; a negative x where the map has no data, which is lit.
vec3 inFlat( const in mat4 fromWorld, const in vec3 bias, const in vec3 positionWorld, const in vec3 normal ) {
  float reach = ( fromWorld * vec4( positionWorld, 1.0 ) ).w;
  // A spot light has no light behind it.
  if ( reach <= 0.0 ) return vec3( -1.0 );
  vec4 at = fromWorld * vec4( positionWorld + normal * bias.z * reach, 1.0 );
  at.xyz /= at.w;
  if ( at.x < 0.0 || at.x > 1.0 || at.y < 0.0 || at.y > 1.0 ) return vec3( -1.0 );
  // Beyond the far end, everything in the map is in front.
  return vec3( at.xy, min( at.z - bias.y, 1.0 ) );
}
${METERS}${filters.map((filter) => FILTERS[filter]).join('')}${lights.some(({ translucent }) => translucent >= 0) ? TRANSLUCENT_SHADOW : ''}`;
}

/** GLSL statements that set `at` and `lit` for the light at index `i` among those with a flat map. */
export function flatLit({ filter, extra, translucent }: FlatLight, i: number): string {
  const through =
    translucent < 0
      ? ''
      : ` * throughTranslucent( flatExtras[ ${translucent} ], at, flatBias[ ${i} ].x, metersToPoint( mapFromWorld[ ${i} ], flatReach[ ${i} ], positionWorld ) )`;
  return `at = inFlat( mapFromWorld[ ${i} ], flatBias[ ${i} ], positionWorld, normal ); lit = at.x < 0.0 ? 1.0 : ${call(filter, i, extra)}${through};`;
}

function call(filter: ShadowFilter, i: number, extra: number): string {
  switch (filter) {
    case 'basic':
      return `litByBasic( flatMaps[ ${i} ], at, flatBias[ ${i} ].x )`;
    case 'pcf':
      return `litByPcf( flatMaps[ ${i} ], at )`;
    case 'soft':
      return `litBySoft( flatMaps[ ${i} ], at, flatBias[ ${i} ].x )`;
    case 'vsm':
      return `litByVsm( flatExtras[ ${extra} ], at, flatReach[ ${i} ] )`;
    case 'pcss':
      return `litByPcss( flatMaps[ ${i} ], flatExtras[ ${extra} ], at, flatBias[ ${i} ].x, flatReach[ ${i} ] )`;
  }
}

/** Number of comparisons to each side of the center by the filters of lights with a cube map: 1 averages 3 × 3. */
const CUBE_SIDE: Readonly<Record<ShadowFilter, number>> = { basic: 0, pcf: 0, soft: 1, vsm: 1, pcss: 1 };

export function cubeParts(lights: readonly CubeLight[]): string {
  if (lights.length === 0) return '';
  const translucentShadows = lights.filter(({ translucent }) => translucent >= 0).length;
  return /* glsl */ `
uniform samplerCubeShadow cubeMaps[ ${lights.length} ];
// x: near, y: far, meters; z: texel at one meter; w: normal bias per meter of distance.
uniform vec4 cubeReach[ ${lights.length} ];
${translucentShadows > 0 ? `uniform samplerCube cubeTranslucent[ ${translucentShadows} ];${CUBE_TRANSLUCENT_SHADOW}` : ''}
${TEXEL_OF_CUBE}

// As with a flat map. A face has depth along its own axis, so each comparison uses the point at the receiver's distance in its own
// direction.
float litByCube( const in samplerCubeShadow map, const in vec3 positionWorld, const in vec3 place, const in vec4 reach, const in vec3 normal, const in int taps, const in bool snaps ) {
  vec3 offset = positionWorld - place;
  offset += normal * reach.w * length( offset );
  float distanceM = length( offset );
  vec3 middle = offset / distanceM;
  if ( snaps ) middle = texelOfCube( middle, reach.z );
  vec3 side = normalize( abs( middle.x ) > abs( middle.z ) ? vec3( -middle.y, middle.x, 0.0 ) : vec3( 0.0, -middle.z, middle.y ) );
  vec3 up = cross( middle, side );
  float lit = 0.0;
  for ( int y = -taps; y <= taps; y ++ ) {
    for ( int x = -taps; x <= taps; x ++ ) {
      vec3 direction = middle + ( side * float( x ) + up * float( y ) ) * reach.z;
      vec3 size = abs( direction );
      float axisM = distanceM * max( max( size.x, size.y ), size.z ) / ( snaps ? length( middle ) : 1.0 );
      float depth = ( reach.y - reach.x * reach.y / axisM ) / ( reach.y - reach.x );
      lit += texture( map, vec4( direction, clamp( depth, 0.0, 1.0 ) ) );
    }
  }
  float side1 = float( 2 * taps + 1 );
  return lit / ( side1 * side1 );
}
`;
}

/** GLSL that returns the center of the texel in a direction, on the face of the unit cube. */
const TEXEL_OF_CUBE = /* glsl */ `
vec3 texelOfCube( const in vec3 direction, const in float texel ) {
  vec3 size = abs( direction );
  float axis = max( max( size.x, size.y ), size.z );
  vec3 onFace = direction / axis;
  vec3 snapped = ( floor( ( onFace + 1.0 ) / texel ) + 0.5 ) * texel - 1.0;
  return mix( snapped, onFace, vec3( equal( size, vec3( axis ) ) ) );
}`;

export function cubeLit({ filter, translucent }: CubeLight, i: number, light: number): string {
  const through =
    translucent < 0 ? '' : ` * throughCubeTranslucent( cubeTranslucent[ ${translucent} ], positionWorld, lightPlace[ ${light} ].xyz )`;
  return `lit = litByCube( cubeMaps[ ${i} ], positionWorld, lightPlace[ ${light} ].xyz, cubeReach[ ${i} ], normal, ${CUBE_SIDE[filter]}, ${filter === 'basic'} )${through};`;
}
