import { createMediaTime } from '../../kit/media-time.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import { hearAt, levelOf, silence } from '../../kit/sound.ts';
import type { definition } from './definition.ts';
import { createLoudspeaker, type Loudspeaker } from './loudspeaker.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { playing, loop, volume, startS } = ctx.params;
  const { audio, level } = ctx.outputs;
  const id = ctx.assetIds.file;
  const file = id === null ? null : ctx.assets.audio(id);
  const time = createMediaTime(ctx.clock);
  let loudspeaker: Loudspeaker | null = null;
  silence(audio);
  level.value = 0;

  return {
    update: () => {
      const sound = file?.value ?? null;
      if (sound === null) return;
      const rate = playing.value ? 1 : 0;
      const timeS = time.at(sound.durationS, rate, startS.value, loop.value);
      const isOver = !loop.value && timeS >= sound.durationS;
      if (rate === 0 || isOver) silence(audio);
      else hearAt(audio, sound, timeS, loop.value);
      level.value = levelOf(audio);
      // Renders and paused clocks play no audible sound.
      const isHeard = rate > 0 && !isOver && !ctx.clock.held && ctx.clock.deltaS > 0 && volume.value > 0;
      if (isHeard) loudspeaker ??= createLoudspeaker(sound);
      loudspeaker?.follow(isHeard ? timeS : null, volume.value, loop.value);
    },
    reset: time.reset,
    dispose: () => {
      loudspeaker?.dispose();
      file?.release();
    },
  };
}
