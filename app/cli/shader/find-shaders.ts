import { readdir, stat } from 'node:fs/promises';
import { basename, join } from 'node:path';
import { UsageError } from '../command.ts';

/** As ISF files and techniques are called; a file that is named itself may be called anything. */
const SHADER = /\.(fs|isf|glsl)$/i;

/** Vertex shaders of ISF files, and how the files may be called that they belong to. */
const VERTEX = /\.vs$/i;
const FRAGMENTS = ['.fs', '.FS', '.isf', '.frag'];

/** Pieces of techniques, which are no shaders by themselves; and what others have installed. */
const PASSED_BY = ['chunks', 'node_modules'];

/**
 * The files that a command line means, once each and in order: files as they are, for a vertex shader the file it belongs to, folders with all shaders below them but what
 * is hidden or installed. Throws `UsageError` where there are none.
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

/** A vertex shader says nothing by itself: it is checked with the file that it stands beside. */
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
