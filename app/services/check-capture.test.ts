import { execFileSync } from 'node:child_process';
import { cp, mkdir, mkdtemp, open, readFile, rm, stat, symlink, truncate, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import process from 'node:process';
import { afterEach, beforeEach, expect, test } from '@jest/globals';
import { captureMeshFile } from '../../nodes/kit/capture.ts';
import { scrim } from '../../tests/support/scrim.ts';
import { checkAssets } from './check-assets.ts';
import { readRephotographed } from './rephotograph/rephotograph-report.ts';

const FOLDER = 'assets/glossy-ball.capture';
let root = '';
const at = (file: string) => join(root, FOLDER, file);

beforeEach(async () => {
  root = await mkdtemp(join(tmpdir(), 'scrim-check-capture-'));
  await cp(resolve('nodes/source/capture/example'), root, { recursive: true });
});
afterEach(() => rm(root, { recursive: true, force: true }));

/** Writes over a part of a file, whose size stays. */
async function overwrite(file: string, position: number, values: Float32Array | Uint32Array | Uint8Array): Promise<void> {
  const opened = await open(file, 'r+');
  await opened.write(new Uint8Array(values.buffer), 0, values.byteLength, position);
  await opened.close();
}

async function said(): Promise<string[]> {
  const found = await checkAssets(root, { ball: { path: `${FOLDER}/capture.json`, kind: 'capture' } }, new Set(['ball']));
  return found.map(({ severity, code, message }) => `${severity} ${code} ${message}`);
}

test('a whole capture has no problem, also without its files of depth', async () => {
  expect(await said()).toEqual([]);
  await rm(at('depths'), { recursive: true, force: true });
  expect(await said()).toEqual([]);
});

test.each<readonly [string, (file: string) => unknown, unknown]>([
  ['views/003.jpg', (file) => rm(file), 'error SCR030 assets/glossy-ball.capture/views/003.jpg is missing from the project folder.'],
  ['views/003.jpg', (file) => truncate(file, 0), 'error SCR032 assets/glossy-ball.capture/views/003.jpg is empty.'],
  ['mesh.bin', (file) => rm(file), 'error SCR030 assets/glossy-ball.capture/mesh.bin is missing from the project folder.'],
  [
    'mesh.bin',
    (file) => truncate(file, 500),
    'error SCR032 assets/glossy-ball.capture/mesh.bin has 500 bytes, but capture.json says 126456.',
  ],
  [
    'mesh.bin',
    (file) => overwrite(file, 12 * 17 + 4, Float32Array.of(Number.NaN)),
    'error SCR032 assets/glossy-ball.capture/mesh.bin is damaged at byte 208: vertex 17 is not finite.',
  ],
  [
    'mesh.bin',
    (file) => overwrite(file, 126_456 - 4, Uint32Array.of(1_000_000)),
    expect.stringMatching(
      /^error SCR032 \S+mesh.bin is damaged at byte 126452: triangle \d+ has a corner at 1000000, but there are \d+ vertices\.$/,
    ),
  ],
  [
    'views/003.jpg',
    async (file) => truncate(file, (await stat(file)).size - 40),
    'error SCR032 assets/glossy-ball.capture/views/003.jpg is incomplete.',
  ],
  [
    'views/003.jpg',
    async (file) => overwrite(file, (await stat(file)).size >> 1, new Uint8Array((await stat(file)).size >> 1)),
    'error SCR032 assets/glossy-ball.capture/views/003.jpg is incomplete.',
  ],
  [
    'views/003.jpg',
    (file) => overwrite(file, 0, new Uint8Array(16)),
    'error SCR032 assets/glossy-ball.capture/views/003.jpg is damaged or has an unsupported format.',
  ],
  [
    'capture.json',
    (file) => writeFile(file, '{}'),
    'error SCR032 assets/glossy-ball.capture/capture.json is not a valid capture: it is not a capture',
  ],
])('names a damaged %s: %#', async (file, damage, reason) => {
  await damage(at(file));
  expect(await said()).toEqual([typeof reason === 'string' ? expect.stringContaining(reason) : reason]);
});

(process.platform === 'win32' ? test.skip : test)('does not read named pipes and links', async () => {
  await rm(at('views/003.jpg'));
  execFileSync('mkfifo', [at('views/003.jpg')]);
  expect(await said()).toEqual([`error SCR030 ${FOLDER}/views/003.jpg is a named pipe, not a file.`]);
  await rm(at('views/003.jpg'));
  await symlink('/etc/hostname', at('views/003.jpg'));
  expect(await said()).toEqual([`error SCR031 "${FOLDER}/views/003.jpg" is outside the project folder.`]);
});

test('names a damaged depth mesh, and what to do', async () => {
  const document = JSON.parse(await readFile(at('capture.json'), 'utf8')) as { version: number; views: Record<string, unknown>[] };
  const [view] = document.views;
  if (!view) throw new Error('The capture has no views.');
  // Three vertices and a triangle, on a map of 4 × 4 pixels.
  const mesh = { file: 'depth-meshes/000.bin', widthPx: 4, heightPx: 4, vertexCount: 3, triangleCount: 1 };
  Object.assign(view, { depthMesh: mesh });
  document.version = 2;
  await writeFile(at('capture.json'), JSON.stringify(document));
  await mkdir(at('depth-meshes'));
  const content = (place: number, depthM: number, corner: number): Uint8Array => {
    const data = new DataView(new ArrayBuffer(36));
    for (const vertex of [0, 1, 2]) data.setFloat32(8 * vertex + 4, 1, true);
    data.setUint16(8 * 2 + 2, place, true);
    data.setFloat32(8 * 2 + 4, depthM, true);
    data.setUint32(32, corner, true);
    return new Uint8Array(data.buffer);
  };
  const cases = [
    [content(8, 0.5, 2), []],
    [content(9, 0.5, 2), ['byte 16: vertex 2 is outside its map']],
    [content(8, 0, 2), ['byte 20: vertex 2 has no depth above 0']],
    [content(8, Number.POSITIVE_INFINITY, 2), ['byte 20: vertex 2 is not finite']],
    [content(8, 0.5, 3), ['byte 32: triangle 0 has a corner at 3, but there are 3 vertices']],
  ] as const;
  for (const [bytes, places] of cases) {
    await writeFile(at(mesh.file), bytes);
    expect(await said()).toEqual(places.map((place) => `error SCR032 ${FOLDER}/${mesh.file} is damaged at ${place}.`));
  }
});

test('damage beyond the first piece that is read is found at its place', async () => {
  const positions = new Float32Array(3 * 200_000);
  positions[3 * 150_000 + 2] = Number.POSITIVE_INFINITY;
  await writeFile(at('mesh.bin'), captureMeshFile({ positions, indices: Uint32Array.of(0, 1, 2) }));
  const document = JSON.parse(await readFile(at('capture.json'), 'utf8')) as { mesh: object };
  Object.assign(document.mesh, { vertexCount: 200_000, triangleCount: 1 });
  await writeFile(at('capture.json'), JSON.stringify(document));
  expect(await said()).toEqual([`error SCR032 ${FOLDER}/mesh.bin is damaged at byte 1800008: vertex 150000 is not finite.`]);
});

test('damaged files end an export with their place and the remedy', async () => {
  await overwrite(at('mesh.bin'), 0, Float32Array.of(Number.NaN));
  const exported = await scrim('export', root, '--out', join(root, 'site'));
  expect(exported).toMatchObject({ status: 1, err: expect.stringContaining('mesh.bin is damaged at byte 0: vertex 0 is not finite.') });
  expect(exported.err).toContain('Import the capture again.');
});

test('a missing photograph ends an export and a rephotography with its name', async () => {
  await rm(at('views/003.jpg'));
  const exported = await scrim('export', root, '--out', join(root, 'site'));
  const missing = `${FOLDER}/views/003.jpg is missing from the project folder.`;
  expect(exported).toMatchObject({ status: 1, err: expect.stringContaining(`SCR030: ${missing}`) });
  // The poster is not drawn before.
  expect(exported.err).not.toContain('SCR065');
  await expect(readRephotographed(join(root, FOLDER))).rejects.toMatchObject({
    diagnostic: { code: 'SCR032', message: expect.stringContaining('views/003.jpg is missing') },
  });
});
