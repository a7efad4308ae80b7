import { lstat, realpath } from 'node:fs/promises';
import { join } from 'node:path';
import { errorCode, readRefusal, refusal } from './file-errors.ts';

/** The folder itself, behind whatever links lead to it: what `resolveInside` measures against. */
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
 * Absolute path of `path` inside `root`, which `realFolder` gave; what it names need not exist. Throws SCR031 for everything
 * that could lead out: `..`, absolute paths, backslashes, drive letters, NUL, percent-encoded separators, and any link on the
 * way, wherever it points.
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
 * Whether `resolveInside` takes it as a part of a path. `:` would name a drive or a stream on Windows; a percent-encoded dot or
 * slash has no honest use in a file name.
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
