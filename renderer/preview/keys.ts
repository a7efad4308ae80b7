import { keybindingOf } from '../keybinding.ts';
import type { FromPreview, ToPreview } from '../preview-protocol.ts';

/** Keys that are pressed while the preview has the focus, and that the editor has a use for. */
export interface Keys {
  take(message: Extract<ToPreview, { kind: 'keys' }>): void;
  dispose(): void;
}

/** `isOurs`: the preview uses the key itself, for now. */
export function createKeys(page: Window, send: (message: FromPreview) => void, isOurs: (event: KeyboardEvent) => boolean): Keys {
  let keybindings: ReadonlySet<string> = new Set();
  let mac = false;
  const onKeyDown = (event: KeyboardEvent) => {
    const keybinding = keybindingOf(event, mac);
    if (event.defaultPrevented || isOurs(event) || !keybindings.has(keybinding)) return;
    // Else the browser would save its page, or look for text in it.
    event.preventDefault();
    send({ kind: 'key', keybinding });
  };
  page.addEventListener('keydown', onKeyDown);
  return {
    take: (message) => {
      keybindings = new Set(message.keybindings);
      mac = message.mac;
    },
    dispose: () => page.removeEventListener('keydown', onKeyDown),
  };
}
