import type { Clipboard } from './state/editor/editor.ts';

/** The system's clipboard; where the browser forbids it, what this window copied itself. */
export function createPageClipboard(system: globalThis.Clipboard | undefined): Clipboard {
  let own = '';
  return {
    read: () => (system ? system.readText().catch(() => own) : Promise.resolve(own)),
    write: async (text) => {
      own = text;
      await system?.writeText(text).catch(() => {});
    },
  };
}
