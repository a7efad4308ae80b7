/**
 * GLSL that reads what is behind glass: linear, premultiplied, with the coverage as alpha. Level 0 is read as it is, so that clear glass
 * changes nothing. Further levels are read through cubic B-splines, as three.js does, because the texels of a small level would be visible.
 */
export const BEHIND_CHUNK = /* glsl */ `
uniform sampler2D scrimBehind;

vec4 scrimBehindLevel( const in vec2 uv, const in int level ) {
  vec2 size = vec2( textureSize( scrimBehind, level ) );
  vec2 at = uv * size + 0.5;
  vec2 f = fract( at );
  vec2 base = floor( at );
  vec2 rest = 1.0 - f;
  vec2 w0 = rest * rest * rest / 6.0;
  vec2 w1 = ( 4.0 - 6.0 * f * f + 3.0 * f * f * f ) / 6.0;
  vec2 w3 = f * f * f / 6.0;
  vec2 w2 = 1.0 - w0 - w1 - w3;
  vec2 near = w0 + w1;
  vec2 far = w2 + w3;
  // Four filtered reads give the sum of sixteen texels.
  vec2 a = ( base - 1.5 + w1 / near ) / size;
  vec2 b = ( base + 0.5 + w3 / far ) / size;
  float lod = float( level );
  return near.y * ( near.x * textureLod( scrimBehind, a, lod ) + far.x * textureLod( scrimBehind, vec2( b.x, a.y ), lod ) ) +
    far.y * ( near.x * textureLod( scrimBehind, vec2( a.x, b.y ), lod ) + far.x * textureLod( scrimBehind, b, lod ) );
}

// The image itself. Near the center of a texel, it is read without the error of interpolation.
vec4 scrimBehindSharp( const in vec2 uv ) {
  vec2 size = vec2( textureSize( scrimBehind, 0 ) );
  vec2 at = uv * size;
  vec2 center = floor( at ) + 0.5;
  return textureLod( scrimBehind, mix( at, center, vec2( lessThan( abs( at - center ), vec2( 0.03 ) ) ) ) / size, 0.0 );
}

vec4 scrimBehindAt( const in vec2 uv, const in float lod ) {
  ivec2 size = textureSize( scrimBehind, 0 );
  float last = floor( log2( float( max( size.x, size.y ) ) ) );
  float level = clamp( lod, 0.0, last );
  vec4 sharper = level < 1.0 ? scrimBehindSharp( uv ) : scrimBehindLevel( uv, int( level ) );
  if ( fract( level ) == 0.0 ) return sharper;
  return mix( sharper, scrimBehindLevel( uv, int( level ) + 1 ), fract( level ) );
}

// The level for a roughness is that of glTF's sample viewer and of three.js.
vec4 scrimBehindRough( const in vec2 uv, const in float roughness ) {
  return scrimBehindAt( uv, log2( float( textureSize( scrimBehind, 0 ).x ) ) * clamp( roughness, 0.0, 1.0 ) );
}
`;

/**
 * GLSL by which techniques read what is behind them (`export/glsl/technique/interface.ts`): `BEHIND_CHUNK` with a function of a fixed name.
 */
export const TECHNIQUE_BEHIND = `${BEHIND_CHUNK}
vec4 a_BEHIND( const in vec2 uv, const in float roughness ) {
  return scrimBehindRough( uv, roughness );
}
`;
