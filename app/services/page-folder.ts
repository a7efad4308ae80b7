import { randomBytes } from 'node:crypto';
import { rmSync } from 'node:fs';
import { lstat, readdir, realpath, rm } from 'node:fs/promises';
import { dirname, join, resolve } from 'node:path';
import process from 'node:process';
import type { FileSink } from '../../export/bundle/bundle-page.ts';
import { REPORT_FILE } from '../../export/bundle/report.ts';
import { errorCode, refusal, writeRefusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { makeFolders } from './make-folders.ts';
import { readText } from './read-file.ts';

/** Identifies folders that Scrim wrote, by a file in them that lists the others. */
export interface FolderMark {
  readonly file: string;
  readonly format: string;
  /** Name of such a folder in messages. */
  readonly words: string;
}

const PAGE_MARK: FolderMark = { file: REPORT_FILE, format: 'scrim-export', words: 'an earlier export' };

/**
 * Writes a page, or the content that `mark` describes, to the folder `out` in one step: writes a new folder beside `out`, which then
 * replaces `out`. `out` may be missing, empty, or the result of an earlier export (recognized by its `report.json`, or the file of the
 * mark); otherwise SCR061. If `write` returns null or throws, or the disk fails, `out` is unchanged.
 *
 * @throws SCR060, SCR061, SCR062
 */
export async function writePageFolder<T>(
  out: string,
  files: FileLayer,
  write: (sink: FileSink) => Promise<T | null>,
  mark: FolderMark = PAGE_MARK,
): Promise<T | null> {
  const target = await realTarget(out);
  await refuseForeignFiles(target, out, mark);
  let firstMade: string | undefined;
  const suffix = randomBytes(6).toString('hex');
  const fresh = `${target}.new-${suffix}`;
  const old = `${target}.old-${suffix}`;
  // On an interrupt the browser driver ends the process, without running `finally` blocks.
  const sweep = () => {
    for (const path of [fresh, ...(firstMade === undefined ? [] : [firstMade])]) rmSync(path, { recursive: true, force: true });
  };
  process.once('exit', sweep);
  try {
    firstMade = await makeFolders(dirname(target));
    await files.makeFolder(fresh);
    const result = await write(createFolderSink(fresh, files));
    if (result === null) {
      await discard(fresh, firstMade);
      return null;
    }
    await files.syncFolder(fresh);
    // From here on, `firstMade` may contain the finished page.
    process.off('exit', sweep);
    await swapInto(fresh, target, old, files);
    return result;
  } catch (error) {
    await discard(fresh, firstMade);
    throw errorCode(error) === undefined ? error : writeRefusal(error, out);
  } finally {
    process.off('exit', sweep);
  }
}

/** Resolves links of an existing folder; a missing one stays as given. */
async function realTarget(out: string): Promise<string> {
  const absolute = resolve(out);
  return realpath(absolute).catch(() => absolute);
}

async function refuseForeignFiles(target: string, out: string, mark: FolderMark): Promise<void> {
  const found = await lstat(target).catch(() => null);
  if (found === null) return;
  if (!found.isDirectory()) throw refusal('SCR061', `${out} is a file. Nothing was written.`, 'Choose a folder.');
  const present = await listAll(target).catch((error: unknown) => {
    throw writeRefusal(error, out);
  });
  const own = await filesOfReport(target, mark);
  const foreign = present.filter((path) => !own.has(path));
  if (foreign.length === 0) return;
  const others = foreign.length === 1 ? '' : ` and ${foreign.length - 1} more`;
  throw refusal(
    'SCR061',
    `${out} holds files that Scrim did not write: ${foreign[0]}${others}. Nothing was written.`,
    `Choose a new or an empty folder, or one that holds ${mark.words}.`,
  );
}

async function listAll(folder: string): Promise<string[]> {
  const paths: string[] = [];
  const walk = async (prefix: string) => {
    for (const entry of await readdir(join(folder, prefix), { withFileTypes: true })) {
      const path = prefix === '' ? entry.name : `${prefix}/${entry.name}`;
      if (entry.isDirectory()) await walk(path);
      else paths.push(path);
    }
  };
  await walk('');
  return paths.sort();
}

const MAX_REPORT_BYTES = 64 * 2 ** 20;

/** The files that an earlier export lists. */
async function filesOfReport(target: string, { file, format }: FolderMark): Promise<ReadonlySet<string>> {
  try {
    const report = JSON.parse(await readText(join(target, file), MAX_REPORT_BYTES)) as { format?: unknown; files?: { path: string }[] };
    if (report.format !== format || !report.files) return new Set();
    return new Set([file, ...report.files.map(({ path }) => path)]);
  } catch {
    return new Set();
  }
}

function createFolderSink(folder: string, files: FileLayer): FileSink {
  return {
    write: async (path, bytes) => {
      const target = join(folder, path);
      await files.makeFolder(dirname(target));
      await files.writeNew(target, bytes);
    },
  };
}

/** Puts the new folder in the place of the old one by two renames. If the second rename fails, the first is undone. */
async function swapInto(fresh: string, target: string, old: string, files: FileLayer): Promise<void> {
  const replaces = (await lstat(target).catch(() => null)) !== null;
  if (replaces) await files.rename(target, old);
  try {
    await files.rename(fresh, target);
  } catch (error) {
    if (replaces) await files.rename(old, target);
    throw error;
  }
  await files.syncFolder(dirname(target)).catch(() => {});
  if (replaces) await files.remove(old).catch(() => {});
}

/** Deletes the new folder and the created parents. Ignores failures, which must not hide the original error. */
async function discard(fresh: string, firstMade: string | undefined): Promise<void> {
  for (const path of [fresh, ...(firstMade === undefined ? [] : [firstMade])]) {
    await rm(path, { recursive: true, force: true }).catch(() => {});
  }
}
