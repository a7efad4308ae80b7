import type { Material } from 'three';
import { createDepthTwin } from './depth-twin.ts';
import { patchMaterial, type ShaderPatch, wrapMain } from './shader-patch.ts';
import type { Twin } from './twins.ts';

/** Replaces the depth that three.js writes as color. */
const WHITE: ShaderPatch = {
  key: 'white',
  apply: (shader) => {
    shader.fragmentShader = wrapMain(shader.fragmentShader, { before: '', start: '', end: 'gl_FragColor = vec4( 1.0 );' });
  },
};

/** Draws the shape of the master in white, faded at a soft border of the room. */
export function createMaskTwin(master: Material, occlusion: ShaderPatch | null): Twin {
  const twin = createDepthTwin(master, 'solid');
  const { material } = twin;
  material.colorWrite = true;
  material.polygonOffset = false;
  material.defines = { PREMULTIPLIED_OUTPUT: '' };
  patchMaterial(material, null, occlusion ? [WHITE, occlusion] : [WHITE]);
  return twin;
}
