import { type IUniform, Matrix3, type MeshPhysicalMaterial, ShaderChunk, type Texture } from 'three';
import { BEHIND_CHUNK } from '../glass/behind-chunk.ts';
import type { ShaderPatch } from './shader-patch.ts';

/** Makes a twin transmissive without three.js' own transmission pass. */
export interface GlassPatch extends ShaderPatch {
  /** Defines of the twin, from the master's maps. */
  defines(): Record<string, string>;
  /** Copies the master's values. */
  sync(): void;
}

const SAMPLE = 'return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );';
const LOGARITHM = '-log( attenuationColor )';

/**
 * Creates the patch of a transmissive material. three.js itself draws what is behind glass if `transmission` of a material is above 0, but
 * only opaque objects, without the layer under the scene. So twins have a `transmission` of 0, and this patch adds the same shading
 * (`transmission_fragment`, which follows KHR_materials_transmission, volume, ior and dispersion) with an image that `glass-scene.ts`
 * draws. Its alpha is the coverage, so glass over nothing is as transparent as its transmittance.
 *
 * @param behind Uniform with the image of what is behind glass; all glass shares it.
 */
export function createGlassPatch(master: MeshPhysicalMaterial, behind: IUniform): GlassPatch {
  const uniforms = {
    transmission: { value: 0 },
    thickness: { value: 0 },
    attenuationDistance: { value: Number.POSITIVE_INFINITY },
    attenuationColor: { value: master.attenuationColor },
    transmissionMap: { value: null as Texture | null },
    transmissionMapTransform: { value: new Matrix3() },
    thicknessMap: { value: null as Texture | null },
    thicknessMapTransform: { value: new Matrix3() },
  };
  return {
    key: 'glass',
    apply: (shader) => {
      const chunk = ShaderChunk.transmission_pars_fragment;
      if (!chunk.includes(SAMPLE) || !chunk.includes(LOGARITHM))
        throw new Error('three.js shades transmission in another way than expected.');
      const patched = chunk
        .replace(SAMPLE, 'return scrimBehindAt( fragCoord, lod );')
        .replace('float lod = log2( transmissionSamplerSize.x )', 'float lod = log2( float( textureSize( scrimBehind, 0 ).x ) )')
        // The logarithm of 0 times a thickness of 0 is no number.
        .replace(LOGARITHM, '-log( max( attenuationColor, vec3( 1e-6 ) ) )');
      shader.fragmentShader = shader.fragmentShader
        .replace('#include <transmission_pars_fragment>', `#ifdef USE_TRANSMISSION\n${BEHIND_CHUNK}\n#endif\n${patched}`)
        .replace('#include <opaque_fragment>', OPAQUE_FRAGMENT)
        .replace('#include <colorspace_fragment>', '#include <colorspace_fragment>\n\tgl_FragColor.rgb *= scrimOpacity;');
      Object.assign(shader.uniforms, uniforms, { scrimBehind: behind });
    },
    defines: () => ({
      USE_TRANSMISSION: '',
      ...mapDefines('TRANSMISSION', master.transmissionMap),
      ...mapDefines('THICKNESS', master.thicknessMap),
    }),
    sync: () => {
      uniforms.transmission.value = master.transmission;
      uniforms.thickness.value = master.thickness;
      uniforms.attenuationDistance.value = master.attenuationDistance;
      uniforms.transmissionMap.value = setTransform(uniforms.transmissionMapTransform.value, master.transmissionMap);
      uniforms.thicknessMap.value = setTransform(uniforms.thicknessMapTransform.value, master.thicknessMap);
    },
  };
}

/**
 * GLSL in place of three.js' `opaque_fragment`, with premultiplied output: what is seen through glass is not faded by the alpha of what is
 * behind it.
 */
const OPAQUE_FRAGMENT = /* glsl */ `
	#ifdef OPAQUE
		diffuseColor.a = 1.0;
	#endif
	float scrimOpacity = diffuseColor.a;
	#ifdef USE_TRANSMISSION
		diffuseColor.a *= material.transmissionAlpha;
	#endif
	gl_FragColor = vec4( outgoingLight, diffuseColor.a );
`;

function mapDefines(name: string, map: Texture | null): Record<string, string> {
  if (map === null) return {};
  const uv = map.channel === 0 ? 'uv' : `uv${map.channel}`;
  // Empty as in three.js, which may define it too.
  const attribute: Record<string, string> = map.channel === 0 ? {} : { [`USE_UV${map.channel}`]: '' };
  return { [`USE_${name}MAP`]: '', [`${name}MAP_UV`]: uv, ...attribute };
}

function setTransform(into: Matrix3, map: Texture | null): Texture | null {
  if (map?.matrixAutoUpdate) map.updateMatrix();
  if (map) into.copy(map.matrix);
  return map;
}
