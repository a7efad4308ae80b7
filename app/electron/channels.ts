export const CALL_CHANNEL = 'scrim:call';
export const EVENT_CHANNEL = 'scrim:event';
/** The editor has begun to listen, so that it can be asked before its window closes. */
export const LISTENING_CHANNEL = 'scrim:listening';
