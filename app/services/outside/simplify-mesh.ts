import { mkdtemp, readdir, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { meshAsPly } from '../../../export/captures/write-ply.ts';
import { CaptureError, type CaptureMesh } from '../../../nodes/kit/capture.ts';
import { errorCode, refusal, writeRefusal } from '../file-errors.ts';
import { readMeshFile } from '../read-capture-folder.ts';
import { readBytes } from '../read-file.ts';
import { BLENDER_SCRIPT } from './blender-script.ts';
import { BLENDER, findTool, INSTANT_MESHES } from './outside-tools.ts';
import { runTool } from './run-tool.ts';

export const SIMPLIFIERS = { blender: BLENDER, 'instant-meshes': INSTANT_MESHES } as const;
export type Simplifier = keyof typeof SIMPLIFIERS;

export interface SimplifyOptions {
  readonly program: Simplifier;
  /** Path of the program that the user named; null: that of its setting, or in PATH. */
  readonly path: string | null;
  /** Largest number of triangles. Instant Meshes only comes close to it. */
  readonly triangles: number;
  /** Whether to unwrap the surface into texture coordinates. Blender only. */
  readonly unwrap: boolean;
  /** `.obj` keeps texture coordinates. */
  readonly format: '.ply' | '.obj';
  readonly say: (text: string) => void;
  /** Receives what the program prints. */
  readonly onLine?: (line: string) => void;
  readonly interrupted: AbortSignal;
}

export interface SimplifiedMesh {
  readonly mesh: CaptureMesh;
  /** The file of the program. */
  readonly bytes: Uint8Array<ArrayBuffer>;
}

/** How far the box around a simplified mesh may differ, relative to its diagonal. Programs that turn or scale a mesh differ by far more. */
const BOX_TOLERANCE = 0.1;
const MAX_FILE_BYTES = 2 ** 30;

/**
 * Makes a mesh of fewer triangles with a program of others.
 *
 * @throws SCR060, SCR062, SCR069 if the result is no such mesh, SCR078
 */
export async function simplifyMesh(mesh: CaptureMesh, options: SimplifyOptions): Promise<SimplifiedMesh> {
  const { program, path, say, onLine } = options;
  const { title } = SIMPLIFIERS[program];
  const tool = await findTool(SIMPLIFIERS[program], path);
  const folder = await mkdtemp(join(tmpdir(), 'scrim-simplify-')).catch((error: unknown) => {
    throw writeRefusal(error, tmpdir());
  });
  let keep = false;
  try {
    const input = join(folder, 'mesh.ply');
    const output = join(folder, `simple${options.format}`);
    const log = join(folder, 'output.log');
    await writeFile(input, meshAsPly(mesh));
    say(`Simplifying the mesh with ${title}…`);
    const each = (line: string) => {
      onLine?.(line);
      sayLine(line, say);
    };
    const run = { tool, log, interrupted: options.interrupted, onLine: each };
    try {
      await runTool({ ...run, args: await argumentsFor(options, folder, input, output) });
    } catch (error) {
      // The log of a failure stays for people.
      keep = !options.interrupted.aborted && errorCode(error) === undefined;
      throw error;
    }
    if (!(await readdir(folder)).includes(basename(output))) {
      keep = true;
      throw refusal('SCR078', `${title} ended without writing a mesh.`, `Read ${log}.`);
    }
    const simple = await readMeshFile(folder, basename(output));
    if (!isSamePlace(mesh, simple)) throw new CaptureError(`the mesh of ${title} has another size or place than the one before`);
    return { mesh: simple, bytes: await readBytes(output, MAX_FILE_BYTES) };
  } catch (error) {
    if (error instanceof CaptureError) throw refusal('SCR069', `The simplified mesh cannot be used: ${error.message}.`);
    throw errorCode(error) === undefined ? error : writeRefusal(error, folder);
  } finally {
    if (!keep) await rm(folder, { recursive: true, force: true });
  }
}

async function argumentsFor(
  { program, triangles, unwrap }: SimplifyOptions,
  folder: string,
  input: string,
  output: string,
): Promise<string[]> {
  // Instant Meshes: triangles (-r 6 -p 6) of a whole mesh, without the subdivision that makes them all regular (-D), edges of holes kept (-b).
  if (program === 'instant-meshes') return [input, '-o', output, '-f', String(triangles), '-r', '6', '-p', '6', '-D', '-b', '-d'];
  const script = join(folder, 'simplify.py');
  await writeFile(script, BLENDER_SCRIPT);
  const own = [input, output, String(triangles), unwrap ? '1' : '0'];
  return ['--background', '--factory-startup', '--python-exit-code', '3', '--python', script, '--', ...own];
}

/** Programs that are something else may wait for input. */
const ANSWER_MS = 60_000;

/** How a program says what it is. */
const ANSWERS: Readonly<Record<Simplifier, { readonly args: readonly string[]; readonly says: RegExp }>> = {
  blender: { args: ['--version'], says: /^Blender (\d[\w.]*)/ },
  // It has no version, and fails when it prints its options.
  'instant-meshes': { args: ['--help'], says: /^Syntax: .* <input mesh( )/ },
};

/**
 * Asks a program what it is.
 *
 * @param path Of its executable file.
 * @returns Its version; empty if it has none.
 * @throws SCR078 if the file is something else
 */
export async function simplifierVersion(program: Simplifier, path: string, interrupted: AbortSignal): Promise<string> {
  const { title, url } = SIMPLIFIERS[program];
  const { args, says } = ANSWERS[program];
  const lines = await runTool({ tool: path, args, log: null, limitMs: ANSWER_MS, anyStatus: true, onLine: () => {}, interrupted });
  const found = lines.map((line) => says.exec(line)).find((match) => match !== null);
  if (found === undefined) throw refusal('SCR078', `${path} is not ${title}.`, `Name the executable file of ${title}, or get it: ${url}`);
  return (found[1] ?? '').trim();
}

function sayLine(line: string, say: (text: string) => void): void {
  const [, words] = /^scrim: (.*)/.exec(line) ?? [];
  if (words !== undefined) say(`${words}…`);
}

function isSamePlace(a: CaptureMesh, b: CaptureMesh): boolean {
  const [boxA, boxB] = [boxOf(a), boxOf(b)];
  const diagonal = Math.hypot(...[0, 1, 2].map((axis) => (boxA[axis + 3] ?? 0) - (boxA[axis] ?? 0)));
  return boxA.every((value, i) => Math.abs(value - (boxB[i] ?? 0)) <= BOX_TOLERANCE * diagonal);
}

/** Least x, y, z, then the greatest. */
function boxOf({ positions }: CaptureMesh): readonly number[] {
  const box = [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];
  positions.forEach((value, i) => {
    const axis = i % 3;
    box[axis] = Math.min(box[axis] ?? value, value);
    box[axis + 3] = Math.max(box[axis + 3] ?? value, value);
  });
  return box;
}
