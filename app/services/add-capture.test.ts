import { execFileSync } from 'node:child_process';
import { mkdir, mkdtemp, readdir, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import process from 'node:process';
import { afterEach, beforeEach, expect, test } from '@jest/globals';
import { decode as decodePng, encode as encodePng } from 'fast-png';
import { encode } from 'jpeg-js';
import { reportFacts } from '../../export/captures/report/capture-report.ts';
import { readCapture } from '../../nodes/kit/capture.ts';
import { projectText } from '../../tests/support/project-kit.ts';
import { type CaptureJob, importCapture } from './add-capture.ts';
import { type FileLayer, NODE_FILES } from './file-layer.ts';
import { readCaptureReport } from './import-report/read-capture-report.ts';
import { type KnownSize, UNKNOWN_SIZE } from './measure-capture.ts';
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

const DEPTH: CaptureJob['depth'] = { from: null, unit: null, kind: null };

function run(interrupted = new AbortController().signal, files: FileLayer = NODE_FILES, depth = DEPTH, known: KnownSize = UNKNOWN_SIZE) {
  const more = { name: null, maxSidePx: 1600, up: null, metersPerUnit: 1, known, depth, files, say: () => {} };
  return importCapture({ folder: source(), root: project(), sources: resolve('.'), ...more, interrupted });
}

test('removes the metadata of photographs, and takes another name where one is taken', async () => {
  const [plain] = [photo(8, 6)];
  const exif = Buffer.concat([plain.subarray(0, 2), Buffer.from([0xff, 0xe1, 0, 10]), Buffer.from('GPS here'), plain.subarray(2)]);
  await put('images/a.jpg', exif);
  expect(await run()).toMatchObject({ path: 'assets/scan.capture/capture.json', diagnostics: [] });
  expect(Buffer.from(await readBytes(join(project(), 'assets/scan.capture/views/000.jpg'), 1e6)).includes('GPS here')).toBe(false);
  expect((await run()).path).toBe('assets/scan-2.capture/capture.json');
});

test('imports the photographs of a rig, which have the same name in the folder of each camera', async () => {
  const names = ['rig/left/1.jpg', 'rig/right/1.jpg', 'rig/left/2.jpg', 'rig/right/2.jpg'];
  await put('images.txt', names.map((name, i) => IMAGE(i + 1, name)).join(''));
  for (const name of NAMES) await rm(join(source(), 'images', name));
  for (const name of names) await put(`images/${name}`, photo(8, 6));
  await put('rigs.txt', '1 2 CAMERA 1 CAMERA 2 1 1 0 0 0 -0.12 0 0\n');
  await put('frames.txt', '1 1 1 0 0 0 0 0 1 2 CAMERA 1 1 CAMERA 2 2\n');
  const { views, diagnostics } = await run();
  expect(views.map((view) => view.photo)).toEqual(names);
  expect(diagnostics).toEqual([]);
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
  const report = await readCaptureReport(join(project(), 'assets/scan.capture'));
  expect(report.record?.warnings).toEqual(diagnostics.map(({ message }) => message));
  expect(reportFacts(report)).toContainEqual({ label: 'Left out', text: 'd.jpg (no photograph); e.jpg (no camera)' });
});

test('finds photographs whose names in transforms.json lack the ending, and refuses one that two cameras have', async () => {
  const transform_matrix = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 3], [0, 0, 0, 1]]; // biome-ignore format: rows
  const cameras = (...paths: string[]) =>
    put('transforms.json', JSON.stringify({ fl_x: 8, frames: paths.map((file_path) => ({ file_path, transform_matrix })) }));
  for (const file of ['cameras.txt', 'images.txt']) await rm(join(source(), file));
  await cameras('images/a', './images/b', 'images/c.jpg', 'd');
  expect(await run()).toMatchObject({ views: [{}, {}, {}, {}], diagnostics: [] });
  await cameras('images/a', './images/b', 'images/c.jpg', 'c');
  await expect(run()).rejects.toMatchObject({ diagnostic: { message: expect.stringContaining('two cameras have the photograph c.') } });
});

test.each([
  ['images.txt', IMAGE(1, 'a.jpg') + IMAGE(2, 'a.jpg'), 'two cameras have the photograph a.jpg'],
  ['images.txt', IMAGE(1, '../a.jpg'), '"../a.jpg" is outside the folder'],
  ['images.txt', IMAGE(1, 'a.jpg', '1 0 0 0 0 0 nan'), 'the pose of a.jpg is not finite'],
  ['images.txt', IMAGE(1, 'a.jpg', '2 0 0 0 0 0 0'), 'not a unit quaternion'],
  ['images.txt', IMAGE(1, 'missing.jpg'), 'none of its 1 photographs'],
  ['images/b.jpg', photo(6, 6), 'b.jpg is 6 × 6 pixels, but its camera 8 × 6'],
  ['images/b.jpg', 'no photograph', 'neither a JPEG nor a PNG'],
  ['images/b.jpg', photo(8, 6).subarray(0, -9), 'b.jpg is damaged (its end is missing)'],
  ['mesh.obj', 'v 0 0 0', 'only points'],
  ['cameras.txt', '1 FOV 8 6 8 8 4 3 0', 'FOV is not supported'],
])('refuses %s with %j, and writes nothing', async (path, content, reason) => {
  await put(path, content);
  await expect(run()).rejects.toMatchObject({ diagnostic: { code: 'SCR069', message: expect.stringContaining(reason) } });
  expect(await readdir(join(project(), 'assets')).catch(() => [])).toEqual([]);
});

/** Named pipes would block; Windows has none in folders. */
test.each(process.platform === 'win32' ? [] : ['images/b.jpg', 'depth/b.png', 'mesh.obj', 'points3D.txt'])(
  'refuses a named pipe as %s, and writes nothing',
  async (path) => {
    await mkdir(join(source(), 'depth'));
    await rm(join(source(), path), { force: true });
    execFileSync('mkfifo', [join(source(), path)]);
    const message = `${source()} cannot be imported: ${join(source(), path)} is a named pipe, not a file.`;
    await expect(run()).rejects.toMatchObject({ diagnostic: { code: 'SCR069', message } });
    expect(await readdir(join(project(), 'assets')).catch(() => [])).toEqual([]);
  },
);

test('says which photograph was removed during the import', async () => {
  // Later than those that are read ahead.
  const names = Array.from({ length: 8 }, (_, i) => `${i}.jpg`);
  await put('images.txt', names.map((name, i) => IMAGE(i + 1, name)).join(''));
  for (const name of names) await put(`images/${name}`, photo(8, 6));
  const removed = join(source(), 'images/7.jpg');
  const writeNew: FileLayer['writeNew'] = async (path, bytes) => {
    if (path.endsWith('views/000.jpg')) await rm(removed);
    await NODE_FILES.writeNew(path, bytes);
  };
  const importing = run(undefined, { ...NODE_FILES, writeNew });
  await expect(importing).rejects.toMatchObject({
    diagnostic: { code: 'SCR069', message: expect.stringContaining(`${removed} does not exist`) },
  });
  expect(await readdir(join(project(), 'assets')).catch(() => [])).toEqual([]);
});

test('continues after an interrupt with the photographs that are not packed yet, and repacks a damaged one', async () => {
  // Distorted photographs are drawn again.
  await put('cameras.txt', '1 SIMPLE_RADIAL 8 6 8 4 3 -0.05\n');
  const packs: string[] = [];
  const writeNew: FileLayer['writeNew'] = async (path, bytes) => {
    if (path.includes('.scrim/cache')) packs.push(path);
    await NODE_FILES.writeNew(path, bytes);
  };
  const files = { ...NODE_FILES, writeNew };
  const interruption = new AbortController();
  const say = (text: string) => text.includes('(3 of 4)') && interruption.abort();
  const options = { name: null, maxSidePx: 1600, up: null, metersPerUnit: 1, known: UNKNOWN_SIZE, depth: DEPTH, files };
  const job = { ...options, folder: source(), root: project(), sources: resolve('.') };
  for (const [i, name] of NAMES.entries())
    await put(`images/${name}`, encode({ width: 8, height: 6, data: new Uint8Array(192).fill(40 * i) }, 90).data);
  const interrupted = importCapture({ ...job, say, interrupted: interruption.signal });
  await expect(interrupted).rejects.toThrow();
  const kept = packs.length;
  expect(kept).toBeGreaterThanOrEqual(2);
  expect(await readdir(join(project(), 'assets')).catch(() => [])).toEqual([]);
  await writeFile(packs[1] ?? '', (await readBytes(packs[1] ?? '', 1e6)).subarray(0, 100));
  const { path } = await importCapture({ ...job, say: () => {}, interrupted: new AbortController().signal });
  expect(packs.length).toBe(NAMES.length + 1);
  expect(readCapture(Buffer.from(await readBytes(join(project(), path), 1e6)).toString()).version).toBe(4);
  const again = await importCapture({ ...job, files: NODE_FILES, say: () => {}, interrupted: new AbortController().signal });
  for (const view of ['000', '001', '002', '003']) {
    const [a, b] = [path, again.path].map((capture) => join(project(), capture, `../views/${view}.avif`));
    expect(await readBytes(a ?? '', 1e6)).toEqual(await readBytes(b ?? '', 1e6));
  }
});

/** A place in the photographs below: the mesh is 2 units away, where a pixel is a quarter of a unit. */
const at = (column: number, row: number, photo = 'a.jpg') => ({ photo, column, row });
const sized = (known: Partial<KnownSize>) => run(undefined, NODE_FILES, DEPTH, { ...UNKNOWN_SIZE, ...known });

test('takes the scale from two points whose distance is known, and puts the floor at height 0', async () => {
  await put('images.txt', NAMES.map((name, i) => IMAGE(i + 1, `rig/${name}`)).join(''));
  for (const name of NAMES) await put(`images/rig/${name}`, photo(8, 6));
  const distance = { from: at(5, 4), to: at(6, 4, 'rig/b.jpg'), meters: 0.5 };
  const { metersPerUnit, scale, sizeM, path } = await sized({ distance, floor: at(5, 5) });
  expect(scale).toEqual({ from: 'distance', photo: 'a.jpg', meters: 0.5 });
  expect([metersPerUnit, sizeM]).toEqual([expect.closeTo(2, 5), [expect.closeTo(2, 5), expect.closeTo(2, 5), 0]]);
  // The y axis of the file points down.
  const { views } = readCapture(Buffer.from(await readBytes(join(project(), path), 1e6)).toString());
  expect(views[0]?.worldFromCamera[13]).toBeCloseTo(2 * 0.5, 5);
});

test('takes the scale from the height of a camera above the floor', async () => {
  const { metersPerUnit, scale, path } = await sized({ floor: at(5, 4), cameraHeightM: 1.5 });
  expect(scale).toEqual({ from: 'camera-height', photo: 'a.jpg', meters: 1.5 });
  expect(metersPerUnit).toBeCloseTo(6, 5);
  const folder = join(project(), path, '..');
  const { views, mesh } = readCapture(Buffer.from(await readBytes(join(folder, 'capture.json'), 1e6)).toString());
  expect(views[0]?.worldFromCamera[13]).toBeCloseTo(1.5, 5);
  // The second vertex is as high as the camera; the third is a unit below.
  const bytes = Buffer.from(await readBytes(join(folder, mesh.file), 1e6));
  expect([bytes.readFloatLE(16), bytes.readFloatLE(28)]).toEqual([expect.closeTo(1.5, 5), expect.closeTo(-4.5, 5)]);
});

test.each([
  [{ floor: at(1, 5) }, 'there is no mesh at 1,5 of a.jpg'],
  [{ floor: at(9, 1) }, '9,1 is outside of a.jpg, which has 8 × 6 pixels'],
  [{ floor: at(5, 4, 'z.jpg') }, 'it has no photograph "z.jpg", only such as a.jpg'],
  [{ distance: { from: at(5, 4), to: at(5, 4), meters: 1 } }, 'are the same'],
  [{ distance: { from: at(5, 4), to: at(6, 4), meters: 1e300 } }, 'its mesh is too large with 4e+300 meters per unit'],
  [{ floor: at(5, 2), cameraHeightM: 1 }, 'the camera of a.jpg is not above the point of the floor'],
])('refuses sizes that cannot be measured: %j', async (known, reason) => {
  await put('mesh.obj', 'v 0 0 2\nv 1 0 2\nv 0 -1 2\nv 0 1 2\nf 1 2 3\nf 1 2 4\n');
  await expect(sized(known)).rejects.toMatchObject({ diagnostic: { code: 'SCR069', message: expect.stringContaining(reason) } });
  expect(await readdir(join(project(), 'assets')).catch(() => [])).toEqual([]);
});

const depthPng = (width: number, height: number, level: number, depth: 8 | 16 = 16) => {
  const data = new (depth === 16 ? Uint16Array : Uint8Array)(width * height).fill(level);
  return encodePng({ width, height, data, depth, channels: 1 });
};

test('stores the depth of photographs in meters, and warns of those without', async () => {
  // Half the size of the photographs, and with a hole.
  const png = { width: 4, height: 3, data: new Uint16Array(12).fill(2000), depth: 16, channels: 1 } as const;
  png.data[5] = 0;
  for (const name of ['a', 'b', 'c']) await put(`depth/${name}.png`, encodePng(png));
  const { depth, scale, diagnostics } = await run();
  expect([depth, scale]).toEqual([{ unit: 'mm', kind: 'z', count: 3 }, { from: 'depth' }]);
  expect(diagnostics.map(({ message }) => message)).toEqual(['1 photograph has no depth, such as d.jpg.']);
  const folder = join(project(), 'assets/scan.capture');
  const { version, views } = readCapture(Buffer.from(await readBytes(join(folder, 'capture.json'), 1e6)).toString());
  expect([version, views[3]?.depth]).toEqual([2, undefined]);
  expect(views[0]?.depth).toMatchObject({ file: 'depths/000.png', widthPx: 4, heightPx: 3 });
  const { data } = decodePng(await readBytes(join(folder, 'depths/000.png'), 1e6));
  const metersOf = (i: number) => (data[i] ?? 0) * (views[0]?.depth?.metersPerLevel ?? 0);
  expect([metersOf(0), metersOf(5)]).toEqual([expect.closeTo(2, 3), 0]);
  expect((await run(undefined, NODE_FILES, { ...DEPTH, from: 'none' })).depth).toBeNull();
});

test.each([
  ['depth/a.png', depthPng(6, 6, 2000), 'the depth of a.jpg is 6 × 6 pixels, but the photograph 8 × 6, which has another shape'],
  ['depth/a.png', depthPng(8, 6, 0), 'the depth of a.jpg has no value above 0'],
  ['depth/a.png', depthPng(8, 6, 200, 8), 'has 8 bits, which are too few'],
  ['depth/a.png', depthPng(8, 6, 2000).subarray(0, 60), 'is not a whole PNG file'],
  ['depth/a.png', depthPng(8, 6, 9), 'in any usual unit. Choose another unit of depth'],
  ['depth/a.pfm', 'Pf\n8 6\n-1\nshort', 'a.jpg is incomplete'],
  ['stereo/depth_maps/a.jpg.geometric.bin', '8&6&3&', 'it is not a depth map'],
  ['depth/a.exr', 'no EXR', 'a.jpg is not an EXR file'],
])('refuses the depth %s, and writes nothing', async (path, content, reason) => {
  await put(path, content);
  await expect(run()).rejects.toMatchObject({ diagnostic: { code: 'SCR069', message: expect.stringContaining(reason) } });
  expect(await readdir(join(project(), 'assets')).catch(() => [])).toEqual([]);
});

test('refuses depth without a surface, where it is the only geometry', async () => {
  await rm(join(source(), 'mesh.obj'));
  const data = new Uint16Array(8 * 6);
  data[20] = 2000;
  for (const name of ['a', 'b', 'c', 'd']) await put(`depth/${name}.png`, encodePng({ width: 8, height: 6, data, depth: 16, channels: 1 }));
  await expect(run()).rejects.toMatchObject({ diagnostic: { code: 'SCR069', message: expect.stringContaining('too few neighboring') } });
  expect(await readdir(join(project(), 'assets')).catch(() => [])).toEqual([]);
});

/** Removes all but a 360° photograph of 16 × 8 pixels. */
async function onlyPanorama(width = 16): Promise<void> {
  await rm(source(), { recursive: true });
  await put('place_color.jpg', photo(width, 8));
}

test('imports a 360° photograph with its depth, which gives its height above the floor', async () => {
  await onlyPanorama();
  // A room whose walls are 3 m away, and whose floor is 1.5 m below.
  const data = Uint16Array.from({ length: 16 * 8 }, (_, i) => (i >= 16 * 7 ? 1500 : 3000));
  await put('place_depth_mm.png', encodePng({ width: 16, height: 8, data, depth: 16, channels: 1 }));
  const { form, depth, triangleCount, depthTriangles, diagnostics } = await run();
  expect([form, depth, diagnostics]).toEqual(['one 360° photograph', { unit: 'mm', kind: 'ray', count: 1 }, []]);
  // The photograph has no other mesh.
  expect(triangleCount).toBe(depthTriangles);
  const { version, views } = readCapture(Buffer.from(await readBytes(join(project(), 'assets/scan.capture/capture.json'), 1e6)).toString());
  expect([version, views[0]?.projection, views[0]?.depthMesh?.widthPx]).toEqual([2, 'equirectangular', 16]);
  expect(views[0]?.worldFromCamera.slice(12, 15)).toEqual([0, expect.closeTo(1.5, 3), 0]);
});

test('puts a 360° photograph without depth onto a floor and a dome', async () => {
  await onlyPanorama();
  const { form, depth, sizeM, diagnostics } = await run();
  expect([form, depth]).toEqual(['one 360° photograph', null]);
  expect(diagnostics.map(({ message }) => message)).toEqual([
    expect.stringContaining('without depth. So its floor is 1.6 m below the camera'),
  ]);
  // As wide and deep as the dome; from the floor to its top.
  expect(sizeM).toEqual([expect.closeTo(16, 1), expect.closeTo(9.6, 3), expect.closeTo(16, 1)]);
  const { views, mesh } = readCapture(Buffer.from(await readBytes(join(project(), 'assets/scan.capture/capture.json'), 1e6)).toString());
  expect(views.map(({ projection, worldFromCamera }) => [projection, worldFromCamera[13]])).toEqual([
    ['equirectangular', expect.closeTo(1.6, 5)],
  ]);
  const content = await readBytes(join(project(), 'assets/scan.capture', mesh.file), 1e6);
  const heights = new Float32Array(content.buffer, content.byteOffset, 3 * mesh.vertexCount).filter((_, i) => i % 3 === 1);
  expect([heights.reduce((a, b) => Math.min(a, b)), heights.reduce((a, b) => Math.max(a, b))]).toEqual([
    expect.closeTo(0, 5),
    expect.closeTo(9.6, 4),
  ]);
});

test('refuses a capture', async () => {
  await put('capture.json', '{}');
  await expect(run()).rejects.toMatchObject({
    diagnostic: { message: expect.stringContaining('it is a capture already; import the folder of photographs') },
  });
});

test('refuses what only looks like a 360° photograph, and one whose depth is asked for but missing', async () => {
  await onlyPanorama();
  await expect(run(undefined, undefined, { from: 'files', unit: null, kind: null })).rejects.toMatchObject({
    diagnostic: { message: expect.stringContaining('neither a mesh') },
  });
  await onlyPanorama(12);
  await expect(run()).rejects.toMatchObject({ diagnostic: { message: expect.stringContaining('it has no cameras') } });
});

test('imports 360° photographs beside others, with depth meshes that are drawn from the mesh', async () => {
  for (const name of ['cameras.txt', 'images.txt']) await rm(join(source(), name));
  await put('images/around.jpg', photo(32, 16));
  const transform_matrix = [
    [1, 0, 0, 0],
    [0, 1, 0, 0],
    [0, 0, 1, 0],
  ];
  const around = { transform_matrix, file_path: 'images/around.jpg', camera_model: 'EQUIRECTANGULAR' };
  await put('mesh.obj', 'v -2 -2 -2\nv 2 -2 -2\nv 2 2 -2\nv -2 2 -2\nv -2 -2 2\nv 2 -2 2\nf 1 2 3 4\nf 1 2 6 5\n');
  await put('transforms.json', JSON.stringify({ fl_x: 8, frames: [{ transform_matrix, file_path: 'images/a.jpg' }, around] }));
  const { depth, views } = await run();
  expect([depth, views]).toMatchObject([null, [{ widthPx: 8 }, { widthPx: 32 }]]);
  const text = Buffer.from(await readBytes(join(project(), 'assets/scan.capture/capture.json'), 1e6)).toString();
  expect(readCapture(text).views.map(({ projection, depthMesh }) => [projection, depthMesh?.widthPx])).toEqual([
    [undefined, 8],
    ['equirectangular', 32],
  ]);
  await put('images/around.jpg', photo(30, 16));
  await expect(run()).rejects.toMatchObject({ diagnostic: { message: expect.stringContaining('twice as wide as high') } });
});

test('refuses depth outside the folder that transforms.json names', async () => {
  for (const name of ['cameras.txt', 'images.txt']) await rm(join(source(), name));
  const pose = {
    transform_matrix: [
      [1, 0, 0, 0],
      [0, -1, 0, 0],
      [0, 0, -1, 0],
    ],
  };
  const frames = [{ ...pose, file_path: 'images/a.jpg', depth_file_path: '../secret.png' }];
  await put('transforms.json', JSON.stringify({ fl_x: 8, frames }));
  await expect(run()).rejects.toMatchObject({ diagnostic: { message: expect.stringContaining('"../secret.png" is outside the folder') } });
});

test('leaves nothing behind when it is interrupted', async () => {
  const stop = new AbortController();
  stop.abort();
  await expect(run(stop.signal)).rejects.toBe(stop.signal.reason);
  expect(await readdir(join(project(), 'assets')).catch(() => [])).toEqual([]);
});

test.each([
  ['ENOSPC', /No space is left .* Nothing was changed\.$/],
  ['EFBIG', /cannot be written: refused\. Nothing was changed\.$/],
])('leaves nothing behind when a disk refuses what is written by %s', async (code, reason) => {
  let written = 0;
  const full: FileLayer = {
    ...NODE_FILES,
    writeNew: async (path, bytes) => {
      if (++written === 3) throw Object.assign(new Error('refused'), { code });
      await NODE_FILES.writeNew(path, bytes);
    },
  };
  await expect(run(undefined, full)).rejects.toMatchObject({ diagnostic: { message: expect.stringMatching(reason) } });
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
