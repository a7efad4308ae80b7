import { PANORAMA_UV } from './panorama-uv.ts';

export const UNFOLD_FRAGMENT = /* glsl */ `
uniform sampler2D panorama;
uniform float level;
varying vec3 vDirection;
${PANORAMA_UV}
void main() {
  // An explicit level, because derivatives are invalid at the seam of the panorama.
  gl_FragColor = vec4( textureLod( panorama, panoramaUv( normalize( vDirection ) ), level ).rgb, 1.0 );
}
`;

/** Samples of each pixel of a sampled level. */
export const SAMPLES = 64;

/**
 * Convolution with GGX seen along the normal by importance sampling; each sample covers its share of the lobe (Křivánek and Colbert 2008,
 * “Real-time shading with filtered importance sampling”).
 */
export const SAMPLED_FRAGMENT = /* glsl */ `
#define SAMPLES ${SAMPLES}
// Samples at golden-ratio distances, along the sequence and in angle, cover the lobe evenly.
#define GOLDEN_ANGLE 2.399963229728653
#define TAU 6.283185307179586

uniform samplerCube cube;
uniform float roughness;
uniform float facePx;
varying vec3 vDirection;

void main() {
  vec3 normal = normalize( vDirection );
  if ( roughness == 0.0 ) {
    gl_FragColor = vec4( textureLod( cube, normal, 0.0 ).rgb, 1.0 );
    return;
  }
  float alpha2 = pow( roughness, 4.0 );
  vec3 across = normalize( abs( normal.y ) < 0.9 ? cross( normal, vec3( 0.0, 1.0, 0.0 ) ) : cross( normal, vec3( 1.0, 0.0, 0.0 ) ) );
  vec3 along = cross( normal, across );
  float texelSr = 2.0 * TAU / ( 6.0 * facePx * facePx );
  vec3 sum = vec3( 0.0 );
  float weights = 0.0;
  for ( int i = 0; i < SAMPLES; i ++ ) {
    float u = ( float( i ) + 0.5 ) / float( SAMPLES );
    // Half vectors by the cosine of the distribution: cos² = (1 - u) / (1 + (α² - 1) u).
    float denominator = 1.0 + ( alpha2 - 1.0 ) * u;
    float halfCosine2 = ( 1.0 - u ) / denominator;
    float facing = 2.0 * halfCosine2 - 1.0;
    if ( facing <= 0.0 ) continue;
    float angle = GOLDEN_ANGLE * float( i );
    float radius = sqrt( 1.0 - facing * facing );
    vec3 direction = normal * facing + ( across * cos( angle ) + along * sin( angle ) ) * radius;
    // D = α² / (π (cos² (α² - 1) + 1)²), and a quarter of it is the density of mirrored directions.
    float spread = halfCosine2 * ( alpha2 - 1.0 ) + 1.0;
    float density = alpha2 / ( 2.0 * TAU * spread * spread );
    float sampleSr = 1.0 / ( float( SAMPLES ) * density );
    // Half a level more than exact hides the pattern of the samples.
    float level = max( 0.5 * log2( sampleSr / texelSr ) + 0.5, 0.0 );
    sum += textureLod( cube, direction, level ).rgb * facing;
    weights += facing;
  }
  gl_FragColor = vec4( sum / weights, 1.0 );
}
`;

/**
 * Convolution for lobes as wide as a hemisphere: a weighted sum of all texels of a small cube map. At roughness 1 the weight is the cosine.
 */
export const SUMMED_FRAGMENT = /* glsl */ `
uniform samplerCube cube;
uniform float roughness;
uniform int facePx;
uniform float level;
varying vec3 vDirection;

vec3 directionOf( const in int face, const in vec2 at ) {
  if ( face == 0 ) return vec3( 1.0, at );
  if ( face == 1 ) return vec3( -1.0, at );
  if ( face == 2 ) return vec3( at.x, 1.0, at.y );
  if ( face == 3 ) return vec3( at.x, -1.0, at.y );
  return face == 4 ? vec3( at, 1.0 ) : vec3( at, -1.0 );
}

void main() {
  vec3 normal = normalize( vDirection );
  float alpha2 = pow( roughness, 4.0 );
  vec3 sum = vec3( 0.0 );
  float weights = 0.0;
  for ( int face = 0; face < 6; face ++ ) {
    for ( int y = 0; y < facePx; y ++ ) {
      for ( int x = 0; x < facePx; x ++ ) {
        vec3 towards = directionOf( face, ( vec2( x, y ) + 0.5 ) * 2.0 / float( facePx ) - 1.0 );
        float shorter = inversesqrt( dot( towards, towards ) );
        float facing = dot( normal, towards ) * shorter;
        if ( facing <= 0.0 ) continue;
        // cos² of the half vector is (1 + facing) / 2; the solid angle of a texel decreases with the cube of its distance.
        float spread = ( 1.0 + facing ) * 0.5 * ( alpha2 - 1.0 ) + 1.0;
        float weight = facing * shorter * shorter * shorter / ( spread * spread );
        sum += textureLod( cube, towards, level ).rgb * weight;
        weights += weight;
      }
    }
  }
  gl_FragColor = vec4( sum / weights, 1.0 );
}
`;
