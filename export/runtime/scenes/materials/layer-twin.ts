import type { BackSide, FrontSide, Material, MeshPhysicalMaterial } from 'three';
import type { LayerEncoding } from '../../../../nodes/kit/definition.ts';
import { follow } from './follow.ts';
import type { GlassPatch } from './glass-patch.ts';
import { applyLayerBlending, isTransmissive } from './layer-blending.ts';
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
  /** The only side that is drawn of a double-sided master; null draws the sides of the master. */
  readonly side: typeof BackSide | typeof FrontSide | null;
  /** Encoding of the layer. */
  readonly encoding: LayerEncoding;
  /** Fades fragments behind the room; null without occlusion. */
  readonly occlusion: ShaderPatch | null;
  /** Effects at the end of opaque materials; null for none. */
  readonly effects: ShaderPatch | null;
  readonly translucentShadows: TranslucentShadowPatch;
  /** Creates the patch of a transmissive material; null where the page has no glass. */
  readonly patchGlass: ((master: MeshPhysicalMaterial) => GlassPatch) | null;
  /** Called when the master needs to be drawn differently, such as after it became transparent. */
  readonly onChange: () => void;
}

/** The material that draws the master into a layer: its own shading with premultiplied output (see `layer-blending.ts`). */
export function createLayerTwin(master: Material, options: LayerTwinOptions): Twin {
  const material = master.clone();
  const glass = isTransmissive(master) ? (options.patchGlass?.(master) ?? null) : null;
  const fades = options.occlusion !== null;
  const isPhysical = 'isMeshPhysicalMaterial' in master;
  patchMaterial(
    material,
    master,
    [
      createShadowOffsetPatch(),
      options.translucentShadows,
      glass,
      options.occlusion,
      options.encoding === 'scene' ? FINITE_PATCH : null,
      options.effects,
    ].filter((patch) => patch !== null),
  );
  options.translucentShadows.attach(material);
  // Above 0, three.js would draw what is behind glass by itself.
  if (isPhysical) (material as MeshPhysicalMaterial).transmission = 0;
  const fixed = [...(options.side === null ? [] : ['side']), ...(isPhysical ? ['_transmission'] : [])];
  const sync = follow(material, master, fixed);
  if (options.side !== null) material.side = options.side;

  function blend(): void {
    applyLayerBlending(material, master, fades);
    if (glass) Object.assign(material.defines ?? {}, glass.defines());
  }
  blend();
  glass?.sync();
  return {
    material,
    sync: () => {
      glass?.sync();
      if (!sync()) return;
      blend();
      options.onChange();
    },
    dispose: () => {
      options.translucentShadows.detach(material);
      material.dispose();
    },
  };
}
