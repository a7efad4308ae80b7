/** Where our classes keep what pages must not see, as iwer does with its own symbols. */
export const P_EMULATED = Symbol('scrim/emulated-session');
export const P_EYE = Symbol('scrim/emulated-view');
