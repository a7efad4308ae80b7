import { cp, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { readObj } from '../../export/captures/mesh-obj.ts';
import { readPly } from '../../export/captures/mesh-ply.ts';
import { meshAsPly } from '../../export/captures/write-ply.ts';
import { type CaptureMesh, readCapture, readCaptureMesh } from '../../nodes/kit/capture.ts';
import { describeWithBlender } from '../support/blender.ts';
import { projectText, writeProject } from '../support/project-kit.ts';
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

test('a program that is not there is named with the place to get it', async () => {
  const base = await mkdtemp(join(tmpdir(), 'scrim-none-'));
  await writeFile(join(base, 'a.ply'), meshAsPly(torus(8, 8)));
  const args = ['simplify', join(base, 'a.ply'), '--triangles', '50', '--out', join(base, 'b.ply'), '--program', 'instant-meshes'] as const;
  const { status, err } = await scrim(...args, '--path', join(base, 'none'));
  expect([status, err]).toEqual([1, expect.stringContaining('https://github.com/wjakob/instant-meshes')]);
  await rm(base, { recursive: true, force: true });
});
