import type { EditorClock } from './clock.ts';
import type { Clipboard } from './state/editor/editor.ts';

/** Time after which the URL of a download is revoked. The browser has surely started the download by then. */
const PATIENCE_MS = 60_000;

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

/** Saves a file to the downloads of the browser. Replaces characters that file names cannot contain. */
export function downloadFile(clock: Pick<EditorClock, 'after'>, file: Blob, name: string): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(file);
  link.download = name.replaceAll(/[\\/:*?"<>|]+/g, '-');
  link.click();
  clock.after(PATIENCE_MS, () => URL.revokeObjectURL(link.href));
}
