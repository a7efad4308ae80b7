import { mkdtemp, readdir, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, expect, test } from '@jest/globals';
import { writeProgram } from '../../../tests/support/fake-program.ts';
import { type SimplifyOptions, simplifyMesh } from './simplify-mesh.ts';

/*
 * Instant Meshes by a program that stands in for it, because no package has the real one. tests/slow/simplify.test.ts runs its algorithm, and
 * the real Blender.
 */

let base = '';
beforeEach(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-instant-'));
});
afterEach(() => rm(base, { recursive: true, force: true }));

/** Two triangles. */
const SQUARE = { positions: Float32Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0), indices: Uint32Array.of(0, 1, 2, 0, 2, 3) };
const ply = (scale: number) =>
  `ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n${scale} 0 0\n${scale} ${scale} 0\n0 ${scale} 0\n4 0 1 2 3\n`;
const WRITE = (text: string) => `fs.writeFileSync(args[args.indexOf('-o') + 1], ${JSON.stringify(text)});`;

async function simplify(script: string, more: Partial<SimplifyOptions> = {}) {
  const program = await writeProgram(join(base, 'Instant Meshes'), script);
  const options = {
    program: 'instant-meshes',
    triangles: 500,
    unwrap: false,
    format: '.ply',
    say: () => {},
    interrupted: new AbortController().signal,
  } as const;
  return { program, result: simplifyMesh(SQUARE, { ...options, path: program.path, ...more }) };
}
const left = async () => (await readdir(tmpdir())).filter((name) => name.startsWith('scrim-simplify-'));

test('Instant Meshes gets the mesh, the number of faces and the file to write, and its polygons are read', async () => {
  const before = await left();
  const { program, result } = await simplify(
    `if (!fs.readFileSync(args[0], 'latin1').includes('element face 2')) process.exit(5); ${WRITE(ply(1))}`,
  );
  const { mesh } = await result;
  expect([...mesh.indices]).toEqual([0, 1, 2, 0, 2, 3]);
  const [args] = await program.calls();
  expect(args?.slice(1)).toEqual(['-o', expect.stringMatching(/simple\.ply$/), '-f', '500', '-r', '6', '-p', '6', '-D', '-b', '-d']);
  expect(await left()).toEqual(before);
});

test.each([
  [
    'fails',
    "console.error('Unable to open file'); process.exit(-1)",
    { code: 'SCR078', message: expect.stringContaining('Unable to open file') },
  ],
  ['writes nothing', '', { code: 'SCR078', message: expect.stringContaining('without writing a mesh') }],
  ['writes no mesh', WRITE('nothing'), { code: 'SCR069', message: expect.stringContaining('not a PLY file') }],
  ['scales the mesh', WRITE(ply(3)), { code: 'SCR069', message: expect.stringContaining('another size or place') }],
])('a program that %s is refused', async (_name, script, diagnostic) => {
  const { result } = await simplify(script);
  await expect(result).rejects.toMatchObject({ diagnostic });
  for (const name of await left()) await rm(join(tmpdir(), name), { recursive: true });
});

test('a program that hangs ends when it is canceled, and leaves nothing', async () => {
  const before = await left();
  const canceled = new AbortController();
  const { result } = await simplify("console.log('scrim: Waiting'); setInterval(() => {}, 1000)", {
    interrupted: canceled.signal,
    say: (text) => text.startsWith('Waiting') && canceled.abort(),
  });
  const error = await result.catch((reason: unknown) => reason);
  expect(error).toBe(canceled.signal.reason);
  expect(await left()).toEqual(before);
});
