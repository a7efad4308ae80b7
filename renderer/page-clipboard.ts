import type { Clipboard } from './state/editor/editor.ts';

/** The clipboard of the system. If the browser denies access, the text that this window copied last. */
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
