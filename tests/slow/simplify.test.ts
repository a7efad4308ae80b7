import { cp, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { simplifyMesh } from '../../app/services/outside/simplify-mesh.ts';
import { readObj } from '../../export/captures/mesh-obj.ts';
import { readPly } from '../../export/captures/mesh-ply.ts';
import { meshAsPly } from '../../export/captures/write-ply.ts';
import { type CaptureMesh, readCapture, readCaptureMesh } from '../../nodes/kit/capture.ts';
import { describeWithBlender } from '../support/blender.ts';
import { writeInstantMeshes } from '../support/instant-meshes.ts';
import { projectText, writeProject } from '../support/project-kit.ts';
import { describeWithInstantMeshes } from '../support/python.ts';
import { scrim } from '../support/scrim.ts';
import { farthest, torus } from '../support/torus.ts';

/** Signed volume: negative for a mesh that is inside out. */
function volume({ positions, indices }: CaptureMesh): number {
  const corner = (i: number) => [...positions.subarray(3 * (indices[i] ?? 0), 3 * (indices[i] ?? 0) + 3)] as [number, number, number];
  let sum = 0;
  for (let i = 0; i < indices.length; i += 3) {
    const [[ax, ay, az], [bx, by, bz], [cx, cy, cz]] = [corner(i), corner(i + 1), corner(i + 2)];
    sum += (ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)) / 6;
  }
  return sum;
}

describeWithBlender('scrim simplify', () => {
  let base = '';
  const whole = torus(160, 60);
  beforeAll(async () => {
    base = await mkdtemp(join(tmpdir(), 'scrim-blender-'));
    await writeFile(join(base, '-ring ö.ply'), meshAsPly(whole));
  });
  afterAll(() => rm(base, { recursive: true, force: true }));

  test('gives a mesh of fewer triangles on the same surface, in the same place', async () => {
    const out = join(base, 'few.ply');
    const { status, out: said, err } = await scrim('simplify', join(base, '-ring ö.ply'), '--triangles', '1500', '--out', out);
    expect([status, err]).toEqual([0, '']);
    expect(said).toMatch(/has (1[45]\d\d) triangles instead of 19200/);
    const few = readPly(await readFile(out));
    expect(few.indices.length / 3).toBeLessThanOrEqual(1500);
    expect(few.indices.length / 3).toBeGreaterThan(1400);
    expect(farthest(few)).toBeLessThan(0.02);
    expect(volume(few) / volume(whole)).toBeCloseTo(1, 1);
  });

  test('unwraps it into texture coordinates', async () => {
    const out = join(base, 'ring.obj');
    const { status, err } = await scrim('simplify', join(base, '-ring ö.ply'), '--triangles', '800', '--unwrap', '--out', out);
    expect([status, err]).toEqual([0, '']);
    const text = await readFile(out, 'utf8');
    const uvs = [...text.matchAll(/^vt (\S+) (\S+)$/gm)].map(([, u, v]) => [Number(u), Number(v)] as const);
    expect(uvs.length).toBeGreaterThan(400);
    expect(uvs.every(([u, v]) => u >= 0 && u <= 1 && v >= 0 && v <= 1)).toBe(true);
    // Parts of the surface do not lie on one another: the square has room for all.
    const mesh = readObj(await readFile(out));
    expect(mesh.indices.length / 3).toBeLessThanOrEqual(800);
    expect(farthest(mesh)).toBeLessThan(0.04);
  });

  test('replaces the mesh of a capture, and reduces that of an import', async () => {
    const project = join(base, 'project');
    await writeProject(project, { 'project.scrim.json': projectText({ nodes: { 'screen-a1': 'output/screen' }, wires: [] }) });
    await cp('nodes/source/capture-mesh/example/assets/glossy-ball.capture', join(project, 'assets/ball.capture'), { recursive: true });
    const capture = join(project, 'assets/ball.capture');
    const before = readCapture(await readFile(join(capture, 'capture.json'), 'utf8'));
    const { status, err } = await scrim('simplify', capture, '--triangles', '300');
    expect([status, err]).toEqual([0, '']);
    const after = readCapture(await readFile(join(capture, 'capture.json'), 'utf8'));
    expect(after.views).toEqual(before.views);
    expect(after.mesh.triangleCount).toBeLessThanOrEqual(300);
    const bytes = await readFile(join(capture, after.mesh.file));
    readCaptureMesh(after.mesh, Uint8Array.from(bytes).buffer);
    expect((await readdir(capture)).filter((name) => name.startsWith('mesh'))).toEqual([after.mesh.file]);
  });
});

describeWithInstantMeshes('scrim simplify with Instant Meshes', () => {
  let base = '';
  let program = '';
  const whole = torus(160, 60);
  beforeAll(async () => {
    base = await mkdtemp(join(tmpdir(), 'scrim-instant-'));
    program = await writeInstantMeshes(join(base, 'Instant Meshes'));
    await writeFile(join(base, 'ring ö.ply'), meshAsPly(whole));
  });
  afterAll(() => rm(base, { recursive: true, force: true }));
  const simplify = (out: string) =>
    scrim(
      ...['simplify', join(base, 'ring ö.ply'), '--program', 'instant-meshes', '--path', program],
      ...['--triangles', '1500', '--out', out],
    );

  test.each([
    ['few.ply', readPly],
    ['few.obj', readObj],
  ] as const)('writes %s: about as many even triangles as asked, on the same surface', async (name, read) => {
    const { status, out: said, err } = await simplify(join(base, name));
    expect([status, err]).toEqual([0, '']);
    const few = read(await readFile(join(base, name)));
    const count = few.indices.length / 3;
    expect(said).toContain(`has ${count} triangles instead of 19200`);
    expect(Math.abs(count - 1500)).toBeLessThan(150);
    // Vertices are on the facets of the mesh before, which are up to 0.0006 within the torus.
    expect(farthest(few)).toBeLessThan(0.005);
    // A tube of some 18 flat sides has 2 % less volume than a round one.
    expect(Math.abs(volume(few) / volume(whole) - 1)).toBeLessThan(0.03);
    // Each edge has two triangles: the surface has no holes.
    const edges = new Map<string, number>();
    few.indices.forEach((from, i) => {
      const to = few.indices[i % 3 === 2 ? i - 2 : i + 1] ?? 0;
      const key = `${Math.min(from, to)} ${Math.max(from, to)}`;
      edges.set(key, (edges.get(key) ?? 0) + 1);
    });
    expect([...edges.values()].filter((uses) => uses !== 2)).toEqual([]);
    const lengths = [...edges.keys()].map((key) => {
      const [a, b] = key.split(' ').map((index) => few.positions.subarray(3 * Number(index), 3 * Number(index) + 3));
      return Math.hypot(...[0, 1, 2].map((axis) => (a?.[axis] ?? 0) - (b?.[axis] ?? 0)));
    });
    const mean = lengths.reduce((sum, length) => sum + length, 0) / lengths.length;
    const spread = Math.sqrt(lengths.reduce((sum, length) => sum + (length - mean) ** 2, 0) / lengths.length);
    expect(spread / mean).toBeLessThan(0.25);
  });

  test('gives the same file twice', async () => {
    const files = [join(base, 'a.ply'), join(base, 'b.ply')] as const;
    for (const file of files) expect((await simplify(file)).status).toBe(0);
    expect(Buffer.compare(await readFile(files[0]), await readFile(files[1]))).toBe(0);
  });

  test('shows what the program says, and ends it when it is canceled', async () => {
    const canceled = new AbortController();
    const lines: string[] = [];
    const options = { program: 'instant-meshes', path: program, triangles: 20_000, unwrap: false, format: '.ply', say: () => {} } as const;
    const running = simplifyMesh(torus(1200, 500), {
      ...options,
      interrupted: canceled.signal,
      onLine: (line) => {
        lines.push(line);
        canceled.abort();
      },
    });
    const error = await running.catch((reason: unknown) => reason);
    expect(canceled.signal.aborted).toBe(true);
    expect(error).toBe(canceled.signal.reason);
    expect(lines.join('\n')).toContain('Computing mesh statistics');
    expect(lines.join('\n')).not.toContain('Extraction is done');
  });
});

test('a program that is not there is named with the place to get it', async () => {
  const base = await mkdtemp(join(tmpdir(), 'scrim-none-'));
  await writeFile(join(base, 'a.ply'), meshAsPly(torus(8, 8)));
  const args = ['simplify', join(base, 'a.ply'), '--triangles', '50', '--out', join(base, 'b.ply'), '--program', 'instant-meshes'] as const;
  const { status, err } = await scrim(...args, '--path', join(base, 'none'));
  expect([status, err]).toEqual([1, expect.stringContaining('https://github.com/wjakob/instant-meshes')]);
  await rm(base, { recursive: true, force: true });
});
