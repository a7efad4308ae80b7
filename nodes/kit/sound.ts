/** What was heard last on a wire. Its owner writes it; readers look anew when `version` has changed. */
export interface SoundOutput {
  /** How many of `samples` count: 1, 2, or 0 for silence. */
  channelCount: number;
  sampleRateHz: number;
  /** Per channel the last 4,096 samples, oldest first, in [-1, 1]. */
  readonly samples: readonly Float32Array[];
  version: number;
}

/** A sound file, decoded. */
export interface AudioAsset {
  readonly durationS: number;
  readonly sampleRateHz: number;
  /** One or two, of equal length, in [-1, 1]. */
  readonly channels: readonly Float32Array[];
}
