import { type AnimationClip, AnimationMixer, type Object3D } from 'three';
import type { Clock } from '../../kit/runtime.ts';

/** Plays one clip in a loop. */
export interface Animation {
  /** The number of poses so far. */
  readonly poses: number;
  update(speed: number, playing: boolean): void;
  /** Returns to the start of the clip. */
  reset(): void;
  dispose(): void;
}

/**
 * Creates an animation whose pose is a function of the clock, not a sum of frame times: it does not depend on the number of frames or
 * on when the model loaded. After a change of speed or a pause it continues from the current pose.
 */
export function createAnimation(root: Object3D, clip: AnimationClip, clock: Clock): Animation {
  const mixer = new AnimationMixer(root);
  mixer.clipAction(clip).play();
  // The clip was at `anchorClipS` at the time `anchorS` of the clock, and has advanced at `rate` since.
  let anchorS = 0;
  let anchorClipS = 0;
  let rate: number | null = null;
  let restart = false;
  let posedAtS = Number.NaN;
  let poses = 0;

  const clipTime = (): number => anchorClipS + (clock.timeS - anchorS) * (rate ?? 0);

  return {
    get poses() {
      return poses;
    },
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
      poses++;
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
