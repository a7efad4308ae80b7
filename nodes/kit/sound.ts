/** The number of samples from which a level is computed: 21 ms at 48 kHz. */
const LEVEL_SAMPLES = 1024;

/** The newest samples of a sound. Only the node that outputs it writes it, and then increases `version`. */
export interface SoundOutput {
  /** The number of channels in use: 1, 2, or 0 for silence. */
  channelCount: number;
  sampleRateHz: number;
  /** The last 4,096 samples of each channel, oldest first, in [-1, 1]. */
  readonly samples: readonly Float32Array[];
  version: number;
}

/** A decoded sound file. */
export interface AudioAsset {
  readonly durationS: number;
  readonly sampleRateHz: number;
  /** The samples of one or two channels of equal length, in [-1, 1]. */
  readonly channels: readonly Float32Array[];
}

/**
 * Clears an audio output, if it is not silent already.
 *
 * @example
 * if (sound === null) silence(ctx.outputs.audio);
 */
export function silence(output: SoundOutput): void {
  if (output.channelCount === 0 && output.version > 0) return;
  output.channelCount = 0;
  for (const samples of output.samples) samples.fill(0);
  output.version++;
}

/**
 * Fills an audio output with the samples of a file up to a position. Samples before the start of the file are silent, or those of its end
 * if it loops.
 *
 * @param timeS Position in the file, seconds.
 * @param loop Whether the file loops.
 *
 * @example
 * hearAt(ctx.outputs.audio, sound, time.at(sound.durationS, 1, 0, true), true);
 */
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

/**
 * The level of an audio output.
 *
 * @returns The root mean square of the newest samples of all channels, in [0, 1].
 *
 * @example
 * ctx.outputs.level.value = levelOf(ctx.outputs.audio);
 */
export function levelOf({ channelCount, samples }: SoundOutput): number {
  let sum = 0;
  for (let channel = 0; channel < channelCount; channel++) {
    const heard = samples[channel];
    if (!heard) continue;
    for (let i = heard.length - LEVEL_SAMPLES; i < heard.length; i++) sum += (heard[i] ?? 0) ** 2;
  }
  return channelCount === 0 ? 0 : Math.min(1, Math.sqrt(sum / (LEVEL_SAMPLES * channelCount)));
}
