import { readdir, stat } from 'node:fs/promises';
import { basename, join } from 'node:path';
import { UsageError } from '../command.ts';

/** Endings of ISF files and techniques. A file that is named explicitly may have any ending. */
const SHADER = /\.(fs|isf|glsl)$/i;

/** Ending of vertex shaders, and possible endings of their ISF files. */
const VERTEX = /\.vs$/i;
const FRAGMENTS = ['.fs', '.FS', '.isf', '.frag'];

/** Folders that are skipped: chunks, which are not complete shaders, and installed packages. */
const PASSED_BY = ['chunks', 'node_modules'];

/**
 * Finds the files of a command line, each once, in order. A vertex shader stands for its ISF file; a folder for all shaders below it
 * that are not hidden or installed.
 *
 * @throws UsageError if there are none
 */
export async function findShaders(operands: readonly string[]): Promise<readonly string[]> {
  const files: string[] = [];
  for (const operand of operands) {
    const found = await stat(operand).catch(() => null);
    if (!found) throw new UsageError(`${operand} does not exist.`);
    if (!found.isDirectory()) {
      files.push(VERTEX.test(operand) ? await fragmentOf(operand) : operand);
      continue;
    }
    const inside = await shadersIn(operand);
    if (inside.length === 0) throw new UsageError(`${operand} contains no shaders (.fs, .isf or .glsl).`);
    files.push(...inside);
  }
  return [...new Set(files)];
}

/** The ISF file of a vertex shader, which cannot be checked alone. */
async function fragmentOf(vertex: string): Promise<string> {
  for (const ending of FRAGMENTS) {
    const file = vertex.replace(VERTEX, ending);
    if (await stat(file).catch(() => null)) return file;
  }
  const wanted = basename(vertex).replace(VERTEX, '.fs');
  throw new UsageError(
    `${vertex} is the vertex shader of an ISF file ${wanted}, which is missing. Put it in the same folder and check it.`,
  );
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
