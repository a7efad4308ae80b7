import type { Session } from '../../nodes/kit/session.ts';
import type { Player } from './player.ts';
import { type LayerDepth, type LayerPixels, readColor, readDepth } from './readback.ts';
import { setFrustum, setRigidInverse } from './sessions/matrix.ts';
import { coverCanvas, createSessionFrame } from './sessions/session-frame.ts';

/** What a camera sees of a layer. */
export interface LayerPicture {
  readonly color: LayerPixels;
  readonly depth: LayerDepth;
}

/** Draws a layer for cameras of its own, at time 0. */
export interface Photographer {
  /**
   * Draws the layer for a pinhole camera, when all of its assets have loaded, in the size of the canvas.
   *
   * @param worldFromCamera Column-major 4×4, rigid.
   * @param tangents Those of half the horizontal and half the vertical field of view.
   */
  take(worldFromCamera: readonly number[], tangents: readonly [x: number, y: number]): Promise<LayerPicture>;
}

/** The cameras of an acquisition belong to no device: no image of the world, no input, no light. */
const SESSION: Session = {
  kind: 'orbit',
  capabilities: new Set(),
  world: 'none',
  blend: 'opaque',
  start: () => {},
  end: async () => {},
};

/**
 * Creates a photographer, which takes over the session of the player.
 *
 * @param player A held player.
 * @param layer A layer with depth that the program keeps, as `node.port`.
 */
export function createPhotographer(gl: WebGL2RenderingContext, player: Player, layer: string): Photographer {
  const frame = createSessionFrame();
  player.setSession(SESSION);
  return {
    take: async (worldFromCamera, [x, y]) => {
      const view = coverCanvas(frame, gl);
      setFrustum(view.clipFromView, -x, x, -y, y, view.nearM, view.farM);
      view.worldFromView.set(worldFromCamera);
      setRigidInverse(view.viewFromWorld, view.worldFromView);
      await player.drawSettled(frame);
      frame.index++;
      const color = readColor(player.inspect(layer), 0);
      const depth = readDepth(player.inspect(layer), 0);
      if (!color || !depth) throw new Error(`Layer ${layer} was not drawn.`);
      return { color, depth };
    },
  };
}
