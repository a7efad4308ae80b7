export const CALL_CHANNEL = 'scrim:call';
export const EVENT_CHANNEL = 'scrim:event';
/**
 * Channel of the message that the editor sends when it starts to listen for events. From then on it can be asked before its window closes.
 */
export const LISTENING_CHANNEL = 'scrim:listening';
