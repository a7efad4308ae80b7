import type { SoundOutput } from '../../../nodes/kit/sound.ts';
import { MAX_CHANNELS, SOUND_WINDOW } from '../../program/texture-sizes.ts';
import type { GlObjects } from '../gl/gl-objects.ts';
import { createSoundTexture, type SoundAnalysis, type SoundTexture } from './sound-texture.ts';

/** A sound of the running program with its textures, which passes share. */
export interface LiveSound {
  readonly sound: SoundOutput;
  texture(analysis: SoundAnalysis, count: number): SoundTexture;
  dispose(): void;
}

export function createLiveSound(objects: GlObjects): LiveSound {
  const sound: SoundOutput = {
    channelCount: 0,
    sampleRateHz: 0,
    samples: Array.from({ length: MAX_CHANNELS }, () => new Float32Array(SOUND_WINDOW)),
    version: 0,
  };
  const images = new Map<string, SoundTexture>();
  return {
    sound,
    texture: (analysis, count) => {
      const key = `${analysis} ${count}`;
      const known = images.get(key) ?? createSoundTexture(objects, sound, analysis, count);
      images.set(key, known);
      return known;
    },
    dispose: () => {
      for (const image of images.values()) image.dispose();
      images.clear();
    },
  };
}
