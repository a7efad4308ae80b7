import { type Camera, HalfFloatType, NearestFilter, RGBAFormat, type Scene, type Texture, type WebGLRenderTarget } from 'three';
import type { SceneRenderer } from '../scene-renderer.ts';

/** The translucent shadow map of one light: how transparent casters dim it. It exists only while there is such a caster. */
export interface TranslucentShadow {
  texture(): Texture | null;
  /**
   * Draws the map, or the given face of a cube map, from the camera of the light. `translucentShadows` contains the transparent casters as
   * `translucent-shadow-twin.ts` draws them; null if there are none.
   */
  render(renderer: SceneRenderer, translucentShadows: Scene | null, camera: Camera, face?: number): void;
  dispose(): void;
}

/**
 * Options of a translucent shadow map: half floats, which hold meters in alpha with a relative precision of 1/2048; unfiltered, because a
 * mean of the depths of different objects has no meaning.
 */
export const TRANSLUCENT_SHADOW = {
  format: RGBAFormat,
  type: HalfFloatType,
  minFilter: NearestFilter,
  magFilter: NearestFilter,
  generateMipmaps: false,
  depthBuffer: false,
} as const;

/**
 * Whether a point is far enough behind a transparent caster to be dimmed by it. The margin is 3 mm, for decals, plus the rounding of half
 * floats. Meters along the light's axis.
 */
export const BEHIND_TRANSLUCENT = /* glsl */ `
bool isBehindTranslucent( const in float meters, const in float translucentM ) {
  return meters > translucentM * 1.001 + 0.003;
}
`;

export function createTranslucentShadow(createTarget: () => WebGLRenderTarget): TranslucentShadow {
  let target: WebGLRenderTarget | null = null;
  const free = (): void => {
    target?.dispose();
    target = null;
  };
  return {
    texture: () => target?.texture ?? null,
    render: (renderer, translucentShadows, camera, face) => {
      if (translucentShadows === null) {
        free();
        return;
      }
      target ??= createTarget();
      renderer.drawTranslucentShadow(target, translucentShadows, camera, face);
    },
    dispose: free,
  };
}
