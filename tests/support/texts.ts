import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { dirname, join, relative } from 'node:path';
import { expect } from '@jest/globals';
import { refreshCommand, TESTS_FOLDER, updatesGoldens } from './this-test.ts';

/**
 * Compares with the golden text `tests/compile/goldens/NAME`, where NAME includes the ending. `UPDATE_GOLDENS=1` writes it instead,
 * and prints the names of changed ones.
 */
export async function expectText(name: string, actual: string): Promise<void> {
  const path = join(TESTS_FOLDER, 'compile', 'goldens', name);
  const golden = await readFile(path, 'utf8').catch(() => null);
  if (golden === actual) return;
  const shown = relative(process.cwd(), path);
  if (updatesGoldens()) {
    await mkdir(dirname(path), { recursive: true });
    await writeFile(path, actual);
    process.stderr.write(`${golden === null ? 'new' : 'changed'}: ${shown}\n`);
    return;
  }
  if (golden === null) throw new Error(`There is no golden text ${shown} yet. To write it: ${refreshCommand()}`);
  try {
    expect(actual).toBe(golden);
  } catch (error) {
    throw new Error(`${shown} differs.\n${(error as Error).message}\nIf the new text is right: ${refreshCommand()}`);
  }
}
