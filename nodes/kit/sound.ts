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
  /** One or two, of equal length, in [-1, 1]. */
  readonly channels: readonly Float32Array[];
}
