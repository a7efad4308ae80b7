import type { EditorClock } from './clock.ts';

/** Long enough for any browser to have begun. */
const PATIENCE_MS = 60_000;

/** Puts a file where the person's downloads go. */
export function downloadFile(clock: Pick<EditorClock, 'after'>, file: Blob, name: string): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(file);
  link.download = name.replaceAll(/[\\/:*?"<>|]+/g, '-');
  link.click();
  clock.after(PATIENCE_MS, () => URL.revokeObjectURL(link.href));
}
