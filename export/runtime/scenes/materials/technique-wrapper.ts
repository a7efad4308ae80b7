/**
 * What stands around the text of a technique. It defines the names of `export/glsl/technique/interface.ts`, so that whatever
 * draws the object's own material draws a technique too: skins, morph targets, instances, three's lights and shadow maps.
 *
 * The author's text comes before three's chunks, whose macros would otherwise reach into it.
 */
export function techniqueVertex(text: string, passIndex: number): string {
  return /* glsl */ `
#define a_EYE cameraPosition
#define a_PASSINDEX ${passIndex}
${WITHOUT_LIGHTS}
${text}
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
varying vec3 vTechniquePosition;
varying vec3 vTechniqueNormal;
varying vec2 vTechniqueUv;
varying vec4 vTechniqueColor;

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
  #include <skinning_vertex>
  mat4 worldFromVertex = modelMatrix;
  #ifdef USE_INSTANCING
    worldFromVertex = modelMatrix * instanceMatrix;
  #endif
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
  a_vertex( vertex );
  vTechniquePosition = vertex.position;
  vTechniqueNormal = vertex.normal;
  vTechniqueUv = vertex.uv;
  vTechniqueColor = vertex.color;
  vec4 worldPosition = vec4( vertex.position, 1.0 );
  vec4 mvPosition = viewMatrix * worldPosition;
  vec3 transformedNormal = mat3( viewMatrix ) * vertex.normal;
  gl_Position = projectionMatrix * mvPosition;
  #include <shadowmap_vertex>
}
`;
}

/** There are none while vertices are placed, and the linker lets nobody ask. */
const WITHOUT_LIGHTS = `#define a_AMBIENT vec3( 0.0 )
#define a_LIGHT_COUNT 0`;

export function techniqueFragment(text: string, passIndex: number): string {
  return /* glsl */ `
uniform vec3 scrimAmbient;
#define a_EYE cameraPosition
#define a_AMBIENT scrimAmbient
#define a_PASSINDEX ${passIndex}
#define a_LIGHT_COUNT ( NUM_POINT_LIGHTS + NUM_SPOT_LIGHTS + NUM_DIR_LIGHTS )
${text}
#include <common>
#include <packing>
#include <color_pars_fragment>
#include <map_pars_fragment>
#include <alphatest_pars_fragment>
#include <lights_pars_begin>
#include <shadowmap_pars_fragment>
varying vec3 vTechniquePosition;
varying vec3 vTechniqueNormal;
varying vec2 vTechniqueUv;
varying vec4 vTechniqueColor;
// Linear, with the opacity as alpha.
uniform vec4 scrimColor;

a_Light scrimLights[ NUM_POINT_LIGHTS + NUM_SPOT_LIGHTS + NUM_DIR_LIGHTS + 1 ];

a_Light a_LIGHT( const in int index ) {
  return scrimLights[ clamp( index, 0, a_LIGHT_COUNT ) ];
}

a_Light scrimLight( const in IncidentLight light, const in float lit ) {
  return a_Light( inverseTransformDirection( light.direction, viewMatrix ), light.color, lit );
}

// As lights_fragment_begin of three.js goes through them, with the shadow kept apart from the light.
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
    if ( receiveShadow ) lit = getPointShadow( pointShadowMap[ i ], pointLightShadows[ i ].shadowMapSize, pointLightShadows[ i ].shadowIntensity, pointLightShadows[ i ].shadowBias, pointLightShadows[ i ].shadowRadius, vPointShadowCoord[ i ], pointLightShadows[ i ].shadowCameraNear, pointLightShadows[ i ].shadowCameraFar );
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
    if ( receiveShadow ) lit = getShadow( spotShadowMap[ i ], spotLightShadows[ i ].shadowMapSize, spotLightShadows[ i ].shadowIntensity, spotLightShadows[ i ].shadowBias, spotLightShadows[ i ].shadowRadius, vSpotLightCoord[ i ] );
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
    if ( receiveShadow ) lit = getShadow( directionalShadowMap[ i ], directionalLightShadows[ i ].shadowMapSize, directionalLightShadows[ i ].shadowIntensity, directionalLightShadows[ i ].shadowBias, directionalLightShadows[ i ].shadowRadius, vDirectionalShadowCoord[ i ] );
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
  surface.position = vTechniquePosition;
  #ifdef FLAT_SHADED
    surface.normal = normalize( cross( dFdx( vTechniquePosition ), dFdy( vTechniquePosition ) ) );
  #else
    surface.normal = normalize( vTechniqueNormal ) * ( gl_FrontFacing ? 1.0 : - 1.0 );
  #endif
  surface.towardsEye = normalize( cameraPosition - vTechniquePosition );
  surface.uv = vTechniqueUv;
  surface.color = diffuseColor;
  surface.front = gl_FrontFacing;
  gl_FragColor = clamp( a_surface( surface ), 0.0, 1.0 );
  if ( scrim_discarded ) discard;
  #include <colorspace_fragment>
  gl_FragColor.rgb *= gl_FragColor.a;
}
`;
}
