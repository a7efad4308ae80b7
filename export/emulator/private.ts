/** Keys of internal state on objects that pages see, as in iwer. */
export const P_EMULATED = Symbol('scrim/emulated-session');
export const P_EYE = Symbol('scrim/emulated-view');
