import { type AnimationClip, AnimationMixer, type Object3D } from 'three';
import type { Clock } from '../../kit/runtime.ts';

/** Plays one clip over and over. */
export interface Animation {
  update(speed: number, playing: boolean): void;
  /** Back to the clip's beginning. */
  reset(): void;
  dispose(): void;
}

/**
 * Poses are a function of the clock, not a sum of frame times: they do not depend on how many frames were drawn or when the model
 * had loaded. A change of speed, or a pause, goes on from the pose it finds.
 */
export function createAnimation(root: Object3D, clip: AnimationClip, clock: Clock): Animation {
  const mixer = new AnimationMixer(root);
  mixer.clipAction(clip).play();
  // The clip stood at `anchorClipS` when the clock showed `anchorS`, and has run at `rate` since.
  let anchorS = 0;
  let anchorClipS = 0;
  let rate: number | null = null;
  let restart = false;
  let posedAtS = Number.NaN;

  const clipTime = (): number => anchorClipS + (clock.timeS - anchorS) * (rate ?? 0);

  return {
    update: (speed, playing) => {
      const wanted = playing ? speed : 0;
      if (restart) {
        anchorS = clock.timeS;
        anchorClipS = 0;
        restart = false;
      } else if (rate !== null && rate !== wanted) {
        anchorClipS = clipTime();
        anchorS = clock.timeS;
      }
      rate = wanted;
      const timeS = wrap(clipTime(), clip.duration);
      if (timeS === posedAtS) return;
      posedAtS = timeS;
      mixer.setTime(timeS);
      root.updateMatrixWorld();
    },
    reset: () => {
      restart = true;
    },
    dispose: () => {
      mixer.stopAllAction();
      mixer.uncacheRoot(root);
    },
  };
}

function wrap(timeS: number, durationS: number): number {
  return durationS > 0 ? timeS - durationS * Math.floor(timeS / durationS) : 0;
}
