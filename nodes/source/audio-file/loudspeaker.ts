import type { AudioAsset } from '../../kit/sound.ts';

/** The largest deviation of the audible position from the clock, seconds. Corrections are audible, so smaller deviations remain. */
const MAX_DRIFT_S = 0.1;

/** Plays a sound to the visitor, if the browser allows it. */
export interface Loudspeaker {
  /** Plays the file at a position, seconds; null is silence. Call it every frame. */
  follow(timeS: number | null, volume: number, loop: boolean): void;
  dispose(): void;
}

/**
 * Creates a loudspeaker for a sound. It is silent until the first gesture on the page, because browsers suspend an audio context until
 * then.
 */
export function createLoudspeaker(sound: AudioAsset): Loudspeaker {
  const context = new AudioContext({ latencyHint: 'interactive' });
  const gain = context.createGain();
  gain.connect(context.destination);
  const buffer = context.createBuffer(sound.channels.length, sound.channels[0]?.length ?? 1, sound.sampleRateHz);
  sound.channels.forEach((samples, channel) => {
    buffer.getChannelData(channel).set(samples);
  });
  let source: AudioBufferSourceNode | null = null;
  /** The position in the file when the context's clock was 0, seconds. */
  let originS = 0;

  const wake = (): void => {
    if (context.state === 'suspended') void context.resume().catch(() => {});
  };
  for (const gesture of GESTURES) document.addEventListener(gesture, wake);

  function stop(): void {
    source?.stop();
    source?.disconnect();
    source = null;
  }

  function start(timeS: number, loop: boolean): void {
    stop();
    source = context.createBufferSource();
    source.buffer = buffer;
    source.loop = loop;
    source.connect(gain);
    source.start(0, timeS);
    originS = timeS - context.currentTime;
  }

  function driftS(timeS: number, loop: boolean): number {
    const apartS = Math.abs(originS + context.currentTime - timeS);
    return loop ? Math.abs(apartS - Math.round(apartS / sound.durationS) * sound.durationS) : apartS;
  }

  return {
    follow: (timeS, volume, loop) => {
      if (timeS === null) {
        stop();
        return;
      }
      gain.gain.value = volume;
      if (context.state !== 'running') return;
      if (source === null || source.loop !== loop || driftS(timeS, loop) > MAX_DRIFT_S) start(timeS, loop);
    },
    dispose: () => {
      for (const gesture of GESTURES) document.removeEventListener(gesture, wake);
      stop();
      void context.close();
    },
  };
}

const GESTURES = ['pointerdown', 'pointerup', 'keydown'] as const;
