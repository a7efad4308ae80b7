import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { Triangle, Vector3 } from 'three';
import { importCapture } from '../../app/services/add-capture.ts';
import { NODE_FILES } from '../../app/services/file-layer.ts';
import { UNKNOWN_SIZE } from '../../app/services/measure-capture.ts';
import { pointsOfDepthMesh } from '../../export/captures/depth/depth-points.ts';
import { panoramaRays } from '../../export/captures/depth/depth-rays.ts';
import { type CaptureDepthMeshFile, readCapture } from '../../nodes/kit/capture.ts';
import { openModule, useBrowser } from '../support/browser.ts';
import { projectText, writeProject } from '../support/project-kit.ts';
import { describeWithData } from '../support/shared-data.ts';
import type { Sight } from './capture-around.page.ts';

const chromium = useBrowser();
let base = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-around-'));
});
afterAll(() => rm(base, { recursive: true, force: true }));

/** The directions of the eye. */
const YAWS_DEG = [0, 90, 180, 270];
/** How far the eye moves in each direction. */
const STEP_M = 0.2;

describeWithData('a 360° photograph with depth', 'panoramas/rgbd360', (folder) => {
  test('shows the place from an eye beside its camera nearly as well as from the camera', async () => {
    await writeProject(base, { 'project.scrim.json': projectText({ nodes: { 'screen-a1': 'output/screen' }, wires: [] }) });
    const imported = await importCapture({
      folder,
      root: base,
      sources: resolve('.'),
      name: 'gallery',
      maxSidePx: 1600,
      up: null,
      metersPerUnit: 1,
      known: UNKNOWN_SIZE,
      depth: { from: null, unit: null, kind: null },
      files: NODE_FILES,
      say: () => {},
      interrupted: new AbortController().signal,
    });
    expect(imported).toMatchObject({ form: 'one 360° photograph', depth: { unit: 'mm', kind: 'ray', count: 1 }, diagnostics: [] });
    const captureFolder = join(base, 'assets/gallery.capture');
    const { views } = readCapture(await readFile(join(captureFolder, 'capture.json'), 'utf8'));
    const { eye } = JSON.parse(await readFile(join(folder, 'vr-gallery.json'), 'utf8')) as { eye: readonly number[] };
    const position = views[0]?.worldFromCamera.slice(12, 15) ?? [];
    // The floor of the model is at 0.
    expect(position).toEqual([0, expect.closeTo(eye[1] ?? 0, 1), 0]);
    // Of two per square of pixels.
    expect(views[0]?.depthMesh?.triangleCount).toBeLessThan(0.02 * 2 * 2048 * 1023);
    expect(stretchedArea(await readFile(join(captureFolder, 'depth-meshes/000.bin')), views[0]?.depthMesh)).toBeLessThan(0.001);
    const page = await openModule(chromium.browser, 'tests/slow/capture-around.page.ts', {
      mounts: { '/capture/': captureFolder, '/models/': resolve(folder, '../../models') },
    });
    const look = (offsets: readonly (readonly [number, number, number])[], method: string, yaws: readonly number[]) => {
      const eyes = offsets.flatMap((offsetM) => yaws.map((yawDeg) => ({ offsetM, yawDeg })));
      const from = { capture: position, model: eye };
      return page.call<readonly Sight[]>('lookAround', '/capture/', '/models/VrGallery.glb', from, method, eyes);
    };
    const still = await look([[0, 0, 0]], 'depth-meshes', YAWS_DEG);
    const moved = await look(
      [
        [STEP_M, 0, 0],
        [0, STEP_M, 0],
        [0, 0, STEP_M],
      ],
      'depth-meshes',
      YAWS_DEG,
    );
    // Backward, where the edges of the photograph are.
    const [other] = await look([[0, 0, STEP_M]], 'lumigraph', [180]);
    await page.close();
    const out = process.env.SCRIM_PICTURES;
    for (const [i, { shown, truth }] of out ? [...still, ...moved, ...(other ? [other] : [])].entries() : []) {
      for (const [name, url] of Object.entries({ shown, truth })) {
        await writeFile(join(out ?? '', `${String(i).padStart(2, '0')}-${name}.png`), Buffer.from(url.slice(22), 'base64'));
      }
    }
    const mean = (sights: readonly Sight[]) =>
      sights.reduce((sum, { hidden, psnrDb }) => sum + (hidden?.restDb ?? psnrDb), 0) / sights.length;
    /** PSNR of hidden pixels of all sights together. */
    const pooled = (db: 'psnrDb' | 'blackDb') => {
      const filled = moved.flatMap(({ hidden }) => hidden ?? []);
      const parts = filled.reduce((sum, { part }) => sum + part, 0);
      return -10 * Math.log10(filled.reduce((sum, hidden) => sum + hidden.part * 10 ** (-hidden[db] / 10), 0) / parts);
    };
    /** The part of the pictures that is drawn, where the skylight is not. */
    const drawn = (counts: (sight: Sight) => number) => {
      const sights = moved.filter((_, i) => i % YAWS_DEG.length !== 0);
      return sights.reduce((sum, sight) => sum + counts(sight), 0) / sights.length;
    };
    const before = drawn(({ covered, hidden }) => covered - (hidden?.part ?? 0));
    const after = drawn(({ covered }) => covered);
    if (out) {
      console.log(pooled('psnrDb'), pooled('blackDb'), before, after, views[0]?.hiddenMesh);
      console.log(mean(still), mean(moved), Math.min(...moved.map(({ hidden, psnrDb }) => hidden?.restDb ?? psnrDb)));
    }
    // What the camera did not see is continued from what it saw behind edges: most of it thin things, which are hard to hit.
    expect(after).toBeGreaterThan(0.998);
    expect(1 - after).toBeLessThan(0.25 * (1 - before));
    expect(pooled('psnrDb')).toBeGreaterThan(pooled('blackDb') + 10);
    // Nothing is above the skylight, and the outlines of near things are left out.
    expect(Math.min(...still.map(({ covered }) => covered))).toBeGreaterThan(0.95);
    expect(mean(still) - mean(moved)).toBeLessThan(2);
    // The other methods show it, too, by a depth map of the mesh.
    expect(other?.psnrDb).toBeGreaterThan(30);
    expect(Math.min(...moved.map(({ hidden, psnrDb }) => hidden?.restDb ?? psnrDb))).toBeGreaterThan(26);
    expect(Math.min(...moved.map(({ covered }) => covered))).toBeGreaterThan(0.9);
  });
});

/** The part of all directions, from an eye beside the camera, in which triangles are nearly parallel to the camera's rays and long. */
function stretchedArea(bytes: Uint8Array, file: CaptureDepthMeshFile | undefined): number {
  if (!file) throw new Error('There is no depth mesh.');
  const data = Uint8Array.from(bytes).buffer;
  const [halves, floats] = [new Uint16Array(data), new Float32Array(data)];
  const places = Uint16Array.from({ length: 2 * file.vertexCount }, (_, i) => halves[4 * (i >> 1) + (i & 1)] ?? 0);
  const depths = Float32Array.from({ length: file.vertexCount }, (_, i) => floats[2 * i + 1] ?? 0);
  const indices = new Uint32Array(data, 8 * file.vertexCount);
  const { positions } = pointsOfDepthMesh({ places, depths, indices }, panoramaRays(file.widthPx, file.heightPx));
  const at = (vertex: number): Vector3 => new Vector3().fromArray(positions, 3 * vertex);
  const eye = new Vector3(STEP_M, 0, 0);
  let area = 0;
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((corner) => at(indices[i + corner] ?? 0)) as [Vector3, Vector3, Vector3];
    const normal = new Triangle(a, b, c).getNormal(new Vector3());
    const center = a.clone().add(b).add(c).divideScalar(3);
    const longest = Math.max(a.distanceTo(b), b.distanceTo(c), c.distanceTo(a));
    const isStretched = Math.abs(normal.dot(center)) < 0.1 * center.length() && longest > 0.1 * center.length();
    if (isStretched) area += solidAngle(a.sub(eye), b.sub(eye), c.sub(eye));
  }
  return area / (4 * Math.PI);
}

function solidAngle(a: Vector3, b: Vector3, c: Vector3): number {
  const [la, lb, lc] = [a.length(), b.length(), c.length()];
  const volume = Math.abs(a.dot(b.clone().cross(c)));
  return 2 * Math.atan2(volume, la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}
