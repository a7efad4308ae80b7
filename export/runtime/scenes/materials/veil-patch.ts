import { type IUniform, type Material, ShaderChunk, type Texture } from 'three';
import { BEHIND_VEIL } from '../lights/veil.ts';
import type { ShaderPatch } from './shader-patch.ts';

/** Lets three's own materials be dimmed by what is see-through, beside its shadows. */
export interface VeilPatch extends ShaderPatch {
  /** From now on the material is compiled as the lights need it. */
  attach(material: Material): void;
  detach(material: Material): void;
  /**
   * Of lights with a shadow, by kind and in three's order; a null dims nothing. `directionalFarM`: where their depth is 1. `fits`:
   * whether there are texture units for them.
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
 * Functions and textures for lights with a shadow, where the define is set. Nine texels, as wide as the edge of a shadow; what lies
 * before the nearest that dims is not dimmed.
 */
export const VEIL_PARS = /* glsl */ `
#ifdef ${DEFINE}
  #if NUM_DIR_LIGHT_SHADOWS > 0
    uniform sampler2D scrimDirVeils[ NUM_DIR_LIGHT_SHADOWS ];
    // Metres at which depth is 1.
    uniform float scrimDirFar[ NUM_DIR_LIGHT_SHADOWS ];
  #endif
  #if NUM_SPOT_LIGHT_SHADOWS > 0
    uniform sampler2D scrimSpotVeils[ NUM_SPOT_LIGHT_SHADOWS ];
  #endif
  #if NUM_POINT_LIGHT_SHADOWS > 0
    uniform samplerCube scrimPointVeils[ NUM_POINT_LIGHT_SHADOWS ];
  #endif
${BEHIND_VEIL}
  // far: 0 for a lamp with a place, whose w is metres.
  float scrimVeil( const in sampler2D veil, const in vec4 coord, const in float far ) {
    vec3 at = coord.xyz / coord.w;
    if ( coord.w <= 0.0 || any( greaterThan( abs( at.xy - 0.5 ), vec2( 0.5 ) ) ) ) return 1.0;
    float metres = far > 0.0 ? at.z * far : coord.w;
    vec2 texel = 1.0 / vec2( textureSize( veil, 0 ) );
    float through = 0.0;
    for ( int y = -1; y <= 1; y ++ ) {
      for ( int x = -1; x <= 1; x ++ ) {
        vec4 v = textureLod( veil, at.xy + vec2( x, y ) * texel, 0.0 );
        through += behindVeil( metres, v.a ) ? v.r : 1.0;
      }
    }
    return through / 9.0;
  }
  float scrimPointVeil( const in samplerCube veil, const in vec4 coord ) {
    vec3 size = abs( coord.xyz );
    vec4 v = textureLod( veil, coord.xyz, 0.0 );
    return behindVeil( max( max( size.x, size.y ), size.z ), v.a ) ? v.r : 1.0;
  }
  #define SCRIM_VEIL( veil, coord, far ) scrimVeil( veil, coord, far )
  #define SCRIM_POINT_VEIL( veil, coord ) scrimPointVeil( veil, coord )
#else
  #define SCRIM_VEIL( veil, coord, far ) 1.0
  #define SCRIM_POINT_VEIL( veil, coord ) 1.0
#endif
`;

/** What three writes where it looks shadows up, and what that is multiplied by. */
const ADDED = [
  ['vDirectionalShadowCoord[ i ] ) : 1.0', 'SCRIM_VEIL( scrimDirVeils[ i ], vDirectionalShadowCoord[ i ], scrimDirFar[ i ] )'],
  ['vSpotLightCoord[ i ] ) : 1.0', 'SCRIM_VEIL( scrimSpotVeils[ i ], vSpotLightCoord[ i ], 0.0 )'],
  ['pointLightShadow.shadowCameraFar ) : 1.0', 'SCRIM_POINT_VEIL( scrimPointVeils[ i ], vPointShadowCoord[ i ] )'],
] as const;

function veiledLights(): string {
  let chunk = ShaderChunk.lights_fragment_begin;
  for (const [found, veil] of ADDED) {
    if (chunk.split(found).length !== 2) throw new Error('three.js looks shadows up in another way than expected.');
    chunk = chunk.replace(found, found.replace(' : ', ` * ${veil} : `));
  }
  return chunk;
}

export function createVeilPatch(): VeilPatch {
  const materials = new Set<Material>();
  const veils = { scrimDirVeils: list(), scrimSpotVeils: list(), scrimPointVeils: list(), scrimDirFar: { value: [] as readonly number[] } };
  let active = false;

  function mark(material: Material): void {
    material.defines ??= {};
    if (active) material.defines[DEFINE] = '';
    else delete material.defines[DEFINE];
    material.needsUpdate = true;
  }

  return {
    key: 'veils',
    apply: (shader) => {
      Object.assign(shader.uniforms, veils);
      const lights = '#include <lights_fragment_begin>';
      const pars = '#include <shadowmap_pars_fragment>';
      shader.fragmentShader = shader.fragmentShader.replace(lights, veiledLights()).replace(pars, `${pars}\n${VEIL_PARS}`);
    },
    attach: (material) => {
      materials.add(material);
      if (active) mark(material);
    },
    detach: (material) => void materials.delete(material),
    bind: (directional, directionalFarM, spot, point, fits) => {
      const next = fits && (hasAny(directional) || hasAny(spot) || hasAny(point));
      veils.scrimDirVeils.value = directional;
      veils.scrimDirFar.value = directionalFarM;
      veils.scrimSpotVeils.value = spot;
      veils.scrimPointVeils.value = point;
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
