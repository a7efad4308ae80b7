/**
 * Variables of both stages, before the author's text. Both also have `projectionMatrix`, which three.js sets in every shader that declares
 * it.
 */
export const OF_BOTH = `uniform float a_TIME;
uniform vec2 a_RENDERSIZE;
vec2 scrim_uv;`;

/** Functions of the interface for both stages. They follow the author's text, which has their prototypes. */
export const FUNCTIONS = `vec2 a_VIEW_UV( const in vec3 position ) {
  vec4 clip = projectionMatrix * ( viewMatrix * vec4( position, 1.0 ) );
  return clip.w > 0.0 ? clip.xy / clip.w * 0.5 + 0.5 : vec2( - 1.0 );
}
float a_VIEW_DEPTH( const in vec3 position ) {
  return - ( viewMatrix * vec4( position, 1.0 ) ).z;
}
float a_PIXEL_M( const in vec3 position ) {
  return 2.0 * max( a_VIEW_DEPTH( position ), 0.0 ) / ( projectionMatrix[ 1 ][ 1 ] * a_RENDERSIZE.y );
}`;

/** Values of the light macros in the vertex stage, which has no lights. The linker rejects texts that use lights there. */
export const WITHOUT_LIGHTS = `#define a_AMBIENT vec3( 0.0 )
#define a_LIGHT_COUNT 0`;

/** What the vertex stage hands to the fragment stage. */
export const VARYINGS = `varying vec3 vTechniquePosition;
varying vec3 vTechniqueNormal;
varying vec2 vTechniqueUv;
varying vec4 vTechniqueColor;
varying vec3 vTechniqueRest;
varying vec3 vTechniqueRestNormal;`;

/** Functions of the wrappers in the vertex stage. */
export const VERTEX_FUNCTIONS = `// Length of a unit along each axis of the matrix.
vec3 scrimScale( const in mat3 m ) {
  return vec3( length( m[ 0 ] ), length( m[ 1 ] ), length( m[ 2 ] ) );
}`;

/** What a vertex shader of a technique begins with: the names that the author's text may use, the text, and functions for both. */
export function vertexHead(text: string, passIndex: number): string {
  return `#define a_EYE cameraPosition
#define a_PASSINDEX ${passIndex}
${WITHOUT_LIGHTS}
${OF_BOTH}
${text}
${FUNCTIONS}`;
}
