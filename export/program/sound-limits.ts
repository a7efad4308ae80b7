/** Maximum number of sound samples that are kept, which is also the maximum width of a waveform. A power of two. */
export const SOUND_WINDOW = 4096;

/** Maximum width that a shader can request: a spectrum needs twice as many samples. */
export const MAX_SOUND_COUNT = SOUND_WINDOW / 2;

/** Left and right. */
export const MAX_CHANNELS = 2;
