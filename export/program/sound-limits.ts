/** The most samples of a sound that are remembered, and so the widest picture of one. A power of two. */
export const SOUND_WINDOW = 4096;

/** The widest picture that a shader can ask for: its spectrum is of twice as many samples. */
export const MAX_SOUND_COUNT = SOUND_WINDOW / 2;

/** Left and right. */
export const MAX_CHANNELS = 2;
