import { Cache } from 'three';

/**
 * Runs `load`, which requests files from three.js' `FileLoader` synchronously, with their contents in its cache. three.js then fetches
 * nothing, so a page can store these files anywhere, even in itself.
 *
 * @param contents Contents of the files, by the URL that `load` requests.
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
