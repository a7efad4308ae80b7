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
  /** The newest panorama, until it can be drawn. */
  let next: DerivedEnvironment | null = null;
  let anchor: Anchor | null = null;
  let lastSession = -1;
  let jumps = 0;

  function show(panorama: TakenPanorama | null): void {
    next?.dispose();
    next = panorama === null ? null : ctx.assets.createEnvironment(panorama.pixels);
    shown = panorama;
  }

  /** Shows the newest panorama once it can be drawn, and the one before until then. */
  function showWhenReady(): void {
    if (next?.ready === false || (next === null && shown !== null)) return;
    taken?.dispose();
    taken = next;
    next = null;
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
        if (panorama !== shown) {
          // The kept anchor is the place of the former panorama. One that was chosen instead has another.
          if (shown !== null && panorama?.isNew !== true) session.anchors.forget(PANORAMA_ANCHOR);
          show(panorama);
        }
        anchor = panorama === null ? null : anchorTo(panorama);
        lastSession = session.sessions;
        jumps++;
      }
      showWhenReady();
      if (panorama) follow(panorama);
      environment.asset = taken ?? file?.value ?? null;
      environment.intensity = 2 ** exposure.value;
      environment.rotationRad = rotationRad.value + (panorama ? headingOf(panorama.worldFromPanorama) : 0);
      writePose(pose, panorama?.located ? panorama.worldFromPanorama : null, jumps);
    },
    dispose: () => {
      anchor?.delete();
      taken?.dispose();
      next?.dispose();
      file?.release();
    },
  };
}
