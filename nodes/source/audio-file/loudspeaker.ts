import type { AudioAsset } from '../../kit/sound.ts';

/** How far what is heard may stray from the picture, seconds: a jump is heard, less than this is not. */
const MAX_DRIFT_S = 0.1;

/** Plays a sound to the visitor, as far as the browser lets it. */
export interface Loudspeaker {
  /** The moment of the file that is heard now, every frame; null is silence. */
  follow(timeS: number | null, volume: number, loop: boolean): void;
  dispose(): void;
}

/** Browsers hold a context back until the page has been touched, and wake it when it is resumed after that. */
export function createLoudspeaker(sound: AudioAsset): Loudspeaker {
  const context = new AudioContext({ latencyHint: 'interactive' });
  const gain = context.createGain();
  gain.connect(context.destination);
  const buffer = context.createBuffer(sound.channels.length, sound.channels[0]?.length ?? 1, sound.sampleRateHz);
  sound.channels.forEach((samples, channel) => {
    buffer.getChannelData(channel).set(samples);
  });
  let source: AudioBufferSourceNode | null = null;
  /** The moment of the file that would be heard at 0 of the context's clock. */
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
