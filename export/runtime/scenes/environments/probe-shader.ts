/**
 * Fragment shader that evaluates spherical harmonics as radiance after a rotationally symmetric blur, which scales each band (Ramamoorthi
 * and Hanrahan 2001, eq. 3 and 5). Sums of nine coefficients may be negative, and are clamped to 0.
 */
export const HARMONICS_FRAGMENT = /* glsl */ `
// Linear-sRGB radiance, in the order of WebXR Lighting Estimation, section 3.2.
uniform vec3 harmonics[ 9 ];
// Factors of the three bands.
uniform vec3 bands;
varying vec3 vDirection;

void main() {
  vec3 n = normalize( vDirection );
  vec3 radiance = harmonics[ 0 ] * ( 0.282094791773878 * bands.x );
  radiance += ( harmonics[ 1 ] * n.y + harmonics[ 2 ] * n.z + harmonics[ 3 ] * n.x ) * ( 0.488602511902919 * bands.y );
  vec3 second = ( harmonics[ 4 ] * ( n.x * n.y ) + harmonics[ 5 ] * ( n.y * n.z ) + harmonics[ 7 ] * ( n.x * n.z ) ) * 1.092548430592079;
  second += harmonics[ 6 ] * ( 0.31539156525252 * ( 3.0 * n.z * n.z - 1.0 ) );
  second += harmonics[ 8 ] * ( 0.5462742152960395 * ( n.x * n.x - n.y * n.y ) );
  gl_FragColor = vec4( max( radiance + second * bands.z, 0.0 ), 1.0 );
}
`;

export const REFLECTION_FRAGMENT = /* glsl */ `
uniform samplerCube reflection;
uniform mat3 cubeFromWorld;
varying vec3 vDirection;

void main() {
  gl_FragColor = vec4( textureLod( reflection, cubeFromWorld * vDirection, 0.0 ).rgb, 1.0 );
}
`;
