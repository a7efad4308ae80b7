import { type ShaderPatch, wrapMain } from './shader-patch.ts';

/**
 * Keeps scene layers free of NaN and infinity, which spread with each blur. Normals of zero length and extreme roughness give them; a
 * display layer turns them into black or white by itself. Bits are compared, because drivers optimize `isnan` away.
 */
const FINITE = {
  before: /* glsl */ `
float scrimFinite( float x ) {
  return ( floatBitsToUint( x ) & 0x7FFFFFFFu ) > 0x7F800000u ? 0.0 : clamp( x, - 65504.0, 65504.0 );
}`,
  start: '',
  end: 'gl_FragColor = vec4( scrimFinite( gl_FragColor.r ), scrimFinite( gl_FragColor.g ), scrimFinite( gl_FragColor.b ), clamp( scrimFinite( gl_FragColor.a ), 0.0, 1.0 ) );',
};

export const FINITE_PATCH: ShaderPatch = {
  key: 'finite',
  apply: (shader) => {
    shader.fragmentShader = wrapMain(shader.fragmentShader, FINITE);
  },
};
