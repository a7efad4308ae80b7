import { mkdir, mkdtemp, readdir, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, expect, test } from '@jest/globals';
import { encode } from 'jpeg-js';
import { projectText } from '../../tests/support/project-kit.ts';
import { importCapture } from './add-capture.ts';
import { type FileLayer, NODE_FILES } from './file-layer.ts';
import { readBytes } from './read-file.ts';

let base = '';
const source = () => join(base, 'scan');
const project = () => join(base, 'project');

const IMAGE = (id: number, name: string, pose = '1 0 0 0 0 0 0') => `${id} ${pose} 1 ${name}\n\n`;
const NAMES = ['a.jpg', 'b.jpg', 'c.jpg', 'd.jpg'];

async function put(path: string, content: string | Uint8Array): Promise<void> {
  const file = join(source(), path);
  await mkdir(join(file, '..'), { recursive: true });
  await writeFile(file, content);
}

const photo = (width: number, height: number) => encode({ width, height, data: new Uint8Array(width * height * 4).fill(90) }, 90).data;

/** Four photographs of 8 × 6 pixels. */
beforeEach(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-import-'));
  await mkdir(project());
  await writeFile(join(project(), 'project.scrim.json'), projectText({ nodes: { 'screen-a1': 'output/screen' }, wires: [] }));
  await put('cameras.txt', '# comment\n1 PINHOLE 8 6 8 8 4 3\n');
  await put('images.txt', NAMES.map((name, i) => IMAGE(i + 1, name)).join(''));
  for (const name of NAMES) await put(`images/${name}`, photo(8, 6));
  await put('mesh.obj', 'v 0 0 2\nv 1 0 2\nv 0 1 2\nf 1 2 3\n');
});
afterEach(() => rm(base, { recursive: true, force: true }));

function run(interrupted = new AbortController().signal, files: FileLayer = NODE_FILES) {
  const more = { name: null, maxSidePx: 1600, up: null, metersPerUnit: 1, files, say: () => {} };
  return importCapture({ folder: source(), root: project(), ...more, interrupted });
}

test('removes the metadata of photographs, and takes another name where one is taken', async () => {
  const [plain] = [photo(8, 6)];
  const exif = Buffer.concat([plain.subarray(0, 2), Buffer.from([0xff, 0xe1, 0, 10]), Buffer.from('GPS here'), plain.subarray(2)]);
  await put('images/a.jpg', exif);
  expect(await run()).toMatchObject({ path: 'assets/scan.capture/capture.json', diagnostics: [] });
  expect(Buffer.from(await readBytes(join(project(), 'assets/scan.capture/views/000.jpg'), 1e6)).includes('GPS here')).toBe(false);
  expect((await run()).path).toBe('assets/scan-2.capture/capture.json');
});

test('warns of what it leaves out', async () => {
  await rm(join(source(), 'images/d.jpg'));
  await put('images/e.jpg', photo(8, 6));
  const { views, diagnostics } = await run();
  expect(views).toHaveLength(3);
  expect(diagnostics.map(({ message }) => message)).toEqual([
    '1 camera has no photograph, such as d.jpg.',
    '1 photograph has no camera, such as e.jpg.',
    'It has 3 photographs only, so most sides are seen once or never.',
  ]);
});

test.each([
  ['images.txt', IMAGE(1, 'a.jpg') + IMAGE(2, 'a.jpg'), 'two cameras have the photograph a.jpg'],
  ['images.txt', IMAGE(1, '../a.jpg'), '"../a.jpg" is outside the folder'],
  ['images.txt', IMAGE(1, 'a.jpg', '1 0 0 0 0 0 nan'), 'the pose of a.jpg is not finite'],
  ['images.txt', IMAGE(1, 'a.jpg', '2 0 0 0 0 0 0'), 'not a unit quaternion'],
  ['images.txt', IMAGE(1, 'missing.jpg'), 'none of its 1 photographs'],
  ['images/b.jpg', photo(6, 6), 'b.jpg is 6 × 6 pixels, but its camera 8 × 6'],
  ['images/b.jpg', 'no photograph', 'neither a JPEG nor a PNG'],
  ['mesh.obj', 'v 0 0 0', 'only points'],
  ['cameras.txt', '1 FOV 8 6 8 8 4 3 0', 'FOV is not supported'],
])('refuses %s with %j, and writes nothing', async (path, content, reason) => {
  await put(path, content);
  await expect(run()).rejects.toMatchObject({ diagnostic: { code: 'SCR069', message: expect.stringContaining(reason) } });
  expect(await readdir(join(project(), 'assets')).catch(() => [])).toEqual([]);
});

test('leaves nothing behind when it is interrupted', async () => {
  const stop = new AbortController();
  stop.abort();
  await expect(run(stop.signal)).rejects.toBe(stop.signal.reason);
  expect(await readdir(join(project(), 'assets')).catch(() => [])).toEqual([]);
});

test('leaves nothing behind when the disk is full', async () => {
  let written = 0;
  const full: FileLayer = {
    ...NODE_FILES,
    writeNew: async (path, bytes) => {
      if (++written === 3) throw Object.assign(new Error('no space left on device'), { code: 'ENOSPC' });
      await NODE_FILES.writeNew(path, bytes);
    },
  };
  await expect(run(undefined, full)).rejects.toMatchObject({ diagnostic: { message: expect.stringMatching(/full|space/i) } });
  expect(written).toBe(3);
  expect(await readdir(join(project(), 'assets')).catch(() => [])).toEqual([]);
});

test.each([
  ['v 0 0 2000\nv 1000 0 2000\nv 0 1000 2000\nf 1 2 3\n', ['The mesh has a diagonal of 1414 m. If its unit is not the meter']],
  ['v 0 0 0.002\nv 0.001 0 0.002\nv 0 0.001 0.002\nf 1 2 3\n', ['The mesh has a diagonal of 1.4 mm. If its unit is not the meter']],
  ['v 0 0 -2\nv 1 0 -2\nv 0 1 -2\nf 1 2 3\n', ['4 photographs show nothing of the mesh, such as a.jpg']],
])('warns of the mesh %j', async (mesh, reasons) => {
  await put('mesh.obj', mesh);
  const { diagnostics } = await run();
  expect(diagnostics.map(({ message }) => message)).toEqual(reasons.map((reason) => expect.stringContaining(reason)));
});
