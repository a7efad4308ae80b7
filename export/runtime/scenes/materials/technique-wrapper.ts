import { DIRECTION_FRAGMENT, DIRECTION_VARYINGS, DIRECTION_VERTEX, readsDirections } from './curvature/direction-parts.ts';
import { RADIAL_FRAGMENT, RADIAL_VARYING, RADIAL_VERTEX, readsRadial } from './curvature/radial-parts.ts';
import { environmentFragment, environmentVertex } from './technique-environment.ts';
import { FUNCTIONS, OF_BOTH, VARYINGS, VERTEX_FUNCTIONS, vertexHead } from './wrapper-parts.ts';

/**
 * The vertex shader of one pass of a technique. The GLSL around the technique's text defines the names of
 * `export/glsl/technique/interface.ts` by three.js' chunks, so that a technique supports what the object's own material does: skins, morph
 * targets, instances, lights and shadow maps.
 *
 * The author's text comes before the chunks, because their macros would affect it.
 *
 * @param text The technique's vertex stage.
 * @param fragment The technique's fragment stage.
 */
export function techniqueVertex(text: string, fragment: string, passIndex: number): string {
  const environment = environmentVertex(fragment);
  const directions = readsDirections(fragment);
  const radial = readsRadial(fragment);
  return /* glsl */ `
${vertexHead(text, passIndex)}
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
${VARYINGS}
${environment.pars}
${text.includes('.outward') ? 'attribute vec3 scrimHullNormal;' : '#define scrimHullNormal normal'}
${directions ? DIRECTION_VERTEX.declarations : ''}
${radial ? RADIAL_VERTEX.declarations : ''}

${VERTEX_FUNCTIONS}

void main() {
  #include <uv_vertex>
  #include <color_vertex>
  #include <morphinstance_vertex>
  #include <morphcolor_vertex>
  #include <beginnormal_vertex>
  #include <morphnormal_vertex>
  #include <skinbase_vertex>
  #include <skinnormal_vertex>
  #include <begin_vertex>
  #include <morphtarget_vertex>
  vec3 rest = position;
  vec3 outward = scrimHullNormal;
  vec3 restScale = vec3( 1.0 );
  #ifdef USE_SKINNING
    // Averaged lengths, because the sum of bone matrices that rotate differently would shrink.
    vec4 boneScales = vec4( length( boneMatX[ 0 ].xyz ), length( boneMatY[ 0 ].xyz ), length( boneMatZ[ 0 ].xyz ), length( boneMatW[ 0 ].xyz ) );
    restScale = scrimScale( mat3( bindMatrix ) ) * length( bindMatrixInverse[ 0 ].xyz ) * dot( skinWeight, boneScales );
    outward = mat3( skinMatrix ) * outward;
  #endif
  #include <skinning_vertex>
  mat4 worldFromVertex = modelMatrix;
  #ifdef USE_INSTANCING
    worldFromVertex = modelMatrix * instanceMatrix;
  #endif
  restScale *= scrimScale( mat3( worldFromVertex ) );
  a_Vertex vertex;
  vertex.position = ( worldFromVertex * vec4( transformed, 1.0 ) ).xyz;
  vertex.normal = transpose( inverse( mat3( worldFromVertex ) ) ) * objectNormal;
  vertex.normal = dot( vertex.normal, vertex.normal ) > 0.0 ? normalize( vertex.normal ) : vec3( 0.0, 0.0, 1.0 );
  #ifdef USE_MAP
    vertex.uv = vMapUv;
  #else
    vertex.uv = uv;
  #endif
  vertex.color = vec4( 1.0 );
  #if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR )
    vertex.color = vColor;
  #endif
  vertex.rest = rest * restScale;
  // Keeps the length in rest position: only the direction is transformed.
  vec3 hullNormalWorld = transpose( inverse( mat3( worldFromVertex ) ) ) * outward;
  float hullNormalLength = length( hullNormalWorld );
  vertex.outward = hullNormalLength > 0.0 ? hullNormalWorld * ( length( scrimHullNormal ) / hullNormalLength ) : vertex.normal;
  vertex.contour = false;
  vertex.crease = 0.0;
  vertex.widthPx = 0.0;
  vertex.endPx = 0.0;
  vertex.roomM = 0.0;
  scrim_uv = a_VIEW_UV( vertex.position );
  a_vertex( vertex );
  vTechniquePosition = vertex.position;
  vTechniqueNormal = vertex.normal;
  vTechniqueUv = vertex.uv;
  vTechniqueColor = vertex.color;
  vTechniqueRest = vertex.rest;
  vTechniqueRestNormal = normal / restScale;
  ${directions ? DIRECTION_VERTEX.main : ''}
  ${radial ? RADIAL_VERTEX.main : ''}
  vec4 worldPosition = vec4( vertex.position, 1.0 );
  vec4 mvPosition = viewMatrix * worldPosition;
  vec3 transformedNormal = mat3( viewMatrix ) * vertex.normal;
  gl_Position = projectionMatrix * mvPosition;
  #include <shadowmap_vertex>
  ${environment.main}
}
`;
}

/** Whether the text of a technique reads what is behind its object. */
export function showsBehind(text: string): boolean {
  return text.includes('a_BEHIND(');
}

/** The fragment shader of one pass of a technique. `behind` is the GLSL of `BEHIND`, which is added if the text calls it. */
export function techniqueFragment(text: string, passIndex: number, behind: string): string {
  const directions = readsDirections(text);
  const radial = readsRadial(text);
  return /* glsl */ `
vec3 scrimAmbient();
#define a_EYE cameraPosition
#define a_AMBIENT scrimAmbient()
#define a_PASSINDEX ${passIndex}
#define a_LIGHT_COUNT ( NUM_POINT_LIGHTS + NUM_SPOT_LIGHTS + NUM_DIR_LIGHTS )
uniform mat4 projectionMatrix;
${OF_BOTH}
${text}
${FUNCTIONS}
#include <common>
#include <packing>
#include <color_pars_fragment>
#include <map_pars_fragment>
#include <alphatest_pars_fragment>
#include <lights_pars_begin>
#include <shadowmap_pars_fragment>
${VARYINGS}
#ifdef SCRIM_EDGES
varying vec3 vTechniqueLine;
#endif
// Linear, with the opacity as alpha.
uniform vec4 scrimColor;
${directions ? DIRECTION_VARYINGS : ''}
${radial ? RADIAL_VARYING : ''}
${environmentFragment(text)}
${showsBehind(text) ? behind : ''}
a_Light scrimLights[ NUM_POINT_LIGHTS + NUM_SPOT_LIGHTS + NUM_DIR_LIGHTS + 1 ];

a_Light a_LIGHT( const in int index ) {
  return scrimLights[ clamp( index, 0, a_LIGHT_COUNT ) ];
}

a_Light scrimLight( const in IncidentLight light, const in float lit ) {
  return a_Light( inverseTransformDirection( light.direction, viewMatrix ), light.color, lit );
}

// Iterates over lights as lights_fragment_begin of three.js does, but keeps shadow and light separate.
void scrimGatherLights() {
  vec3 positionView = ( viewMatrix * vec4( vTechniquePosition, 1.0 ) ).xyz;
  IncidentLight light;
  float lit;
  int count = 0;
  #if NUM_POINT_LIGHTS > 0
  #pragma unroll_loop_start
  for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
    getPointLightInfo( pointLights[ i ], positionView, light );
    lit = 1.0;
    #if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS )
    if ( receiveShadow ) lit = getPointShadow( pointShadowMap[ i ], pointLightShadows[ i ].shadowMapSize, pointLightShadows[ i ].shadowIntensity, pointLightShadows[ i ].shadowBias, pointLightShadows[ i ].shadowRadius, vPointShadowCoord[ i ], pointLightShadows[ i ].shadowCameraNear, pointLightShadows[ i ].shadowCameraFar ) * SCRIM_POINT_VEIL( scrimPointTranslucent[ i ], vPointShadowCoord[ i ] );
    #endif
    scrimLights[ count ++ ] = scrimLight( light, lit );
  }
  #pragma unroll_loop_end
  #endif
  #if NUM_SPOT_LIGHTS > 0
  #pragma unroll_loop_start
  for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
    getSpotLightInfo( spotLights[ i ], positionView, light );
    lit = 1.0;
    #if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
    if ( receiveShadow ) lit = getShadow( spotShadowMap[ i ], spotLightShadows[ i ].shadowMapSize, spotLightShadows[ i ].shadowIntensity, spotLightShadows[ i ].shadowBias, spotLightShadows[ i ].shadowRadius, vSpotLightCoord[ i ] ) * SCRIM_VEIL( scrimSpotTranslucent[ i ], vSpotLightCoord[ i ], 0.0 );
    #endif
    scrimLights[ count ++ ] = scrimLight( light, lit );
  }
  #pragma unroll_loop_end
  #endif
  #if NUM_DIR_LIGHTS > 0
  #pragma unroll_loop_start
  for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
    getDirectionalLightInfo( directionalLights[ i ], light );
    lit = 1.0;
    #if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
    if ( receiveShadow ) lit = getShadow( directionalShadowMap[ i ], directionalLightShadows[ i ].shadowMapSize, directionalLightShadows[ i ].shadowIntensity, directionalLightShadows[ i ].shadowBias, directionalLightShadows[ i ].shadowRadius, vDirectionalShadowCoord[ i ] ) * SCRIM_VEIL( scrimDirTranslucent[ i ], vDirectionalShadowCoord[ i ], scrimDirFar[ i ] );
    #endif
    scrimLights[ count ++ ] = scrimLight( light, lit );
  }
  #pragma unroll_loop_end
  #endif
}

void main() {
  vec4 diffuseColor = scrimColor * vTechniqueColor;
  #ifdef USE_MAP
    diffuseColor *= texture2D( map, vTechniqueUv );
  #endif
  #include <alphatest_fragment>
  #ifdef OPAQUE
    diffuseColor.a = 1.0;
  #endif
  scrimGatherLights();
  a_Surface surface;
  surface.line = vec3( 0.0 );
  surface.position = vTechniquePosition;
  #ifdef SCRIM_EDGES
    surface.normal = normalize( vTechniqueNormal );
  #elif defined( FLAT_SHADED )
    surface.normal = normalize( cross( dFdx( vTechniquePosition ), dFdy( vTechniquePosition ) ) );
  #else
    surface.normal = normalize( vTechniqueNormal ) * ( gl_FrontFacing ? 1.0 : - 1.0 );
  #endif
  scrimNormal = surface.normal;
  surface.towardsEye = normalize( cameraPosition - vTechniquePosition );
  surface.uv = vTechniqueUv;
  surface.color = diffuseColor;
  surface.front = gl_FrontFacing;
  surface.rest = vTechniqueRest;
  #ifdef SCRIM_EDGES
    surface.line = vTechniqueLine;
    surface.restNormal = vTechniqueRestNormal;
  #elif defined( FLAT_SHADED )
    surface.restNormal = normalize( cross( dFdx( vTechniqueRest ), dFdy( vTechniqueRest ) ) );
  #else
    surface.restNormal = normalize( vTechniqueRestNormal );
  #endif
  ${directions ? DIRECTION_FRAGMENT : ''}
  ${radial ? RADIAL_FRAGMENT : ''}
  scrim_uv = a_VIEW_UV( vTechniquePosition );
  gl_FragColor = clamp( a_surface( surface ), 0.0, 1.0 );
  if ( scrim_discarded ) discard;
  #include <colorspace_fragment>
  gl_FragColor.rgb *= gl_FragColor.a;
}
`;
}
