/** GLSL: UV of a direction in an equirectangular image, whose center is -z and whose right half is +x. */
export const PANORAMA_UV = /* glsl */ `
vec2 panoramaUv( const in vec3 direction ) {
  return vec2( atan( direction.x, -direction.z ) * 0.15915494309189535, asin( clamp( direction.y, -1.0, 1.0 ) ) * 0.3183098861837907 ) + 0.5;
}
`;
