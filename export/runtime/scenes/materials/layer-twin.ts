import type { BackSide, FrontSide, Material } from 'three';
import type { LayerEncoding } from '../../../../nodes/kit/definition.ts';
import { follow } from './follow.ts';
import { createGlassPatch } from './glass-patch.ts';
import { applyLayerBlending } from './layer-blending.ts';
import { patchMaterial, type ShaderPatch, wrapMain } from './shader-patch.ts';
import { createShadowOffsetPatch } from './shadow-offset-patch.ts';
import type { TranslucentShadowPatch } from './translucent-shadow-patch.ts';
import type { Twin } from './twins.ts';

/**
 * Keeps scene layers free of NaN and infinity, which spread with each blur. Normals of zero length and extreme roughness give them; a
 * display layer turns them into black or white by itself. Bits are compared, because drivers optimize `isnan` away.
 */
const FINITE = {
  before: /* glsl */ `
float scrimFinite( float x ) {
  return ( floatBitsToUint( x ) & 0x7FFFFFFFu ) > 0x7F800000u ? 0.0 : clamp( x, - 65504.0, 65504.0 );
}`,
  start: '',
  end: 'gl_FragColor = vec4( scrimFinite( gl_FragColor.r ), scrimFinite( gl_FragColor.g ), scrimFinite( gl_FragColor.b ), clamp( scrimFinite( gl_FragColor.a ), 0.0, 1.0 ) );',
};

const FINITE_PATCH: ShaderPatch = {
  key: 'finite',
  apply: (shader) => {
    shader.fragmentShader = wrapMain(shader.fragmentShader, FINITE);
  },
};

export interface LayerTwinOptions {
  /** Draws only this side of a double-sided master. */
  readonly side: typeof BackSide | typeof FrontSide | null;
  /** Encoding of the layer. */
  readonly encoding: LayerEncoding;
  /** Fades fragments behind the room; null without occlusion. */
  readonly occlusion: ShaderPatch | null;
  readonly translucentShadows: TranslucentShadowPatch;
  /** Called when the master needs to be drawn differently, such as after it became transparent. */
  readonly onChange: () => void;
}

/** The material that draws the master into a layer: its own shading with premultiplied output (see `layer-blending.ts`). */
export function createLayerTwin(master: Material, options: LayerTwinOptions): Twin {
  const material = master.clone();
  const glass = 'isMeshPhysicalMaterial' in master ? createGlassPatch() : null;
  const fades = options.occlusion !== null;
  patchMaterial(
    material,
    master,
    [
      createShadowOffsetPatch(),
      options.translucentShadows,
      glass,
      options.occlusion,
      options.encoding === 'scene' ? FINITE_PATCH : null,
    ].filter((patch) => patch !== null),
  );
  options.translucentShadows.attach(material);
  const sync = follow(material, master, options.side === null ? [] : ['side']);
  if (options.side !== null) material.side = options.side;
  applyLayerBlending(material, master, fades);
  return {
    material,
    sync: () => {
      if (!sync()) return;
      applyLayerBlending(material, master, fades);
      options.onChange();
    },
    dispose: () => {
      options.translucentShadows.detach(material);
      glass?.dispose();
      material.dispose();
    },
  };
}
