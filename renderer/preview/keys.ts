import { chordOf } from '../key-chord.ts';
import type { FromPreview, ToPreview } from '../preview-protocol.ts';

/** Keys that are pressed while the preview has the focus, and that the editor has a use for. */
export interface Keys {
  take(message: Extract<ToPreview, { kind: 'keys' }>): void;
  dispose(): void;
}

/** `isOurs`: the preview uses the key itself, for now. */
export function createKeys(page: Window, send: (message: FromPreview) => void, isOurs: (event: KeyboardEvent) => boolean): Keys {
  let chords: ReadonlySet<string> = new Set();
  let mac = false;
  const onKeyDown = (event: KeyboardEvent) => {
    const chord = chordOf(event, mac);
    if (event.defaultPrevented || isOurs(event) || !chords.has(chord)) return;
    // Else the browser would save its page, or look for text in it.
    event.preventDefault();
    send({ kind: 'key', chord });
  };
  page.addEventListener('keydown', onKeyDown);
  return {
    take: (message) => {
      chords = new Set(message.chords);
      mac = message.mac;
    },
    dispose: () => page.removeEventListener('keydown', onKeyDown),
  };
}
