/** Pulses that an output can pass on in one frame. Fixed, so that a frame allocates nothing. */
export const PULSE_CAPACITY = 16;
