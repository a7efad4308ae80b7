import { MAX_STROKE_CASTERS, type ShadowStrokes } from '../../../../nodes/kit/scene-look.ts';

/** Uniforms of the strokes of a shadow, and what brings them up to date. */
export interface StrokeUniforms {
  readonly uniforms: Readonly<Record<string, { value: unknown }>>;
  update(): void;
}

export function createStrokeUniforms(strokes: ShadowStrokes): StrokeUniforms {
  const uniforms = {
    strokeSpacingPx: { value: 0 },
    strokeTurn: { value: 0 },
    strokeContour: { value: 0 },
    strokeContactM: { value: 0 },
    strokeCasters: { value: 0 },
    strokePlaces: { value: strokes.places },
    strokeHeights: { value: strokes.heights },
  };
  return {
    uniforms,
    update: () => {
      uniforms.strokeSpacingPx.value = strokes.spacingPx.value;
      uniforms.strokeTurn.value = strokes.turn.value;
      uniforms.strokeContour.value = strokes.contour.value;
      uniforms.strokeContactM.value = strokes.contactM.value;
      uniforms.strokeCasters.value = strokes.count;
    },
  };
}

/** GLSL of the distance between a receiver and the last caster before it; it follows that of flat maps. */
export const GAP = /* glsl */ `
// Meters along the axis of the light; negative where the last caster is behind the receiver, or the map has no data.
float gapTo( const in sampler2D last, const in vec3 at, const in vec4 reach ) {
  return at.x < 0.0 ? - 1.0 : metersFromLight( at.z, reach ) - metersFromLight( 1.0 - texture2D( last, at.xy ).r, reach );
}
`;

/** GLSL statement that sets the distance of a light with a flat map, whose map of last casters has the index `last`; -1 without. */
export function gapOf(last: number, light: number): string {
  return last < 0 ? '' : ` gapM[ ${light} ] = gapTo( flatExtras[ ${last} ], at, flatReach[ ${light} ] );`;
}

/**
 * GLSL of the strokes of a shadow. They lie on the axis planes that the surface faces, in world space, so they stay where they are while the
 * camera moves. Their distance is a power of two of a smallest one, and every second stroke fades out before the distance doubles (Praun et
 * al. 2001), so they are equally dense on screen near and far.
 *
 * Strokes get denser toward contact. With a flat map, the distance is that to the last caster before the receiver, along the light; else that
 * to the nearest cylinder around an object.
 *
 * @param count Number of lights; `ownPart` and `fullPart` hold what each contributes, blocked and in all, and `gapM` its distance.
 */
export function strokeParts(count: number): string {
  return /* glsl */ `
uniform float strokeSpacingPx;
uniform float strokeTurn;
uniform float strokeContour;
uniform float strokeContactM;
uniform int strokeCasters;
// xyz: center of the base; w: radius.
uniform vec4 strokePlaces[ ${MAX_STROKE_CASTERS} ];
uniform float strokeHeights[ ${MAX_STROKE_CASTERS} ];

float ownPart[ ${Math.max(count, 1)} ];
float fullPart[ ${Math.max(count, 1)} ];
float gapM[ ${Math.max(count, 1)} ];
// x: part of the light that arrives, smoothed; yz: its change per pixel; w: pixels over which it is smoothed.
vec4 contours[ ${Math.max(count, 1)} ];

// The smallest distance between strokes, meters.
const float FINEST_M = 0.0009765625;
// Length of a stroke and offset from its place, in distances between strokes.
const float STROKE_LENGTH = 14.0;
const float STROKE_OFFSET = 0.2;
// Angle between the strokes of one light and the next. No small multiple of it is half a turn.
const float NEXT_LIGHT = 1.1;
// Half width of a contour in distances between strokes.
const float CONTOUR_WIDTH = 0.2;
// At contact, the bias of a map may place the receiver before the caster by this much, meters.
const float TOUCH_M = 0.02;
// Density far from all objects. Strokes at a distance of 0 are twice as dense.
const float FAR_DENSITY = 0.5;

float randomOf( const in int index, const in int seed ) {
  uint h = uint( index ) * 747796405u + uint( seed ) * 2891336453u;
  h = ( ( h >> 16u ) ^ h ) * 73244475u;
  h = ( ( h >> 16u ) ^ h ) * 73244475u;
  return float( ( ( h >> 16u ) ^ h ) & 16777215u ) / 16777216.0;
}

float noiseAlong( const in float at, const in int seed ) {
  float first = floor( at );
  float part = at - first;
  return mix( randomOf( int( first ), seed ), randomOf( int( first ) + 1, seed ), part * part * ( 3.0 - 2.0 * part ) );
}

float nearness( const in float distanceM ) {
  return exp( - distanceM / max( strokeContactM, 1e-4 ) );
}

// How near the point is to an object: 1 at its cylinder, 0 far away.
float contactAt( const in vec3 point ) {
  float nearest = 1e6;
  for ( int i = 0; i < ${MAX_STROKE_CASTERS}; i ++ ) {
    if ( i >= strokeCasters ) break;
    vec3 away = point - strokePlaces[ i ].xyz;
    float side = max( length( away.xz ) - strokePlaces[ i ].w, 0.0 );
    float above = max( max( - away.y, away.y - strokeHeights[ i ] ), 0.0 );
    nearest = min( nearest, length( vec2( side, above ) ) );
  }
  return nearness( nearest );
}

// Ink of strokes along y of a plane, meters, that cover a part of it. \`pixelM\` is the size of a pixel across them.
float strokesAt( const in vec2 at, const in float pixelM, const in float cover, const in int seed ) {
  float level = max( log2( max( strokeSpacingPx * pixelM, FINEST_M ) / FINEST_M ), 0.0 );
  float octave = floor( level );
  float fading = level - octave;
  float spacing = FINEST_M * exp2( octave );
  float nearest = floor( at.x / spacing + 0.5 );
  float ink = 0.0;
  for ( int i = - 1; i <= 1; i ++ ) {
    float index = nearest + float( i );
    bool stays = mod( index, 2.0 ) < 0.5;
    // A stroke has the same number at all distances.
    int line = int( index * exp2( octave ) ) + seed;
    float grown = stays ? 1.0 + fading : 1.0;
    float center = ( index + STROKE_OFFSET * grown * ( 2.0 * randomOf( line, 3 ) - 1.0 ) ) * spacing;
    float start = randomOf( line, 7 );
    float gap = noiseAlong( at.y / ( spacing * STROKE_LENGTH ) + start, line );
    if ( stays ) gap = mix( gap, noiseAlong( at.y / ( 2.0 * spacing * STROKE_LENGTH ) + start, line ), fading );
    // A stroke becomes thin toward its ends.
    float pressure = smoothstep( gap - 0.1, gap + 0.1, cover * 1.2 - 0.1 );
    float presence = min( 1.0, 3.0 * pressure ) * ( stays ? 1.0 : 1.0 - fading );
    float halfWidth = mix( 0.15, 0.42, cover ) * spacing * ( 1.0 + fading ) * sqrt( pressure );
    float away = abs( at.x - center );
    ink = max( ink, presence * ( 1.0 - smoothstep( halfWidth - 0.75 * pixelM, halfWidth + 0.75 * pixelM, away ) ) * min( 1.0, halfWidth / ( 0.5 * pixelM ) ) );
  }
  return ink;
}

// Ink on a plane through a point; \`pixelX\` and \`pixelY\` are what one pixel covers.
float planeInk( const in vec2 place, const in vec2 pixelX, const in vec2 pixelY, const in float angle, const in float cover, const in int seed ) {
  vec2 across = vec2( cos( angle ), sin( angle ) );
  vec2 onto = vec2( dot( place, across ), dot( place, vec2( - across.y, across.x ) ) );
  return strokesAt( onto, length( vec2( dot( pixelX, across ), dot( pixelY, across ) ) ), cover, seed );
}

float surfaceInk( const in vec3 sides, const in vec3 pixelX, const in vec3 pixelY, const in float angle, const in float cover, const in int seed ) {
  float ink = 0.0;
  if ( sides.x > 0.02 ) ink += sides.x * planeInk( positionWorld.zy, pixelX.zy, pixelY.zy, angle, cover, seed + 11 );
  if ( sides.y > 0.02 ) ink += sides.y * planeInk( positionWorld.xz, pixelX.xz, pixelY.xz, angle, cover, seed + 23 );
  if ( sides.z > 0.02 ) ink += sides.z * planeInk( positionWorld.xy, pixelX.xy, pixelY.xy, angle, cover, seed + 37 );
  return ink;
}

float strokeInk( const in vec3 normal, const in float all ) {
  vec3 pixelX = dFdx( positionWorld );
  vec3 pixelY = dFdy( positionWorld );
  vec3 sides = pow( abs( normal ), vec3( 8.0 ) );
  sides /= sides.x + sides.y + sides.z;
  float nearCylinder = contactAt( positionWorld );
  float ink = 0.0;
  for ( int i = 0; i < ${count}; i ++ ) {
    float own = fullPart[ i ] > 0.0 ? ownPart[ i ] / fullPart[ i ] : 0.0;
    float share = all > 0.0 ? ownPart[ i ] / all : 0.0;
    float most = all > 0.0 ? fullPart[ i ] / all : 0.0;
    float angle = strokeTurn + NEXT_LIGHT * float( i );
    float density = mix( FAR_DENSITY, 1.0, gapM[ i ] > - TOUCH_M ? nearness( max( gapM[ i ], 0.0 ) ) : nearCylinder );
    // Pixels from where half of the light arrives, negative in the shadow.
    float steep = length( contours[ i ].yz );
    float hasBorder = smoothstep( 0.08, 0.2, steep * contours[ i ].w );
    float away = ( contours[ i ].x - 0.5 ) / max( steep, 1e-4 );
    float halfPx = max( CONTOUR_WIDTH * strokeSpacingPx, 0.7 );
    if ( share > 0.01 ) {
      float strokes = surfaceInk( sides, pixelX, pixelY, angle, min( 1.5 * density * sqrt( share ), 1.0 ), 4096 * i );
      // Strokes end at the contour.
      ink = 1.0 - ( 1.0 - ink ) * ( 1.0 - strokes * ( 1.0 - hasBorder * smoothstep( 0.0, halfPx, away ) ) );
    }
    float line = hasBorder * ( 1.0 - smoothstep( halfPx - 0.6, halfPx + 0.6, abs( away ) ) );
    ink = max( ink, strokeContour * min( 1.0, 2.0 * most ) * line );
  }
  return ink;
}
`;
}
