import { readdir, stat } from 'node:fs/promises';
import { join } from 'node:path';
import { UsageError } from '../command.ts';

/** As ISF files and techniques are called; a file that is named itself may be called anything. */
const SHADER = /\.(fs|isf|glsl)$/i;

/** Pieces of techniques, which are no shaders by themselves; and what others have installed. */
const PASSED_BY = ['chunks', 'node_modules'];

/**
 * The files that a command line means, once each and in order: files as they are, folders with all shaders below them but what
 * is hidden or installed. Throws `UsageError` where there are none.
 */
export async function findShaders(operands: readonly string[]): Promise<readonly string[]> {
  const files: string[] = [];
  for (const operand of operands) {
    const found = await stat(operand).catch(() => null);
    if (!found) throw new UsageError(`There is no ${operand}.`);
    if (!found.isDirectory()) {
      files.push(operand);
      continue;
    }
    const inside = await shadersIn(operand);
    if (inside.length === 0) throw new UsageError(`There are no shaders in ${operand}: their names end in .fs, .isf or .glsl.`);
    files.push(...inside);
  }
  return [...new Set(files)];
}

async function shadersIn(folder: string): Promise<string[]> {
  const files: string[] = [];
  const entries = await readdir(folder, { withFileTypes: true });
  for (const entry of entries.sort((a, b) => (a.name < b.name ? -1 : 1))) {
    const path = join(folder, entry.name);
    if (entry.isDirectory() && !entry.name.startsWith('.') && !PASSED_BY.includes(entry.name)) files.push(...(await shadersIn(path)));
    if (entry.isFile() && SHADER.test(entry.name)) files.push(path);
  }
  return files;
}
