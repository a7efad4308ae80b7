/** Parts of the shaders of techniques that read the direction field of a mesh: `s.along` and `s.smoothNormal`. */

/** Whether the text of a technique's fragment stage reads the direction field, which is computed only for such techniques. */
export function readsDirections(fragment: string): boolean {
  return fragment.includes('.along') || fragment.includes('.smoothNormal');
}

/**
 * The squares and products of a direction's components, because these do not depend on its sign and may be interpolated where the
 * directions of two vertices point in opposite ways.
 */
export const DIRECTION_VARYINGS = `varying vec3 vScrimSquares;
varying vec3 vScrimProducts;
varying vec3 vScrimSmoothNormal;`;

export const DIRECTION_VERTEX = {
  declarations: `attribute vec3 scrimAlong;
attribute vec3 scrimSmoothNormal;
${DIRECTION_VARYINGS}`,
  main: `vec3 scrimAlongRest = normalize( scrimAlong * restScale );
  vScrimSquares = scrimAlongRest * scrimAlongRest;
  vScrimProducts = scrimAlongRest.yzx * scrimAlongRest.zxy;
  vScrimSmoothNormal = scrimSmoothNormal / restScale;`,
};

/** The direction is the axis of the interpolated tensor in the plane of the surface. */
export const DIRECTION_FRAGMENT = `#ifdef SCRIM_EDGES
    surface.along = vec3( 0.0 );
    surface.smoothNormal = surface.restNormal;
  #else
    surface.smoothNormal = normalize( vScrimSmoothNormal );
    mat3 scrimTensor = mat3( vScrimSquares.x, vScrimProducts.zy, vScrimProducts.z, vScrimSquares.y, vScrimProducts.x, vScrimProducts.yx, vScrimSquares.z );
    vec3 scrimTangent = normalize( cross( abs( surface.restNormal.y ) < 0.9 ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 ), surface.restNormal ) );
    vec3 scrimBitangent = cross( surface.restNormal, scrimTangent );
    vec3 scrimAcross = scrimTensor * scrimBitangent;
    float scrimAngle = 0.5 * atan( 2.0 * dot( scrimTangent, scrimAcross ), dot( scrimTangent, scrimTensor * scrimTangent ) - dot( scrimBitangent, scrimAcross ) );
    surface.along = scrimTangent * cos( scrimAngle ) + scrimBitangent * sin( scrimAngle );
  #endif`;
