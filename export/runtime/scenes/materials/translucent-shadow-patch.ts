import { type IUniform, type Material, ShaderChunk, type Texture } from 'three';
import { BEHIND_TRANSLUCENT } from '../lights/translucent-shadow.ts';
import type { ShaderPatch } from './shader-patch.ts';

/** Multiplies the shadows of three.js' materials by the translucent shadow maps of their lights. */
export interface TranslucentShadowPatch extends ShaderPatch {
  /** Registers a material. It is recompiled whenever the lights get or lose translucent shadow maps. */
  attach(material: Material): void;
  detach(material: Material): void;
  /**
   * Sets the translucent shadow maps of the lights with a shadow, by kind and in the order of three.js; null for a light without one.
   * `directionalFarM` is the distance at depth 1 of directional lights. `fits` says whether there are enough texture units; without, no
   * light is dimmed.
   */
  bind(
    directional: readonly (Texture | null)[],
    directionalFarM: readonly number[],
    spot: readonly (Texture | null)[],
    point: readonly (Texture | null)[],
    fits: boolean,
  ): void;
}

const DEFINE = 'SCRIM_VEILS';

/**
 * GLSL that reads the translucent shadow maps of lights with a shadow, if the define is set. It averages nine texels, as wide as the edge
 * of a shadow; receivers in front of the nearest transparent caster are not dimmed.
 */
export const TRANSLUCENT_SHADOW_PARS = /* glsl */ `
#ifdef ${DEFINE}
  #if NUM_DIR_LIGHT_SHADOWS > 0
    uniform sampler2D scrimDirTranslucent[ NUM_DIR_LIGHT_SHADOWS ];
    // Meters at depth 1.
    uniform float scrimDirFar[ NUM_DIR_LIGHT_SHADOWS ];
  #endif
  #if NUM_SPOT_LIGHT_SHADOWS > 0
    uniform sampler2D scrimSpotTranslucent[ NUM_SPOT_LIGHT_SHADOWS ];
  #endif
  #if NUM_POINT_LIGHT_SHADOWS > 0
    uniform samplerCube scrimPointTranslucent[ NUM_POINT_LIGHT_SHADOWS ];
  #endif
${BEHIND_TRANSLUCENT}
  // far: 0 for a spot or point light, whose w is in meters.
  float scrimTranslucent( const in sampler2D translucent, const in vec4 coord, const in float far ) {
    vec3 at = coord.xyz / coord.w;
    if ( coord.w <= 0.0 || any( greaterThan( abs( at.xy - 0.5 ), vec2( 0.5 ) ) ) ) return 1.0;
    float meters = far > 0.0 ? at.z * far : coord.w;
    vec2 texel = 1.0 / vec2( textureSize( translucent, 0 ) );
    float through = 0.0;
    for ( int y = -1; y <= 1; y ++ ) {
      for ( int x = -1; x <= 1; x ++ ) {
        vec4 v = textureLod( translucent, at.xy + vec2( x, y ) * texel, 0.0 );
        through += isBehindTranslucent( meters, v.a ) ? v.r : 1.0;
      }
    }
    return through / 9.0;
  }
  float scrimPointTranslucentAt( const in samplerCube translucent, const in vec4 coord ) {
    vec3 size = abs( coord.xyz );
    vec4 v = textureLod( translucent, coord.xyz, 0.0 );
    return isBehindTranslucent( max( max( size.x, size.y ), size.z ), v.a ) ? v.r : 1.0;
  }
  #define SCRIM_VEIL( translucent, coord, far ) scrimTranslucent( translucent, coord, far )
  #define SCRIM_POINT_VEIL( translucent, coord ) scrimPointTranslucentAt( translucent, coord )
#else
  #define SCRIM_VEIL( translucent, coord, far ) 1.0
  #define SCRIM_POINT_VEIL( translucent, coord ) 1.0
#endif
`;

/**
 * Texts in three.js' shader that read shadows, each with the factor by which to multiply the result. Pages leave out those of kinds of light
 * that they do not have.
 */
const ADDED = [
  ['vDirectionalShadowCoord[ i ] ) : 1.0', 'SCRIM_VEIL( scrimDirTranslucent[ i ], vDirectionalShadowCoord[ i ], scrimDirFar[ i ] )'],
  ['vSpotLightCoord[ i ] ) : 1.0', 'SCRIM_VEIL( scrimSpotTranslucent[ i ], vSpotLightCoord[ i ], 0.0 )'],
  ['pointLightShadow.shadowCameraFar ) : 1.0', 'SCRIM_POINT_VEIL( scrimPointTranslucent[ i ], vPointShadowCoord[ i ] )'],
] as const;

function dimmedLights(): string {
  let chunk = ShaderChunk.lights_fragment_begin;
  const count = (chunk.match(/get(Point)?Shadow\(/g) ?? []).length;
  if (ADDED.filter(([found]) => chunk.split(found).length === 2).length !== count) {
    throw new Error('three.js looks shadows up in another way than expected.');
  }
  for (const [found, translucent] of ADDED) {
    chunk = chunk.replace(found, found.replace(' : ', ` * ${translucent} : `));
  }
  return chunk;
}

export function createTranslucentShadowPatch(): TranslucentShadowPatch {
  const materials = new Set<Material>();
  const translucentShadows = {
    scrimDirTranslucent: list(),
    scrimSpotTranslucent: list(),
    scrimPointTranslucent: list(),
    scrimDirFar: { value: [] as readonly number[] },
  };
  let active = false;

  function mark(material: Material): void {
    material.defines ??= {};
    if (active) material.defines[DEFINE] = '';
    else delete material.defines[DEFINE];
    material.needsUpdate = true;
  }

  return {
    key: 'translucentShadows',
    apply: (shader) => {
      Object.assign(shader.uniforms, translucentShadows);
      const lights = '#include <lights_fragment_begin>';
      const pars = '#include <shadowmap_pars_fragment>';
      shader.fragmentShader = shader.fragmentShader.replace(lights, dimmedLights()).replace(pars, `${pars}\n${TRANSLUCENT_SHADOW_PARS}`);
    },
    attach: (material) => {
      materials.add(material);
      if (active) mark(material);
    },
    detach: (material) => void materials.delete(material),
    bind: (directional, directionalFarM, spot, point, fits) => {
      const next = fits && (hasAny(directional) || hasAny(spot) || hasAny(point));
      translucentShadows.scrimDirTranslucent.value = directional;
      translucentShadows.scrimDirFar.value = directionalFarM;
      translucentShadows.scrimSpotTranslucent.value = spot;
      translucentShadows.scrimPointTranslucent.value = point;
      if (next === active) return;
      active = next;
      for (const material of materials) mark(material);
    },
  };
}

function list(): IUniform<readonly (Texture | null)[]> {
  return { value: [] };
}

function hasAny(textures: readonly (Texture | null)[]): boolean {
  for (let i = 0; i < textures.length; i++) if (textures[i] !== null) return true;
  return false;
}
