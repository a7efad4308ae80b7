import type { AudioAsset, SoundOutput } from './sound.ts';

/** Samples that a level is taken from: 21 ms at 48 kHz. */
const LEVEL_SAMPLES = 1024;

export function silence(output: SoundOutput): void {
  if (output.channelCount === 0 && output.version > 0) return;
  output.channelCount = 0;
  for (const samples of output.samples) samples.fill(0);
  output.version++;
}

/** Fills the output with what of a file is heard up to `timeS`; before its start there is silence, or its end where it loops. */
export function hearAt(output: SoundOutput, sound: AudioAsset, timeS: number, loop: boolean): void {
  const end = Math.round(timeS * sound.sampleRateHz);
  sound.channels.forEach((from, channel) => {
    const to = output.samples[channel];
    if (!to) return;
    for (let i = 0; i < to.length; i++) {
      let at = end - to.length + i;
      if (loop && at < 0) at += from.length * Math.ceil(-at / from.length);
      to[i] = from[at] ?? 0;
    }
  });
  output.channelCount = Math.min(sound.channels.length, output.samples.length);
  output.sampleRateHz = sound.sampleRateHz;
  output.version++;
}

/** Root mean square of the newest samples of all channels, from 0 to 1. */
export function levelOf({ channelCount, samples }: SoundOutput): number {
  let sum = 0;
  for (let channel = 0; channel < channelCount; channel++) {
    const heard = samples[channel];
    if (!heard) continue;
    for (let i = heard.length - LEVEL_SAMPLES; i < heard.length; i++) sum += (heard[i] ?? 0) ** 2;
  }
  return channelCount === 0 ? 0 : Math.min(1, Math.sqrt(sum / (LEVEL_SAMPLES * channelCount)));
}
