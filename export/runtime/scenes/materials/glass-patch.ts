import { ShaderChunk, type Texture } from 'three';
import type { ShaderPatch } from './shader-patch.ts';

/**
 * Makes the layer's background visible through transmissive materials.
 *
 * three.js renders what is behind glass to a buffer that it clears to half-covered white (`renderTransmissionPass`), so that glass over
 * nothing becomes a white haze. The content of the buffer is opaque, so the alpha of a sample tells how much of it is clear color: with
 * coverage k, alpha = k + (1 - k) / 2 and color = k · content + (1 - k) · white. Subtracting the white gives premultiplied content with
 * coverage k; glass over nothing is then as transparent as its transmittance.
 */
export function createGlassPatch(): ShaderPatch & { dispose(): void } {
  const chunk = ShaderChunk.transmission_pars_fragment;
  const sample = 'return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );';
  const uniforms: { value?: Texture | null }[] = [];
  return {
    key: 'glass',
    apply: (shader) => {
      if (!chunk.includes(sample)) throw new Error('three.js samples transmission in another way than expected.');
      const patched = chunk.replace(
        sample,
        `vec4 behind = textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
		float coverage = clamp( 2.0 * behind.a - 1.0, 0.0, 1.0 );
		return vec4( max( behind.rgb - ( 1.0 - coverage ), 0.0 ), coverage );`,
      );
      shader.fragmentShader = shader.fragmentShader.replace('#include <transmission_pars_fragment>', patched);
      if (shader.uniforms.transmissionSamplerMap) uniforms.push(shader.uniforms.transmissionSamplerMap);
    },
    // three.js creates the buffer per scene and never disposes it; it is reachable only by the uniform.
    dispose: () => {
      for (const uniform of uniforms) uniform.value?.renderTarget?.dispose();
      uniforms.length = 0;
    },
  };
}
