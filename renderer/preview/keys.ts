import { keybindingOf } from '../keybinding.ts';
import type { FromPreview, ToPreview } from '../preview-protocol.ts';

/** Forwards keys to the editor while the preview has the focus. */
export interface Keys {
  receive(message: Extract<ToPreview, { kind: 'keys' }>): void;
  dispose(): void;
}

/**
 * Starts to forward keys.
 *
 * @param isOurs Whether the preview currently uses the key itself.
 */
export function createKeys(page: Window, send: (message: FromPreview) => void, isOurs: (event: KeyboardEvent) => boolean): Keys {
  let keybindings: ReadonlySet<string> = new Set();
  let mac = false;
  const onKeyDown = (event: KeyboardEvent) => {
    const keybinding = keybindingOf(event, mac);
    if (event.defaultPrevented || isOurs(event) || !keybindings.has(keybinding)) return;
    // Prevents the default of the browser, such as to save the page.
    event.preventDefault();
    send({ kind: 'key', keybinding });
  };
  page.addEventListener('keydown', onKeyDown);
  return {
    receive: (message) => {
      keybindings = new Set(message.keybindings);
      mac = message.mac;
    },
    dispose: () => page.removeEventListener('keydown', onKeyDown),
  };
}
