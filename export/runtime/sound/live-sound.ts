import type { SoundOutput } from '../../../nodes/kit/sound.ts';
import { MAX_CHANNELS, SOUND_WINDOW } from '../../program/texture-sizes.ts';
import type { GlObjects } from '../gl/gl-objects.ts';
import { createSoundPicture, type SoundAnalysis, type SoundPicture } from './sound-picture.ts';

/** A sound of the running program with its textures, which passes share. */
export interface LiveSound {
  readonly sound: SoundOutput;
  picture(analysis: SoundAnalysis, count: number): SoundPicture;
  dispose(): void;
}

export function createLiveSound(objects: GlObjects): LiveSound {
  const sound: SoundOutput = {
    channelCount: 0,
    sampleRateHz: 0,
    samples: Array.from({ length: MAX_CHANNELS }, () => new Float32Array(SOUND_WINDOW)),
    version: 0,
  };
  const pictures = new Map<string, SoundPicture>();
  return {
    sound,
    picture: (analysis, count) => {
      const key = `${analysis} ${count}`;
      const known = pictures.get(key) ?? createSoundPicture(objects, sound, analysis, count);
      pictures.set(key, known);
      return known;
    },
    dispose: () => {
      for (const picture of pictures.values()) picture.dispose();
      pictures.clear();
    },
  };
}
