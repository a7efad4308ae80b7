/** Parts of the shaders of techniques that read the radial curvature: `s.radial`. */

/** Whether the text of a technique's fragment stage reads the radial curvature, which is computed only for such techniques. */
export function readsRadial(fragment: string): boolean {
  return fragment.includes('.radial');
}

export const RADIAL_VARYING = 'varying vec2 vScrimRadial;';

/**
 * The radial curvature is that of the surface in the direction to the eye, and its derivative is in that direction, too: DeCarlo,
 * Finkelstein, Rusinkiewicz, Santella, Suggestive Contours for Conveying Shape, SIGGRAPH 2003, section 3.1 and appendix. Both are linear in
 * a triangle. Where a surface is skinned, its curvature is that at rest and the direction to the eye is turned back.
 */
export const RADIAL_VERTEX = {
  declarations: `attribute vec4 scrimCurvature;
attribute vec4 scrimCurvature2;
attribute vec4 scrimCurvatureChange;
${RADIAL_VARYING}`,
  main: `mat3 scrimTurn = mat3( worldFromVertex );
  #ifdef USE_SKINNING
    scrimTurn = scrimTurn * mat3( bindMatrixInverse * skinMatrix * bindMatrix );
  #endif
  vec3 scrimView = normalize( inverse( scrimTurn ) * ( cameraPosition - vertex.position ) );
  vec2 scrimW = vec2( dot( scrimView, scrimCurvature.xyz ), dot( scrimView, scrimCurvature2.xyz ) );
  float scrimCosine = dot( scrimView, cross( scrimCurvature.xyz, scrimCurvature2.xyz ) );
  float scrimSine2 = max( dot( scrimW, scrimW ), 0.0001 );
  float scrimTorsion = ( scrimCurvature2.w - scrimCurvature.w ) * scrimW.x * scrimW.y / scrimSine2;
  float scrimCubic = scrimW.x * scrimW.x * ( scrimW.x * scrimCurvatureChange.x + 3.0 * scrimW.y * scrimCurvatureChange.y )
    + scrimW.y * scrimW.y * ( 3.0 * scrimW.x * scrimCurvatureChange.z + scrimW.y * scrimCurvatureChange.w );
  vScrimRadial = vec2( scrimCurvature.w * scrimW.x * scrimW.x + scrimCurvature2.w * scrimW.y * scrimW.y,
    scrimCubic / scrimSine2 - 2.0 * scrimCosine * scrimTorsion * scrimTorsion );`,
};

export const RADIAL_FRAGMENT = `#ifdef SCRIM_EDGES
    surface.radial = vec2( 1.0, 0.0 );
  #else
    surface.radial = vScrimRadial;
  #endif`;
