import { lstat, realpath } from 'node:fs/promises';
import { join } from 'node:path';
import { errorCode, readRefusal, refusal } from './file-errors.ts';

/** Resolves all links of a folder’s path. The result is the `root` of `resolveInside`. */
export async function realFolder(path: string): Promise<string> {
  try {
    const real = await realpath(path);
    if (!(await lstat(real)).isDirectory()) throw refusal('SCR004', `${path} is not a folder.`);
    return real;
  } catch (error) {
    throw errorCode(error) === undefined ? error : readRefusal(error, path);
  }
}

/**
 * Resolves a project path inside `root`. The file need not exist.
 *
 * @param root Result of `realFolder`.
 * @throws SCR031 for paths that could lead outside: `..`, absolute paths, backslashes, drive letters, NUL, percent-encoded
 * separators, and links anywhere in the path
 */
export async function resolveInside(root: string, path: string): Promise<string> {
  const parts = path.split('/');
  if (!parts.every(isPlainName)) throw outside(path);
  let current = root;
  for (const part of parts) {
    current = join(current, part);
    const found = await lstat(current).catch((error: unknown) => {
      if (errorCode(error) === 'ENOENT') return null;
      throw readRefusal(error, path);
    });
    if (found === null) break;
    if (found.isSymbolicLink()) throw outside(path);
  }
  return join(root, ...parts);
}

/**
 * Whether `resolveInside` accepts a part of a path. `:` would name a drive or stream on Windows; percent-encoded dots and slashes do
 * not occur in valid names.
 */
export function isPlainName(part: string): boolean {
  return part !== '' && part !== '.' && part !== '..' && !/[\\:\0]|%(2e|2f|5c|00)/i.test(part);
}

function outside(path: string) {
  return refusal(
    'SCR031',
    `${JSON.stringify(path)} is outside the project folder.`,
    'Copy the file into the project; links and ".." are not followed.',
  );
}
