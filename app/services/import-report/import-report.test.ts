import { mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { sampleSurface } from '../../../export/captures/points/sample-surface.ts';
import { projectText, writeProject } from '../../../tests/support/project-kit.ts';
import { scrim } from '../../../tests/support/scrim.ts';
import { SCAN_SIZE, writeTwoCameraScan } from '../../../tests/support/two-camera-scan.ts';

let base = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-import-report-'));
});
afterAll(() => rm(base, { recursive: true, force: true }));

async function writeScan(camera?: string): Promise<string> {
  const scan = join(base, 'scan');
  await writeTwoCameraScan(scan, camera);
  return scan;
}

test('shows the cameras over the mesh, and in each photograph where points were seen and are projected', async () => {
  const project = join(base, 'project');
  await writeProject(project, { 'project.scrim.json': projectText({ nodes: { 'screen-a1': 'output/screen' }, wires: [] }) });
  const out = join(base, 'report');
  const args = ['import', 'capture', await writeScan(), '--project', project, '--report', out];
  const { status, out: said } = await scrim(...args);
  expect([status, said]).toEqual([0, expect.stringContaining(`Wrote ${join(out, 'index.html')}`)]);
  const html = await readFile(join(out, 'index.html'), 'utf8');

  // The second camera is 1 m to the right, and the point 2 m away: it is projected 16 px to the left of the middle, 1 px beside 17.
  // The worst photograph is the first.
  expect(html.match(/class="seen" d="[^"]*"/g)).toEqual(['class="seen" d="M17.0 24.0h0"', 'class="seen" d="M32.0 24.0h0"']);
  expect(html.match(/class="off" d="[^"]*"/g)).toEqual(['class="off" d="M17.0 24.0l-10.0 0.0"', 'class="off" d="M32.0 24.0l0.0 0.0"']);
  expect([...html.matchAll(/<tr><td>([^<]+)<\/td><td>([^<]+)/g)].map(([, label, text]) => `${label}: ${text}`)).toEqual([
    'Files: COLMAP (text)',
    'Photographs: 2, 64 × 48 px',
    'Cameras: 2 × PINHOLE',
    'Points: 1, mean reprojection error 0.50 px',
    'Mesh: 4 vertices, 2 triangles',
    expect.stringMatching(/^Depth: depth meshes of \d+ triangles, from the mesh$/),
    'Size: 5.00 × 2.00 × 0.00 m',
    'Scale: 1 unit of the reconstruction is 1 m, assumed: the files do not say it',
    'Up: -y axis of the reconstruction',
    'Left out: nothing',
  ]);
  expect(html).toContain('Its units are taken as meters. If the size is wrong, select its node and press “Set scale by two points”');
  expect(html).toContain('a&#38;b.jpg: 0.00 px over 1 point');
  expect(html).toContain('c.jpg: 1.00 px over 1 point');
  expect((await readdir(join(out, 'views'))).map((name) => `views/${name}`).reverse()).toEqual(
    [...html.matchAll(/<img src="([^"]+)"/g)].map(([, source]) => source),
  );

  const pictures = html.split('<svg viewBox="-60');
  expect(pictures).toHaveLength(4);
  const [above = '', front = ''] = pictures.slice(1);
  const cameras = (picture: string) =>
    [...picture.matchAll(/class="camera" d="([^"]+)"/g)].map(([, lines = '']) =>
      lines
        .split(/[ML]/)
        .slice(1)
        .map((place) => place.split(' ').map(Number) as [number, number]),
    );
  // Corners of the pyramid, then its tip: the cameras look away from the reader, and up is up.
  const [first = [], second = []] = cameras(above);
  const [corner = [0, 0], eye = [0, 0], otherEye = [0, 0]] = [first[0], first[6], second[6]];
  expect(eye[1] - corner[1]).toBeCloseTo(55, 0);
  // The mesh is 5 m wide, and 1,000 units.
  expect([otherEye[0] - eye[0], otherEye[1] - eye[1]]).toEqual([expect.closeTo(200, -1), 0]);
  const [upright = []] = cameras(front);
  expect((upright[2]?.[1] ?? 0) - (upright[0]?.[1] ?? 0)).toBeCloseTo((55 * SCAN_SIZE.heightPx) / 32, 0);
  expect([...above.matchAll(/<title>([^<]+)/g)].map(([, name]) => name)).toEqual(['a&#38;b.jpg', 'c.jpg']);

  // A second import replaces the report; other files are not replaced, and then nothing is imported.
  await writeFile(join(out, 'notes.txt'), 'mine');
  expect(await scrim(...args)).toMatchObject({ status: 1, err: expect.stringContaining('notes.txt') });
  expect(await readdir(join(project, 'assets'))).toEqual(['scan.capture']);
  await rm(join(out, 'notes.txt'));
  expect(await scrim(...args)).toMatchObject({ status: 0 });
});

test('places of points in photographs whose distortion was removed are those of the straight photograph', async () => {
  const project = join(base, 'bent');
  await writeProject(project, { 'project.scrim.json': projectText({ nodes: { 'screen-a1': 'output/screen' }, wires: [] }) });
  const out = join(base, 'bent-report');
  const { status } = await scrim(
    'import',
    'capture',
    await writeScan('SIMPLE_RADIAL 64 48 32 32 24 -0.05'),
    '--project',
    project,
    '--report',
    out,
  );
  expect(status).toBe(0);
  const html = await readFile(join(out, 'index.html'), 'utf8');
  const { views } = JSON.parse(await readFile(join(project, 'assets/scan.capture/capture.json'), 'utf8')) as {
    views: { fxPx: number; cxPx: number }[];
  };
  const [second] = html.matchAll(/class="seen" d="M(\S+) /g);
  const column = Number(second?.[1]);
  // Where the lens shows 17, the direction x over its depth solves 32 x (1 − 0.05 x²) = −15.
  const x = (column - (views[1]?.cxPx ?? 0)) / (views[1]?.fxPx ?? 1);
  expect(32 * x * (1 - 0.05 * x * x)).toBeCloseTo(-15, 1);
});

test('samples a surface by area', () => {
  // A triangle of 1 m² at height 0, and one of 3 m² at height 1.
  const positions = Float32Array.of(0, 0, 0, 2, 0, 0, 0, 0, 1, 0, 1, 0, 6, 1, 0, 0, 1, 1);
  const points = sampleSurface({ positions, indices: Uint32Array.of(0, 1, 2, 3, 4, 5) }, 400);
  expect(points).toHaveLength(1200);
  const upper = points.filter((y, i) => i % 3 === 1 && y === 1);
  expect(upper).toHaveLength(300);
  for (let i = 0; i < points.length; i += 3) {
    const [x = -1, y = -1, z = -1] = points.subarray(i, i + 3);
    expect(x / (y === 1 ? 6 : 2) + z).toBeLessThanOrEqual(1.000001);
    expect(Math.min(x, z)).toBeGreaterThanOrEqual(0);
  }
  expect(sampleSurface({ positions, indices: Uint32Array.of(0, 0, 0) }, 10)).toHaveLength(0);
});
