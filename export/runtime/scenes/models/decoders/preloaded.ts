import { Cache } from 'three';

/**
 * Runs `load`, which asks three's `FileLoader` for files at once, with their contents at hand: nothing is fetched by three, so
 * that a page may keep these files wherever it likes, in itself too.
 *
 * @param contents by address, as `load` will ask for them
 */
export function preloaded(contents: Readonly<Record<string, string | ArrayBuffer>>, load: () => unknown): void {
  const wasEnabled = Cache.enabled;
  Cache.enabled = true;
  for (const [url, content] of Object.entries(contents)) Cache.add(`file:${url}`, content);
  try {
    load();
  } finally {
    for (const url of Object.keys(contents)) Cache.remove(`file:${url}`);
    Cache.enabled = wasEnabled;
  }
}
