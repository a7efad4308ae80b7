import { type Camera, HalfFloatType, NearestFilter, RGBAFormat, type Scene, type Texture, type WebGLRenderTarget } from 'three';
import type { SceneRenderer } from '../scene-renderer.ts';

/** How see-through casters dim one light, in a picture beside its map; made when there first is one, and freed when there is none. */
export interface Veil {
  texture(): Texture | null;
  /** `veils`: what is see-through as `veil-twin.ts` draws it; null where nothing is. `face`: of a cube. */
  render(renderer: SceneRenderer, veils: Scene | null, camera: Camera, face?: number): void;
  dispose(): void;
}

/** Half floats: metres in alpha to a 2048th part. Not filtered, because depth of different things has no mean. */
export const VEIL = {
  format: RGBAFormat,
  type: HalfFloatType,
  minFilter: NearestFilter,
  magFilter: NearestFilter,
  generateMipmaps: false,
  depthBuffer: false,
} as const;

/**
 * What lies so far behind what is see-through is dimmed by it: 3 mm for what is pasted onto it, and the rounding of half floats,
 * also where a GPU cuts off rather than rounds. Metres along the light's axis.
 */
export const BEHIND_VEIL = /* glsl */ `
bool behindVeil( const in float metres, const in float veilM ) {
  return metres > veilM * 1.001 + 0.003;
}
`;

export function createVeil(createTarget: () => WebGLRenderTarget): Veil {
  let target: WebGLRenderTarget | null = null;
  const free = (): void => {
    target?.dispose();
    target = null;
  };
  return {
    texture: () => target?.texture ?? null,
    render: (renderer, veils, camera, face) => {
      if (veils === null) {
        free();
        return;
      }
      target ??= createTarget();
      renderer.drawVeil(target, veils, camera, face);
    },
    dispose: free,
  };
}
