import type { EditorClock } from './clock.ts';

/** Time after which the browser has surely started the download. */
const PATIENCE_MS = 60_000;

/** Saves a file to the downloads of the browser. Replaces characters that file names cannot contain. */
export function downloadFile(clock: Pick<EditorClock, 'after'>, file: Blob, name: string): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(file);
  link.download = name.replaceAll(/[\\/:*?"<>|]+/g, '-');
  link.click();
  clock.after(PATIENCE_MS, () => URL.revokeObjectURL(link.href));
}
