import { join } from 'node:path';
import { Readable } from 'node:stream';
import { realFolder, resolveInside } from './confine.ts';
import { dataHeaders, editorHeaders, type Origins, previewHeaders, SCRIPTS_FOLDER } from './content-policy.ts';
import { mediaTypeOf, passiveMediaTypeOf } from './media-types.ts';
import { openFile } from './read-file.ts';

export interface ContentAnswer {
  readonly status: number;
  readonly headers: Readonly<Record<string, string>>;
  readonly body: Readable;
}

/** Content of the two origins, by path. The hosts (Electron, loopback server) map addresses to it. */
export interface Content {
  /**
   * Answers a request for a file.
   *
   * @param path Path of the request, percent-encoded. A query is ignored.
   */
  answer(origin: keyof Origins, method: string, path: string): Promise<ContentAnswer>;
  /** Mounts a folder on the origin of the preview as `/NAME/`. Returns a function that unmounts it. */
  show(name: string, folder: string): () => void;
}

export interface ContentOptions {
  readonly origins: Origins;
  /** Folders of the built pages with `index.html` and `assets/`, by origin. */
  readonly pages: Readonly<Record<keyof Origins, string>>;
}

interface Found {
  readonly root: string;
  readonly path: string;
  readonly type: (path: string) => string;
  readonly headers: Record<string, string>;
}

/** Cache header for files in `assets/`. Their names contain a content hash, so they never change. */
const FOR_EVER = 'public, max-age=31536000, immutable';

export function createContent({ origins, pages }: ContentOptions): Content {
  const shown = new Map<string, string>();

  const find = (origin: keyof Origins, parts: readonly string[]): Found | null => {
    const mount = origin === 'preview' ? mountOf(shown, parts) : null;
    if (mount) {
      if (mount.rest.some((part) => part.startsWith('.'))) return null;
      return { root: mount.folder, path: mount.rest.join('/'), type: passiveMediaTypeOf, headers: dataHeaders() };
    }
    const path = parts.join('/');
    const policy = origin === 'editor' ? editorHeaders(origins) : previewHeaders(origins);
    return {
      root: pages[origin],
      path: path === '' ? 'index.html' : path,
      type: mediaTypeOf,
      headers: { ...policy, 'cache-control': parts[0] === SCRIPTS_FOLDER ? FOR_EVER : 'no-cache' },
    };
  };

  return {
    answer: async (origin, method, path) => {
      if (method !== 'GET' && method !== 'HEAD') return plain(405, 'Only GET and HEAD are answered here.');
      const parts = decodeParts(path);
      const found = parts && find(origin, parts);
      return found ? readFound(found, method === 'HEAD') : plain(404, 'Not found. No file or command has this address.');
    },
    show: (name, folder) => {
      shown.set(name, folder);
      return () => shown.delete(name);
    },
  };
}

/** Decodes `/a/b%20c?d` to `['a', 'b c']`; null if the encoding is invalid. Does not normalize: `..` is rejected later. */
function decodeParts(path: string): string[] | null {
  const bare = path.replace(/[?#].*$/s, '');
  try {
    return bare.slice(1).split('/').map(decodeURIComponent);
  } catch {
    return null;
  }
}

/** The mounted folder of a path. Mounts have two parts: `projects/KEY`, `sessions/NAME`. */
function mountOf(shown: ReadonlyMap<string, string>, parts: readonly string[]): { folder: string; rest: readonly string[] } | null {
  const folder = shown.get(parts.slice(0, 2).join('/'));
  return folder === undefined ? null : { folder, rest: parts.slice(2) };
}

async function readFound({ root, path, type, headers }: Found, headOnly: boolean): Promise<ContentAnswer> {
  try {
    const absolute = await resolveInside(await realFolder(root), path);
    const file = await openFile(absolute);
    const { size } = await file.stat();
    const answer = { ...headers, 'content-type': type(path), 'content-length': String(size) };
    if (!headOnly) return { status: 200, headers: answer, body: file.createReadStream() };
    await file.close();
    return { status: 200, headers: answer, body: Readable.from([]) };
  } catch {
    return plain(
      404,
      path === 'index.html'
        ? `Scrim is not built: ${join(root, path)} is missing. Run: npm run build`
        : 'Not found. No file or command has this address.',
    );
  }
}

/** An error response without details or scripts. */
export function plain(status: number, text: string): ContentAnswer {
  const bytes = new TextEncoder().encode(`${text}\n`);
  return {
    status,
    headers: { ...dataHeaders(), 'content-type': 'text/plain; charset=utf-8', 'content-length': String(bytes.length) },
    body: Readable.from([bytes]),
  };
}
