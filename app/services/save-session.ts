import { readdir } from 'node:fs/promises';
import { join } from 'node:path';
import type { HostInput } from '../contract/contract.ts';
import { resolveInside } from './confine.ts';
import { refusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { type FolderMark, writePageFolder } from './page-folder.ts';
import { SESSIONS_FOLDER } from './session-list.ts';

export interface SessionToSave {
  /** Text of `session.json`. */
  readonly session: string;
  readonly images: HostInput<'session.save'>['files'];
  /** Of all images, one after another. */
  readonly bytes: Uint8Array;
}

const MARK: FolderMark = { file: 'session.json', format: 'scrim-session', words: 'a session' };

/**
 * Writes a recorded session into a folder of its own in `sessions/`, whole or not at all. Returns the folder's name, `recording` with a
 * number.
 *
 * @throws SCR031 if `sessions` is a link, SCR062 if it cannot be written, SCR073 if the lengths do not add up
 */
export async function saveSession(root: string, { session, images, bytes }: SessionToSave, files: FileLayer): Promise<string> {
  if (images.reduce((sum, image) => sum + image.bytes, 0) !== bytes.length) throw refusal('SCR073', 'The session has the wrong size.');
  const parent = await resolveInside(root, SESSIONS_FOLDER);
  const taken = new Set(await readdir(parent).catch(() => []));
  let number = 1;
  while (taken.has(`recording-${number}`)) number++;
  const name = `recording-${number}`;
  await writePageFolder(
    join(parent, name),
    files,
    async (sink) => {
      let at = 0;
      for (const image of images) {
        await sink.write(image.path, bytes.subarray(at, at + image.bytes));
        at += image.bytes;
      }
      await sink.write(MARK.file, new TextEncoder().encode(session));
      return true;
    },
    MARK,
  );
  return name;
}
