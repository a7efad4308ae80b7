import { cp, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, afterEach, beforeAll, describe, expect, test } from '@jest/globals';
import { useBrowser } from '../support/browser.ts';
import { decodeImage, pixelAt, type RgbaImage } from '../support/image.ts';
import type { ProjectText } from '../support/project-kit.ts';
import { type ServedExport, serveProject, serveProjectText } from '../support/project-page.ts';
import { openXrPage, type XrPage } from '../xr/xr-page.ts';
import { type IwerOptions, type IwerPage, type IwerView, openIwerPage } from './iwer-page.ts';

/** Exported pages in the emulator that browsers' extensions are built on, as it comes. */

const chromium = useBrowser();
const EXAMPLES = resolve(import.meta.dirname, '../../examples');
const VIEWPORT = { width: 640, height: 400 };
/** Outside the session of our emulator, where no test looks at a picture. */
const IDLE_FRAME_MS = 1000;
/** iwer's own. */
const FOV_Y_RAD = Math.PI / 2;
const POSE = { position: [0.1, 1.4, 1.6], quaternion: [-0.17, 0, 0, 0.985] } as const;

let base = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-iwer-'));
});
/** Addresses of the exported examples, each exported once. */
const exported = new Map<string, Promise<ServedExport>>();
afterAll(async () => {
  for (const served of exported.values()) await (await served).close();
  await rm(base, { recursive: true, force: true });
});

const closing: (() => Promise<unknown>)[] = [];
afterEach(async () => {
  for (const close of closing.splice(0).reverse()) await close();
});

/** The example with its models at rest, so that two devices show the same at any time. */
async function exportAtRest(example: string): Promise<string> {
  const served = exported.get(example) ?? serveAtRest(example);
  exported.set(example, served);
  return (await served).url;
}

async function serveAtRest(example: string): Promise<ServedExport> {
  const folder = join(base, example);
  await cp(join(EXAMPLES, example), folder, { recursive: true });
  const path = join(folder, 'project.scrim.json');
  const project = JSON.parse(await readFile(path, 'utf8')) as {
    graphs: { main: { nodes: Record<string, { type: string; params?: Record<string, unknown> }> } };
  };
  for (const node of Object.values(project.graphs.main.nodes)) {
    if (node.type === 'source/model') node.params = { ...node.params, playing: false };
  }
  await writeFile(path, JSON.stringify(project));
  return serveProject(folder);
}

async function openIwer(url: string, more: Partial<IwerOptions> = {}): Promise<IwerPage> {
  const iwer = await openIwerPage(chromium.browser, url, { room: null, mode: 'immersive-ar', ...POSE, ...more }, VIEWPORT);
  closing.push(iwer.close);
  return iwer;
}

interface Extent {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
  readonly middleX: number;
  readonly middleY: number;
}

/** Of what is more there than not, in one eye's half: pixels. */
function extentOf(layer: RgbaImage, eye: number): Extent {
  const from = (eye * layer.width) / 2;
  let [left, right, top, bottom] = [Number.POSITIVE_INFINITY, 0, Number.POSITIVE_INFINITY, 0];
  let [count, sumX, sumY] = [0, 0, 0];
  for (let y = 0; y < layer.height; y++) {
    for (let x = from; x < from + layer.width / 2; x++) {
      if (pixelAt(layer, x, y)[3] < 128) continue;
      [left, right, top, bottom] = [Math.min(left, x), Math.max(right, x), Math.min(top, y), Math.max(bottom, y)];
      count++;
      sumX += x;
      sumY += y;
    }
  }
  // Enough to say where it is, and not everything.
  expect(count).toBeGreaterThan(500);
  expect(count).toBeLessThan(layer.width * layer.height * 0.4);
  return { left, right, top, bottom, middleX: sumX / count, middleY: sumY / count };
}

/** Our headset sees farther outwards than inwards, iwer's as far to both sides: by how much its images lie to the right. */
function offAxisPx(iwer: readonly number[], ours: readonly number[], widthPx: number): number {
  return (((ours[8] ?? 0) - (iwer[8] ?? 0)) * widthPx) / 2;
}

function moved(extent: Extent, px: number): Extent {
  return { ...extent, left: extent.left + px, right: extent.right + px, middleX: extent.middleX + px };
}

/** Of each eye, as WebXR tells them to the page. */
async function projectionsOf(xr: XrPage): Promise<number[][]> {
  return xr.page.evaluate(async () => {
    const session = (scrimEmulator?.current?.device as unknown as { activeSession?: XRSession })?.activeSession;
    if (!session) throw new Error('There is no session.');
    const space = await session.requestReferenceSpace('viewer');
    const told = new Promise<number[][]>((resolve) => {
      session.requestAnimationFrame((_time, frame) => {
        resolve((frame.getViewerPose(space)?.views ?? []).map(({ projectionMatrix }) => [...projectionMatrix]));
      });
    });
    await scrimEmulator?.current?.stepFrame();
    return told;
  });
}

/** What of the page's opaque pixels the visitor sees on the window: 1 is all. */
function shownPart(layer: RgbaImage, screenshot: RgbaImage): number {
  let [opaque, shown] = [0, 0];
  for (let y = 0; y < layer.height; y += 3) {
    for (let x = 0; x < layer.width; x += 3) {
      const [red, green, blue, alpha] = pixelAt(layer, x, y);
      if (alpha !== 255) continue;
      const seen = pixelAt(screenshot, x, y);
      opaque++;
      if (Math.max(Math.abs(seen[0] - red), Math.abs(seen[1] - green), Math.abs(seen[2] - blue)) <= 8) shown++;
    }
  }
  return shown / opaque;
}

describe('an exported page in plain iwer, on a Quest 3', () => {
  test.each(['first-light', 'built-of-bricks', 'gooch-tones', 'pen-strokes', 'ways-to-draw'])(
    'shows to both eyes what our emulator shows, where it shows it: %s',
    async (example) => {
      const url = await exportAtRest(example);
      const iwer = await openIwer(url);
      await iwer.page.getByRole('button', { name: 'Enter AR' }).click();
      const { layer, views } = await iwer.nextFrame();
      expect(views).toHaveLength(2);
      const screenshot = decodeImage(await iwer.page.screenshot());
      expect(shownPart(layer, screenshot)).toBeGreaterThan(0.97);
      expect(iwer.errors).toEqual([]);
      // Its session would draw on, beside ours.
      await iwer.close();

      const device = { device: 'headset', room: null, fovYRad: FOV_Y_RAD, display: false } as const;
      const ours = await openXrPage(chromium.browser, url, device, VIEWPORT, '', IDLE_FRAME_MS);
      closing.push(ours.close);
      await ours.enter();
      await ours.setPose(POSE);
      await ours.step();
      const expected = await ours.readLayer();
      const projections = await projectionsOf(ours);
      expect([layer.width, layer.height]).toEqual([expected.width, expected.height]);
      for (const eye of [0, 1]) {
        const here = extentOf(layer, eye);
        const there = moved(extentOf(expected, eye), offAxisPx(views[eye]?.clipFromView ?? [], projections[eye] ?? [], layer.width / 2));
        const off = Object.fromEntries((Object.keys(here) as (keyof Extent)[]).map((edge) => [edge, Math.abs(here[edge] - there[edge])]));
        expect({ eye, here, there, far: Object.entries(off).filter(([, px]) => px > 2) }).toEqual({ eye, here, there, far: [] });
      }
      expect(ours.errors).toEqual([]);
    },
  );

  test('has its elements in order after it was left, and can be entered again', async () => {
    const { page, errors, nextFrame } = await openIwer(await exportAtRest('ways-to-draw'));
    const order = () =>
      page.evaluate(() => [...(document.querySelector('main')?.children ?? [])].map(({ tagName, className }) => [tagName, className]));
    const button = page.getByRole('button', { name: 'Enter AR' });
    await button.waitFor();
    const before = await order();
    for (let i = 0; i < 2; i++) {
      await button.click();
      await nextFrame();
      await page.evaluate(() => testIwer?.sessions.at(-1)?.end());
      await page.getByText('AR has ended').waitFor();
      expect(await order()).toEqual(before);
    }
    expect(errors).toEqual([]);
  });

  test('shows the room that stands in for the visitor’s in VR', async () => {
    const { page, errors, nextFrame } = await openIwer(await exportAtRest('first-light'), { mode: 'immersive-vr' });
    await page.getByRole('button', { name: 'Enter VR' }).click();
    const { layer } = await nextFrame();
    expect(pixelAt(layer, 5, 5)[3]).toBe(255);
    expect(shownPart(layer, decodeImage(await page.screenshot()))).toBeGreaterThan(0.97);
    expect(errors).toEqual([]);
  });
});

/** Half behind the back of the sofa, seen along -x from the middle of the room. */
const BOX = { middle: [-2.3, 0.5, 0], half: [0.14, 0.5, 0.35] } as const;

const HIDDEN_BOX: ProjectText = {
  title: 'Box behind the furniture',
  nodes: {
    'box-0000': ['objects/primitive', { sizeM: BOX.half.map((m) => 2 * m), color: [0.9, 0.2, 0.2, 1] }],
    'place-0000': ['objects/transform', { positionM: BOX.middle }],
    'scene-0000': 'layer/scene',
    'depth-0000': ['world/depth', { filter: 'nearest', smoothingS: 0 }],
    'hide-0000': 'layer/depth-occlusion',
    'screen-0000': 'output/screen',
  },
  wires: [
    'box-0000.objects -> place-0000.objects',
    'place-0000.objects -> scene-0000.objects',
    'scene-0000.layer -> hide-0000.layer',
    'depth-0000.depth -> hide-0000.depth',
    'hide-0000.layer -> screen-0000.layer',
  ],
};

/** View-space depth at which a pixel's ray meets the box, meters; null: it passes by. `u`, `v`: in the view, from the top left. */
function boxDepth({ clipFromView, worldFromView }: IwerView, u: number, v: number): number | null {
  const p = (i: number) => clipFromView[i] ?? 0;
  const w = (i: number) => worldFromView[i] ?? 0;
  const inView = [(2 * u - 1 + p(8)) / p(0), (1 - 2 * v + p(9)) / p(5), -1] as const;
  let [near, far] = [0, Number.POSITIVE_INFINITY];
  for (let axis = 0; axis < 3; axis++) {
    const along = w(axis) * inView[0] + w(4 + axis) * inView[1] + w(8 + axis) * inView[2];
    const from = (BOX.middle[axis] ?? 0) - w(12 + axis);
    const a = (from - (BOX.half[axis] ?? 0)) / along;
    const b = (from + (BOX.half[axis] ?? 0)) / along;
    near = Math.max(near, Math.min(a, b));
    far = Math.min(far, Math.max(a, b));
  }
  return near < far ? near : null;
}

test('iwer’s own depth hides what it says is behind, and nothing else, for both eyes', async () => {
  const served = await serveProjectText(HIDDEN_BOX, {});
  closing.push(served.close);
  const iwer = await openIwer(served.url, { room: 'living_room', position: [0, 1.1, 0], quaternion: [0, Math.SQRT1_2, 0, Math.SQRT1_2] });
  await iwer.page.getByRole('button', { name: 'Enter AR' }).click();
  const { layer, views } = await iwer.nextFrame();
  expect(views).toHaveLength(2);
  for (const view of views) {
    const { viewport, depth } = view;
    let [both, either, hidden] = [0, 0, 0];
    for (let y = 0; y < viewport.height; y++) {
      for (let x = 0; x < viewport.width; x++) {
        const [u, v] = [(x + 0.5) / viewport.width, (y + 0.5) / viewport.height];
        const boxM = boxDepth(view, u, v);
        const roomM = depth?.meters[Math.floor(v * depth.height) * depth.width + Math.floor(u * depth.width)] ?? 0;
        const predicted = boxM !== null && boxM < roomM;
        if (boxM !== null && !predicted) hidden++;
        const drawn = pixelAt(layer, viewport.x + x, y)[3] >= 128;
        if (predicted || drawn) either++;
        if (predicted && drawn) both++;
      }
    }
    // Both are there to be told apart.
    expect(hidden).toBeGreaterThan(500);
    expect(both).toBeGreaterThan(500);
    expect(both / either).toBeGreaterThanOrEqual(0.98);
  }
  expect(iwer.errors).toEqual([]);
});
