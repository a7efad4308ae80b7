import type { AudioAsset } from '../../../nodes/kit/sound.ts';
import { MAX_CHANNELS } from '../../program/texture-sizes.ts';

export interface LoadedAudio extends AudioAsset {
  dispose(): void;
}

/** Sample rate of decoded audio: that of most hardware. The decoder resamples files with another rate. */
const SAMPLE_RATE_HZ = 48_000;

/** Decodes a whole file without an audio device or a user gesture. Rejects if the browser cannot decode it. */
export async function loadAudio(bytes: ArrayBuffer): Promise<LoadedAudio> {
  const context = new OfflineAudioContext(1, 1, SAMPLE_RATE_HZ);
  // `decodeAudioData` detaches its buffer, so it gets a copy; others may still use `bytes`.
  const buffer = await context.decodeAudioData(bytes.slice(0)).catch(() => {
    throw new Error('it is no sound that this browser can decode');
  });
  const count = Math.min(buffer.numberOfChannels, MAX_CHANNELS);
  return {
    durationS: buffer.duration,
    sampleRateHz: buffer.sampleRate,
    channels: Array.from({ length: count }, (_, channel) => buffer.getChannelData(channel)),
    dispose: () => {},
  };
}
