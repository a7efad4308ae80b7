export const CALL_CHANNEL = 'scrim:call';
export const EVENT_CHANNEL = 'scrim:event';
/** Sent when the editor listens for events, so that it can be asked before its window closes. */
export const LISTENING_CHANNEL = 'scrim:listening';
