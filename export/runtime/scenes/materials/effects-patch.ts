import { ExternalTexture } from 'three';
import type { MaterialEffects } from '../../scene-backend.ts';
import { type ShaderPatch, wrapMain } from './shader-patch.ts';

/** Creates the patch for effects that materials compute at their end: after occlusion and encoding, as passes over the layer would. */
export function createEffectsPatch({ text, uniforms, textures }: MaterialEffects): ShaderPatch {
  const images = Object.entries(textures).map(([name, texture]) => [name, { value: new ExternalTexture(texture) }] as const);
  const values = { ...uniforms, ...Object.fromEntries(images) };
  return {
    key: `effects ${text}`,
    apply: (shader) => {
      Object.assign(shader.uniforms, values);
      const wrapped = wrapMain(shader.fragmentShader, { before: '', start: '', end: 'gl_FragColor = scrimEffects( gl_FragColor );' });
      // Macros of three.js' chunks must not affect the text of authors.
      shader.fragmentShader = `${text}\n${wrapped}`;
    },
  };
}
