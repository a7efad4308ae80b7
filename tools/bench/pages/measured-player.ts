import type { Program } from '../../../export/program/program.ts';
import { createFetchAssetSource } from '../../../export/runtime/assets/asset-source.ts';
import { createBrowserClock, createManualClock, type ManualClock } from '../../../export/runtime/clock.ts';
import { createPlayer, type Player } from '../../../export/runtime/player.ts';
import { createScenesWith } from '../../../export/runtime/scenes/create-scenes.ts';
import { readRadiance } from '../../../export/runtime/scenes/environments/read-radiance.ts';
import { createGlass } from '../../../export/runtime/scenes/glass/glass-scene.ts';
import { createSpatial } from '../../../export/runtime/spatial/create-spatial.ts';
import { RUNTIMES } from '../../../nodes/generated/runtimes.gen.ts';
import { findLampsAtOnce } from '../../../nodes/kit/panorama/find-lamps.ts';
import { type LayerOutput, MAY_CHANGE, type NodeModule } from '../../../nodes/kit/runtime.ts';

/** A player with a manual clock, every node type, and no decoder for compressed models. */
export interface MeasuredPlayer {
  readonly player: Player;
  readonly clock: ManualClock;
  /** Why the image is incomplete, such as a missing model; null if it is complete. Frames of an incomplete image are not measured. */
  readonly wrong: string | null;
}

/** An image file of which the player does not know that it stays the same, so that every frame draws all effects. */
const EVER_CHANGING_IMAGE: NodeModule = {
  create: (context) => {
    const played = RUNTIMES['source/image-file'];
    if (!played || !('create' in played)) throw new Error('There is no runtime for image files.');
    const node = played.create(context);
    const [view] = (context.outputs as unknown as { readonly layer: LayerOutput }).layer.views;
    return {
      ...node,
      update: (frame) => {
        node.update(frame);
        if (view) view.version = MAY_CHANGE;
      },
    };
  },
};

/** Opens a player and waits until it is ready. Assets are loaded from below `assetsUrl`. */
export async function openPlayer(
  gl: WebGL2RenderingContext,
  canvas: HTMLCanvasElement,
  program: Program,
  assetsUrl: string,
): Promise<MeasuredPlayer> {
  const clock = createManualClock();
  const assets = createFetchAssetSource(assetsUrl, fetch.bind(globalThis));
  let wrong: string | null = null;
  const player = createPlayer({
    gl,
    canvas,
    program,
    modules: { ...RUNTIMES, 'source/image-file': EVER_CHANGING_IMAGE },
    createSpatial,
    createScenes: createScenesWith({ decoders: {}, files: assets.load, createGlass, readRadiance, findLamps: findLampsAtOnce }),
    assets,
    seed: 1,
    clock: { ...clock, delay: createBrowserClock().delay },
    onDiagnostics: (diagnostics) => {
      wrong = diagnostics.find(({ severity }) => severity === 'error')?.message ?? null;
    },
  });
  await player.ready;
  return {
    player,
    clock,
    get wrong() {
      return wrong;
    },
  };
}
