/** The number of pulses that an output can emit in one frame. It is fixed so that a frame allocates nothing. */
export const PULSE_CAPACITY = 16;
