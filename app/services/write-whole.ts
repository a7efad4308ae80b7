import { rename, rm, writeFile } from 'node:fs/promises';
import { writeRefusal } from './file-errors.ts';

/** Writes a file in one step: it is whole or as before. @throws SCR060, SCR062 */
export async function writeWhole(path: string, bytes: Uint8Array): Promise<void> {
  const part = `${path}.part`;
  try {
    await writeFile(part, bytes);
    await rename(part, path);
  } catch (error) {
    await rm(part, { force: true });
    throw writeRefusal(error, path);
  }
}
