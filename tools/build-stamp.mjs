import { createHash } from 'node:crypto';
import { mkdirSync, readdirSync, readFileSync, renameSync, statSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import process from 'node:process';

/**
 * Tells whether something was built from the files as they are now. A file counts as unchanged when size and time are those of
 * the stamp, or else when its hash is: 700 files are looked at in some 10 ms, and a fresh checkout of the same text builds nothing.
 *
 * @typedef {Record<string, [size: number, timeMs: number, hash: string]>} Stamp Path below the root → the file as it was built.
 */

const SKIPPED_NAMES = new Set(['node_modules', '.git', 'dist']);

/**
 * @param {string} root
 * @param {string} stampFile
 * @param {readonly string[]} sources Files and folders, relative to `root`; tests in them do not count.
 * @returns {{ fresh: boolean, stamp: Stamp }} The stamp to write after building.
 */
export function checkStamp(root, stampFile, sources) {
  const old = readStamp(stampFile);
  const stamp = {};
  let fresh = true;
  for (const path of sources.flatMap((source) => listFiles(root, source))) {
    const { size, mtimeMs } = statSync(join(root, path));
    const before = old[path];
    const same = before !== undefined && before[0] === size && before[1] === mtimeMs;
    stamp[path] = [size, mtimeMs, same ? before[2] : hashOf(join(root, path))];
    if (before?.[2] !== stamp[path][2]) fresh = false;
  }
  if (Object.keys(old).length !== Object.keys(stamp).length) fresh = false;
  return { fresh, stamp };
}

/** @param {string} stampFile @param {Stamp} stamp */
export function writeStamp(stampFile, stamp) {
  mkdirSync(dirname(stampFile), { recursive: true });
  const temporary = `${stampFile}.${process.pid}`;
  writeFileSync(temporary, JSON.stringify(stamp));
  renameSync(temporary, stampFile);
}

/** @param {string} stampFile @returns {Stamp} */
function readStamp(stampFile) {
  try {
    return JSON.parse(readFileSync(stampFile, 'utf8'));
  } catch {
    return {};
  }
}

/** @param {string} root @param {string} path @returns {string[]} */
function listFiles(root, path) {
  const entry = statSync(join(root, path), { throwIfNoEntry: false });
  if (!entry) return [];
  if (!entry.isDirectory()) return [path];
  return readdirSync(join(root, path), { withFileTypes: true }).flatMap(({ name }) =>
    SKIPPED_NAMES.has(name) || /\.test\.tsx?$/.test(name) ? [] : listFiles(root, `${path}/${name}`),
  );
}

/** @param {string} file @returns {string} */
function hashOf(file) {
  return createHash('sha256').update(readFileSync(file)).digest('hex').slice(0, 16);
}
