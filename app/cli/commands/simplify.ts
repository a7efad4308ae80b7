import { lstat } from 'node:fs/promises';
import { basename, dirname, extname, resolve } from 'node:path';
import { CAPTURE_FILE, CAPTURE_LIMITS, CaptureError } from '../../../nodes/kit/capture.ts';
import { readRefusal, refusal } from '../../services/file-errors.ts';
import { BLENDER, INSTANT_MESHES } from '../../services/outside/outside-tools.ts';
import { simplifyCapture } from '../../services/outside/simplify-capture.ts';
import { SIMPLIFIERS, type Simplifier, type SimplifyOptions, simplifyMesh } from '../../services/outside/simplify-mesh.ts';
import { readMeshFile } from '../../services/read-capture-folder.ts';
import { writeWhole } from '../../services/write-whole.ts';
import { type Call, type Command, type Context, UsageError } from '../command.ts';

const PROGRAMS = Object.keys(SIMPLIFIERS) as Simplifier[];

export const simplifyCommand: Command = {
  name: 'simplify',
  usage: 'MESH --triangles N --out FILE',
  summary: 'Simplify a mesh or a capture, with Blender',
  doc: `Makes a mesh (PLY, OBJ or glTF) smaller with Blender (${BLENDER.url}) or Instant Meshes (${INSTANT_MESHES.url}), and writes it to FILE (.ply or .obj). Only the shape is kept. Given a capture of a project (assets/NAME.capture), replaces its mesh. The result is checked as in an import; it must be where the mesh was.`,
  project: 'required',
  operand: { word: 'MESH', doc: 'the file of the mesh, or the folder of a capture in a project' },
  options: {
    triangles: { type: 'string', value: 'N', doc: 'Largest number of triangles. Instant Meshes only comes close to it.' },
    out: {
      type: 'string',
      value: 'FILE',
      doc: 'File of the simplified mesh: .ply, or .obj, which keeps texture coordinates. Not for captures.',
    },
    unwrap: { type: 'boolean', doc: 'Unwraps the surface into texture coordinates (Blender, .obj).' },
    program: { type: 'string', value: 'NAME', doc: `${PROGRAMS.join(' or ')}. Default: ${PROGRAMS[0]}.` },
    path: {
      type: 'string',
      value: 'PATH',
      doc: `The executable file of the program. Default: that of the environment variable ${BLENDER.setting} or ${INSTANT_MESHES.setting}, else in PATH.`,
    },
  },
  examples: [
    { line: 'scrim simplify scan/dense/0/meshed-poisson.ply --triangles 100000 --out scan/mesh.ply', says: 'Before the import.' },
    { line: 'scrim simplify my-room/assets/scan.capture --triangles 50000', says: 'After it.' },
    { line: 'scrim simplify vase.glb --triangles 5000 --unwrap --out vase.obj', says: 'With texture coordinates, to paint on.' },
  ],
  run: async (call, context) => {
    const options = simplifyOptions(call, context);
    if (options === null) throw new UsageError('The number of triangles is missing: add --triangles N.');
    const input = resolve(call.project);
    const isFolder = (await lstat(input).catch((error: unknown) => Promise.reject(readRefusal(error, input)))).isDirectory();
    const out = call.text('out');
    if (isFolder || basename(input) === CAPTURE_FILE) {
      if (out !== null || options.unwrap) throw new UsageError('The mesh of a capture is replaced: leave out --out and --unwrap.');
      const folder = isFolder ? input : dirname(input);
      const { before, after } = await simplifyCapture(folder, async (mesh) => (await simplifyMesh(mesh, options)).mesh);
      return outcome(folder, before, after);
    }
    if (out === null) throw new UsageError('The file of the simplified mesh is missing: add --out FILE.');
    const format = extname(out).toLowerCase();
    if (format !== '.ply' && format !== '.obj')
      throw new UsageError(`--out needs a file that ends in .ply or .obj, not ${JSON.stringify(out)}.`);
    if (options.unwrap && format !== '.obj')
      throw new UsageError('--unwrap needs a file that ends in .obj, which keeps texture coordinates.');
    const mesh = await readMeshFile(dirname(input), basename(input)).catch((error: unknown) => {
      throw error instanceof CaptureError ? refusal('SCR069', `${input} cannot be read: ${error.message}.`) : readRefusal(error, input);
    });
    const simple = await simplifyMesh(mesh, { ...options, format });
    await writeWhole(resolve(out), simple.bytes);
    return outcome(out, mesh.indices.length / 3, simple.mesh.indices.length / 3);
  },
};

function outcome(path: string, before: number, after: number) {
  const text = before === after ? `${path} has ${after} triangles, as before.` : `${path} has ${after} triangles instead of ${before}.`;
  return { status: 0 as const, json: { ok: true, path, before, after }, text, diagnostics: [] };
}

/** The options of a call. Null: nothing is to be simplified. */
export function simplifyOptions(call: Call, { say, interrupted }: Pick<Context, 'say' | 'interrupted'>): SimplifyOptions | null {
  const typed = call.text('program');
  const program = typed === null ? 'blender' : PROGRAMS.find((name) => name === typed);
  if (!program) throw new UsageError(`--program needs ${PROGRAMS.join(' or ')}, not ${JSON.stringify(typed)}.`);
  const unwrap = call.flag('unwrap');
  if (unwrap && program !== 'blender') throw new UsageError('--unwrap needs Blender: leave out --program.');
  const text = call.text('triangles');
  if (text === null) return null;
  const triangles = Number(text);
  if (!Number.isInteger(triangles) || triangles < 4 || triangles > CAPTURE_LIMITS.triangles) {
    throw new UsageError(`--triangles needs a whole number from 4 to ${CAPTURE_LIMITS.triangles}, not ${JSON.stringify(text)}.`);
  }
  return { program, path: call.text('path'), triangles, unwrap, format: '.ply', say, interrupted };
}
