import type { VideoPlayback } from '../../kit/assets.ts';
import { createMediaTime } from '../../kit/media-time.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { playing, loop, speed, startS } = ctx.params;
  const id = ctx.assetIds.file;
  const video = id === null ? null : ctx.assets.video(id);
  const time = createMediaTime(ctx.clock);
  const [view] = ctx.outputs.layer.views;
  let playback: VideoPlayback | null = null;

  function show(): void {
    const image = playback?.image ?? null;
    if (!view) return;
    view.texture = image?.texture ?? null;
    view.widthPx = image?.widthPx ?? 0;
    view.heightPx = image?.heightPx ?? 0;
    view.version = playback?.version ?? 0;
  }

  return {
    update: () => {
      const asset = video?.value ?? null;
      if (asset === null) return;
      playback ??= asset.open(({ message, fix }) => ctx.report({ code: 'SCR055', severity: 'warning', port: 'file', message, fix }));
      const rate = playing.value ? speed.value : 0;
      const timeS = time.at(asset.durationS, rate, startS.value, loop.value);
      // A held clock, a paused preview and the end of the video need exactly this frame.
      const runs = !ctx.clock.held && ctx.clock.deltaS > 0 && (loop.value || timeS < asset.durationS);
      playback.follow(timeS, runs ? rate : 0, loop.value);
      show();
    },
    settle: () => playback?.settle()?.then(show) ?? null,
    reset: time.reset,
    dispose: () => {
      playback?.dispose();
      video?.release();
    },
  };
}
