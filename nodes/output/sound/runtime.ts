import { Matrix4, Vector3 } from 'three';
import type { NodeContext, NodeRuntime, Pulse } from '../../kit/runtime.ts';
import type { SessionFrame } from '../../kit/session.ts';
import type { definition } from './definition.ts';
import { strike } from './strike.ts';
import { createVoices, type Strike, type Voices } from './voices.ts';

/** Limit of a random change of pitch, in octaves up or down. */
const MOST_OCTAVES = 0.5;

// Filled and read within one call.
const scratchMatrix = new Matrix4();
const scratchPoint = new Vector3();

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { volume, loudest, quietest, spread, place } = ctx.params;
  const { sound: name } = ctx.config;
  const id = ctx.assetIds.file;
  const file = name === 'file' && id !== null ? ctx.assets.audio(id) : null;
  const generated = name === 'file' ? null : strike(name);
  const from = new Float64Array(3);
  const next: { -readonly [K in keyof Strike]: Strike[K] } = { amplitude: 0, rate: 1, from: null };
  let voices: Voices | null = null;

  function open(): Voices {
    return createVoices((reason) =>
      ctx.report({
        code: 'SCR055',
        severity: 'warning',
        message: `The browser plays no sound: ${reason}. The page goes on in silence.`,
        fix: 'Allow sound for this page, or connect a speaker.',
      }),
    );
  }
  function amplitudeOf({ number }: Pulse): number {
    if (loudest.value <= 0) return volume.value;
    if (!(number >= quietest.value)) return 0;
    return volume.value * Math.min(1, Math.max(0, number / loudest.value));
  }
  /** Writes the position of the sound in view space to `from`. Returns false if the sound comes from no particular place. */
  function locate({ worldFromPose }: Pulse, { views, viewCount }: SessionFrame): boolean {
    const [view] = views;
    if (!place.value || !worldFromPose || !view || viewCount === 0) return false;
    scratchPoint.setFromMatrixPosition(scratchMatrix.fromArray(worldFromPose));
    scratchPoint.applyMatrix4(scratchMatrix.fromArray(view.viewFromWorld)).toArray(from);
    return from.every(Number.isFinite);
  }

  return {
    update: (frame) => {
      const { play } = ctx.inputs;
      // Renders and paused clocks play nothing.
      if (ctx.clock.held || ctx.clock.deltaS <= 0) return;
      // Made in the first frame, so that it hears of the first gesture.
      voices ??= open();
      const sound = file ? file.value : generated;
      if (!sound) return;
      for (let i = 0; i < play.count; i++) {
        const pulse = play.at(i);
        next.amplitude = amplitudeOf(pulse);
        if (next.amplitude <= 0) continue;
        next.rate = 2 ** (MOST_OCTAVES * spread.value * (2 * ctx.random() - 1));
        next.from = locate(pulse, frame) ? from : null;
        voices.play(sound, next);
      }
    },
    dispose: () => {
      voices?.dispose();
      file?.release();
    },
  };
}
