import type { Anchor } from '../../kit/anchors.ts';
import type { DerivedEnvironment } from '../../kit/assets.ts';
import { headingOf } from '../../kit/panorama/shot.ts';
import { writePose } from '../../kit/pose.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import { PANORAMA_ANCHOR, type TakenPanorama } from '../../kit/taken-panorama.ts';
import type { definition } from './definition.ts';

/**
 * Shows the panorama that the visitor has taken, and keeps its place by an anchor. The page takes the panorama
 * (`export/page/panorama-step`).
 */
export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { rotationRad, exposure } = ctx.params;
  const { environment, pose } = ctx.outputs;
  const { session } = ctx;
  const id = ctx.assetIds.file;
  const file = id === null ? null : ctx.assets.environment(id);
  let shown: TakenPanorama | null = null;
  let taken: DerivedEnvironment | null = null;
  let anchor: Anchor | null = null;
  let lastSession = -1;
  let jumps = 0;

  function show(panorama: TakenPanorama | null): void {
    taken?.dispose();
    taken = panorama === null ? null : ctx.assets.createEnvironment(panorama.pixels);
    shown = panorama;
  }

  function anchorTo({ isNew, worldFromPanorama }: TakenPanorama): Anchor | null {
    return isNew ? session.anchors.create(worldFromPanorama, PANORAMA_ANCHOR) : session.anchors.restore(PANORAMA_ANCHOR);
  }

  function follow(panorama: TakenPanorama): void {
    if (anchor?.state !== 'tracked') return;
    if (!panorama.located) jumps++;
    panorama.worldFromPanorama.set(anchor.worldFromAnchor);
    panorama.located = true;
  }

  return {
    update: () => {
      const { panorama } = session;
      if (panorama !== shown || session.sessions !== lastSession) {
        anchor?.delete();
        if (panorama !== shown) show(panorama);
        anchor = panorama === null ? null : anchorTo(panorama);
        lastSession = session.sessions;
        jumps++;
      }
      if (panorama) follow(panorama);
      environment.asset = taken ?? file?.value ?? null;
      environment.intensity = 2 ** exposure.value;
      environment.rotationRad = rotationRad.value + (panorama ? headingOf(panorama.worldFromPanorama) : 0);
      writePose(pose, panorama?.located ? panorama.worldFromPanorama : null, jumps);
    },
    dispose: () => {
      anchor?.delete();
      taken?.dispose();
      file?.release();
    },
  };
}
