import { environmentVertex } from '../technique-environment.ts';
import { VARYINGS, VERTEX_FUNCTIONS, vertexHead } from '../wrapper-parts.ts';

/**
 * The vertex shader of a pass of a technique that draws edges as lines. It reads the segments of `edge-geometry.ts` by `gl_VertexID`, poses
 * both faces of the edge and, where the edge is a line in this view, spans a quad that faces the camera.
 *
 * - The quad of a silhouette lies outside of its object: the inner half of a centered line would be hidden, because a surface that turns
 *   away is in front of its own silhouette.
 * - A silhouette is an edge between a face that faces the camera and one that does not. The zero set of interpolated normals would be
 *   smoother, but lies inside of what is drawn, by several pixels on coarse meshes.
 * - Instanced drawing would need no index, but instances are taken where the mesh itself is instanced.
 *
 * @param text The technique's vertex stage.
 * @param fragment The technique's fragment stage.
 */
export function techniqueEdges(text: string, fragment: string, passIndex: number): string {
  const environment = environmentVertex(fragment);
  return /* glsl */ `
${vertexHead(text, passIndex)}
#include <common>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
uniform highp sampler2D scrimVertices;
uniform highp sampler2D scrimSegments;
${VARYINGS}
varying vec3 vTechniqueLine;
${environment.pars}

vec4 scrimFetch( highp sampler2D texels, const in int index ) {
  int width = textureSize( texels, 0 ).x;
  return texelFetch( texels, ivec2( index % width, index / width ), 0 );
}

#ifdef USE_SKINNING
  #define SCRIM_STRIDE 3
#else
  #define SCRIM_STRIDE 1
#endif

${VERTEX_FUNCTIONS}

// Position of a vertex after morphing and skinning, and the scale of its bones.
vec3 scrimPosed( const in int vertex, out vec3 scale ) {
  vec4 texel = scrimFetch( scrimVertices, vertex * SCRIM_STRIDE );
  vec3 transformed = texel.xyz;
  scale = vec3( 1.0 );
  #ifdef USE_MORPHTARGETS
    int index = int( texel.w );
    #ifdef USE_INSTANCING_MORPH
      float morphTargetInfluences[ MORPHTARGETS_COUNT ];
      float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
      for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) morphTargetInfluences[ i ] = texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
    #endif
    transformed *= morphTargetBaseInfluence;
    for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
      if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( index, i, 0 ).xyz * morphTargetInfluences[ i ];
    }
  #endif
  #ifdef USE_SKINNING
    vec4 bones = scrimFetch( scrimVertices, vertex * SCRIM_STRIDE + 1 );
    vec4 weights = scrimFetch( scrimVertices, vertex * SCRIM_STRIDE + 2 );
    vec4 bound = bindMatrix * vec4( transformed, 1.0 );
    vec4 skinned = vec4( 0.0 );
    float boneScale = 0.0;
    for ( int i = 0; i < 4; i ++ ) {
      mat4 bone = getBoneMatrix( bones[ i ] );
      skinned += bone * bound * weights[ i ];
      boneScale += length( bone[ 0 ].xyz ) * weights[ i ];
    }
    transformed = ( bindMatrixInverse * skinned ).xyz;
    scale = scrimScale( mat3( bindMatrix ) ) * length( bindMatrixInverse[ 0 ].xyz ) * boneScale;
  #endif
  return transformed;
}

void main() {
  int segment = gl_VertexID / 4;
  bool isEnd = gl_VertexID % 4 > 1;
  float side = gl_VertexID % 2 == 0 ? - 1.0 : 1.0;
  vec4 corners = scrimFetch( scrimSegments, segment * 3 );
  vec4 span = scrimFetch( scrimSegments, segment * 3 + 1 );
  vec4 shape = scrimFetch( scrimSegments, segment * 3 + 2 );
  bool isBorder = corners.w < 0.0;

  mat4 worldFromVertex = modelMatrix;
  #ifdef USE_INSTANCING
    worldFromVertex = modelMatrix * instanceMatrix;
  #endif
  vec3 scale;
  vec3 unused;
  vec3 a = ( worldFromVertex * vec4( scrimPosed( int( corners.x ), scale ), 1.0 ) ).xyz;
  vec3 b = ( worldFromVertex * vec4( scrimPosed( int( corners.y ), unused ), 1.0 ) ).xyz;
  vec3 c = ( worldFromVertex * vec4( scrimPosed( int( corners.z ), unused ), 1.0 ) ).xyz;
  vec3 d = isBorder ? c : ( worldFromVertex * vec4( scrimPosed( int( corners.w ), unused ), 1.0 ) ).xyz;
  scale *= scrimScale( mat3( worldFromVertex ) );

  // A reflecting matrix turns faces around.
  float facing = SCRIM_FACING * ( determinant( mat3( worldFromVertex ) ) < 0.0 ? - 1.0 : 1.0 );
  vec3 normal = facing * cross( b - a, c - a );
  vec3 other = isBorder ? normal : facing * cross( d - a, b - a );
  bool isFront = dot( normal, cameraPosition - a ) > 0.0;
  bool isOtherFront = dot( other, cameraPosition - a ) > 0.0;
  bool isConcave = ! isBorder && dot( normal, d - a ) > 0.0;

  a_Vertex vertex;
  float t = isEnd ? span.y : span.x;
  vertex.position = mix( a, b, t );
  vec3 sum = normalize( normal + vec3( 1e-20 ) ) + normalize( other + vec3( 1e-20 ) );
  vertex.normal = dot( sum, sum ) > 1e-6 ? normalize( sum ) : vec3( 0.0, 0.0, 1.0 );
  vertex.uv = vec2( 0.0 );
  vertex.color = vec4( 1.0 );
  vec3 restA = scrimFetch( scrimVertices, int( corners.x ) * SCRIM_STRIDE ).xyz;
  vec3 restB = scrimFetch( scrimVertices, int( corners.y ) * SCRIM_STRIDE ).xyz;
  vertex.rest = mix( restA, restB, t ) * scale;
  vertex.contour = isBorder || isFront != isOtherFront;
  vertex.crease = shape.x;
  vertex.widthPx = 1.0;
  vertex.endPx = 0.0;
  float unitM = ( scale.x + scale.y + scale.z ) / 3.0;
  vertex.roomM = ( isEnd ? shape.w : shape.z ) * unitM;

  vec3 along = ( b - a ) * sign( span.y - span.x );
  vec3 across = cross( along, cameraPosition - vertex.position );
  float acrossLength = length( across );
  bool isHidden = acrossLength <= 1e-6 * dot( along, along ) || ( vertex.contour && isConcave );
  #ifndef SCRIM_TWO_SIDED
    // The surface is not drawn there.
    isHidden = isHidden || ! ( isFront || isOtherFront );
  #endif
  across = isHidden ? vec3( 0.0 ) : across / acrossLength;
  along = isHidden ? vec3( 0.0 ) : normalize( along );
  // Away from the object, as seen.
  float outside = dot( across, c - a ) > 0.0 ? - 1.0 : 1.0;
  vertex.outward = vertex.contour ? across * outside : vertex.normal;
  scrim_uv = a_VIEW_UV( vertex.position );
  a_vertex( vertex );

  float pixelM = a_PIXEL_M( vertex.position );
  float halfM = 0.5 * vertex.widthPx * pixelM;
  // Half a width closes the gaps between segments.
  bool isStrokeEnd = shape.y > 0.0 && ( isEnd ? span.w >= shape.y * 0.9999 : span.z <= 0.0 );
  float beyondM = halfM + ( isStrokeEnd ? vertex.endPx * pixelM : 0.0 );
  vec3 position = vertex.position + across * ( halfM * ( side + ( vertex.contour ? outside : 0.0 ) ) ) + along * ( isEnd ? beyondM : - beyondM );
  // A line over its own surface must be in front of it, even where that is seen aslant.
  position += normalize( cameraPosition - position ) * ( 3.0 * halfM + pixelM );

  vTechniquePosition = position;
  vTechniqueNormal = vertex.normal;
  vTechniqueUv = vertex.uv;
  vTechniqueColor = vertex.color;
  vTechniqueRest = vertex.rest;
  vTechniqueRestNormal = normalize( cross( restB - restA, scrimFetch( scrimVertices, int( corners.z ) * SCRIM_STRIDE ).xyz - restA ) + vec3( 1e-20 ) );
  vTechniqueLine = vec3( ( isEnd ? span.w : span.z ) * unitM + ( isEnd ? beyondM : - beyondM ), side, shape.y * unitM );
  vec4 worldPosition = vec4( position, 1.0 );
  vec4 mvPosition = viewMatrix * worldPosition;
  vec3 transformedNormal = mat3( viewMatrix ) * vertex.normal;
  gl_Position = isHidden || vertex.widthPx <= 0.0 ? vec4( 0.0, 0.0, 2.0, 1.0 ) : projectionMatrix * mvPosition;
  #include <shadowmap_vertex>
  ${environment.main}
}
`;
}
