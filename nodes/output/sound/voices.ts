import type { AudioAsset } from '../../kit/sound.ts';

/** One play of the sound. */
export interface Strike {
  /** Volume, in [0, 1]. */
  amplitude: number;
  /** Factor on the playback speed, and thus on the pitch. */
  rate: number;
  /** Position of the source in view space, meters; null: the sound has no direction. */
  from: Readonly<Float64Array> | null;
}

/** Plays short sounds to the visitor, several at once. */
export interface Voices {
  /** Plays a sound. Does nothing before the visitor’s first gesture. */
  play(sound: AudioAsset, strike: Readonly<Strike>): void;
  dispose(): void;
}

/** The most sounds that play at once; further ones are dropped. */
export const MAX_VOICES = 12;
/** Distance up to which a sound has its full volume. */
const NEAR_M = 0.5;
const GESTURES = ['pointerdown', 'pointerup', 'keydown'] as const;

/**
 * Creates a player of short sounds. Its audio context is created at the first gesture on the page, because browsers allow no sound before;
 * that may be the gesture that entered AR.
 *
 * @param onRefusal Called once if the browser plays no sound.
 */
export function createVoices(onRefusal: (reason: string) => void): Voices {
  let context: AudioContext | null = null;
  let isRefused = false;
  let playing = 0;
  let buffer: { readonly of: AudioAsset; readonly data: AudioBuffer } | null = null;

  const refuse = (reason: string): void => {
    if (isRefused) return;
    isRefused = true;
    onRefusal(reason);
  };
  const wake = (): void => {
    if (isRefused) return;
    try {
      context ??= new AudioContext({ latencyHint: 'interactive' });
    } catch (error) {
      refuse(error instanceof Error ? error.message : String(error));
      return;
    }
    if (context.state === 'suspended') context.resume().catch((error: unknown) => refuse(String(error)));
  };
  for (const gesture of GESTURES) document.addEventListener(gesture, wake);
  if (navigator.userActivation?.hasBeenActive) wake();

  function bufferOf(audio: AudioContext, sound: AudioAsset): AudioBuffer {
    if (buffer?.of === sound) return buffer.data;
    const data = audio.createBuffer(sound.channels.length, sound.channels[0]?.length ?? 1, sound.sampleRateHz);
    sound.channels.forEach((samples, channel) => {
      data.getChannelData(channel).set(samples);
    });
    buffer = { of: sound, data };
    return data;
  }
  function placed(audio: AudioContext, [x = 0, y = 0, z = 0]: Readonly<Float64Array>): PannerNode {
    const panner = audio.createPanner();
    panner.panningModel = 'HRTF';
    panner.refDistance = NEAR_M;
    panner.positionX.value = x;
    panner.positionY.value = y;
    panner.positionZ.value = z;
    panner.connect(audio.destination);
    return panner;
  }

  return {
    play: (sound, { amplitude, rate, from }) => {
      if (context?.state !== 'running' || playing >= MAX_VOICES) return;
      const source = context.createBufferSource();
      const gain = context.createGain();
      const to = from ? placed(context, from) : context.destination;
      source.buffer = bufferOf(context, sound);
      source.playbackRate.value = rate;
      gain.gain.value = amplitude;
      source.connect(gain).connect(to);
      playing++;
      source.onended = () => {
        playing--;
        gain.disconnect();
        if (to !== context?.destination) to.disconnect();
      };
      source.start();
    },
    dispose: () => {
      for (const gesture of GESTURES) document.removeEventListener(gesture, wake);
      void context?.close();
      context = null;
    },
  };
}
