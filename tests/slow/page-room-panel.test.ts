import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { afterAll, afterEach, beforeAll, describe, expect, test } from '@jest/globals';
import { projectEye } from '../../export/emulator/session/projection.ts';
import { layOutPanel, type PanelLayout, PX_PER_M } from '../../export/page/room-panel/panel-layout.ts';
import type { Control, Program } from '../../export/program/program.ts';
import { LAMP } from '../browser/controls-program.ts';
import { DISC, type ServedPage, servePage } from '../browser/page-kit.ts';
import { useBrowser } from '../support/browser.ts';
import { pixelAt, type RgbaImage } from '../support/image.ts';
import { countDifferent } from '../support/pixels.ts';
import { aliveGl, watchGl } from '../xr/count-gl.ts';
import { openXrPage, type XrPage } from '../xr/xr-page.ts';

const chromium = useBrowser();
let served: ServedPage;
beforeAll(async () => {
  served = await servePage(TAPPED);
});
afterAll(() => served.close());

const opened: XrPage[] = [];
afterEach(async () => {
  for (const xr of opened.splice(0)) await xr.close();
});

/** The lamp again, larger by the taps that reach the program: the tapped point's first number, 0 before there was one. */
const [lamp] = LAMP.operations;
const [lampShader] = LAMP.shaders;
if (lamp?.kind !== 'pass' || !lampShader) throw new Error('The lamp is one pass.');
const TAPPED: Program = {
  ...LAMP,
  slots: {
    ...LAMP.slots,
    numbers: [...LAMP.slots.numbers, 0, 0, 0, 0, 0, 0, 2],
    slots: [...LAMP.slots.slots, { type: 'vector3', offset: 4 }, { type: 'vector3', offset: 7 }, { type: 'number', offset: 10 }],
  },
  resources: [...LAMP.resources, { id: 'tap-e5.tapped', kind: 'pulses' }],
  operations: [
    {
      id: 'tap-e5',
      node: 'tap-e5',
      kind: 'value',
      view: 'once',
      reads: [],
      writes: ['tap-e5.tapped'],
      type: 'input/tap',
      inputs: {},
      multiple: [],
      outputs: { tapped: { kind: 'resource', resource: 'tap-e5.tapped' }, point: { kind: 'slot', slot: 4 } },
      params: { start: 5, distanceM: 6 },
      config: { by: 'any' },
      assets: {},
    },
    { ...lamp, uniforms: [...lamp.uniforms, { name: 'point', type: 'vec3', source: { slot: 4 } }] },
  ],
  shaders: [
    {
      ...lampShader,
      id: 'tapped-lamp',
      // A tap that the program hears makes the lamp white.
      fragment: lampShader.fragment
        .replace('uniform float presses;', 'uniform float presses;\nuniform vec3 point;')
        .replace(/\}\s*$/, '  if (length(point) > 0.0) color = vec4(a);\n}'),
    },
  ],
};

const CONTROLS: readonly Control[] = TAPPED.controls ?? [];
const EYES_M = 1.6;
/** The middle of the panel, for a viewer at the origin who looks along -z, and its axes: 0.9 m away, 0.5 m down, facing the eyes. */
const AHEAD_M = Math.sqrt(0.9 ** 2 - 0.5 ** 2);
const MIDDLE = [0, EYES_M - 0.5, -AHEAD_M] as const;
const UP = [0, AHEAD_M / 0.9, -0.5 / 0.9] as const;

async function enter(): Promise<{ readonly xr: XrPage; readonly layout: PanelLayout }> {
  const xr = await openXrPage(chromium.browser, served.url, { device: 'headset', display: false }, { width: 1200, height: 640 });
  opened.push(xr);
  await xr.setPose({ position: [0, EYES_M, 0] });
  await point(xr, [0.3, 1.2, -0.2], [0, 0, 0, 1]);
  await xr.enter();
  await xr.step(2);
  return { xr, layout: layOutPanel(TAPPED.title, CONTROLS, () => 90) };
}

/** Holds the right controller so. */
async function point(xr: XrPage, position: readonly number[], quaternion: readonly number[]): Promise<void> {
  await xr.page.evaluate(
    ([p, q]) => {
      const controller = scrimEmulator?.current?.device.controllers.right;
      if (!controller) throw new Error('There is no right controller.');
      controller.position.set(p?.[0] ?? 0, p?.[1] ?? 0, p?.[2] ?? 0);
      controller.quaternion.set(q?.[0] ?? 0, q?.[1] ?? 0, q?.[2] ?? 0, q?.[3] ?? 1);
    },
    [position, quaternion],
  );
}

async function pull(xr: XrPage, trigger: number): Promise<void> {
  await xr.page.evaluate((value) => scrimEmulator?.current?.device.controllers.right?.updateButtonValue('trigger', value), trigger);
  await xr.step(2);
}

type Place = readonly [x: number, y: number, z: number];

/** A place of the panel's image in the room. */
function placeOf({ widthPx, heightPx }: PanelLayout, x: number, y: number): Place {
  const [right, up] = [(x - widthPx / 2) / PX_PER_M, (heightPx / 2 - y) / PX_PER_M];
  return [MIDDLE[0] + right, MIDDLE[1] + up * UP[1], MIDDLE[2] + up * UP[2]];
}

/** From a hand at the side straight to that place. */
async function pointAt(xr: XrPage, [x, y, z]: Place): Promise<void> {
  const hand = [0.25, 1.3, -0.1] as const;
  const to = [x - hand[0], y - hand[1], z - hand[2]] as const;
  const length = Math.hypot(...to);
  // The shortest turn from -z to there.
  const q = [to[1] / length, -to[0] / length, 0, 1 - to[2] / length];
  const size = Math.hypot(...q);
  await point(
    xr,
    hand,
    q.map((value) => value / size),
  );
  await xr.step(2);
}

function middleOf(layout: PanelLayout, control: number, option = 0): readonly [number, number] {
  const part = layout.parts.find((found) => found.control === control && found.option === option);
  if (!part) throw new Error('There is no such part.');
  return [part.x + part.width / 2, part.y + part.height / 2];
}

/** Where one eye of the emulated headset sees a place: pixels of the layer from its top left. */
async function seenAt(xr: XrPage, layer: RgbaImage, view: 0 | 1, [x, y, z]: Place): Promise<readonly [number, number]> {
  const fovY = await xr.page.evaluate(() => scrimEmulator?.current?.device.fovy ?? 0);
  const width = layer.width / 2;
  const m = projectEye(view === 0 ? 'left' : 'right', fovY, width / layer.height, 0.05, 100);
  const inView = [x - (view === 0 ? -0.0315 : 0.0315), y - EYES_M, z, 1];
  const [clipX = 0, clipY = 0, , w = 1] = [0, 1, 2, 3].map((row) => inView.reduce((sum, v, i) => sum + v * (m[4 * i + row] ?? 0), 0));
  return [Math.round(view * width + ((clipX / w + 1) / 2) * width), Math.round(((1 - clipY / w) / 2) * layer.height)];
}

const isAccent = ([r, g, b]: readonly number[]) => (r ?? 0) > 180 && (g ?? 0) > 140 && (g ?? 0) < 230 && (b ?? 255) < 140;
/** Of the lamp, in the middle of the left eye. */
const lampOf = (layer: RgbaImage) => pixelAt(layer, Math.floor(layer.width / 4), Math.floor(layer.height / 2));

describe('the controls of a page in a headset', () => {
  test('hang in the room before the viewer, in both eyes, and stay there', async () => {
    const { xr, layout } = await enter();
    const layer = await xr.readLayer();
    const [x, y] = middleOf(layout, 2, 0);
    // The chosen word of the choice is filled with the accent; its left end has no letters.
    const filled = placeOf(layout, x - 62, y);
    const beside = placeOf(layout, layout.widthPx + 60, layout.heightPx / 2);
    for (const view of [0, 1] as const) {
      expect(isAccent(pixelAt(layer, ...(await seenAt(xr, layer, view, filled))))).toBe(true);
      expect(pixelAt(layer, ...(await seenAt(xr, layer, view, beside)))[3]).toBe(0);
    }
    // Someone who leans aside sees it in the same place of the room.
    await xr.setPose({ position: [0.1, EYES_M, 0] });
    await xr.step(2);
    const leant = await xr.readLayer();
    expect(isAccent(pixelAt(leant, ...(await seenAt(xr, leant, 0, [filled[0] - 0.1, filled[1], filled[2]]))))).toBe(true);
    expect(xr.errors).toEqual([]);
  });

  test('are pressed and dragged by pointing, which the program does not take for taps', async () => {
    const { xr, layout } = await enter();
    const light = middleOf(layout, 1);
    await pointAt(xr, placeOf(layout, ...light));
    // A dot where it points.
    const [dotX, dotY] = await seenAt(xr, await xr.readLayer(), 0, placeOf(layout, ...light));
    expect(Math.min(...pixelAt(await xr.readLayer(), dotX, dotY).slice(0, 3))).toBeGreaterThan(200);
    expect(lampOf(await xr.readLayer())[3]).toBe(255);
    await pull(xr, 1);
    await pull(xr, 0);
    expect(lampOf(await xr.readLayer())[3]).toBe(0);
    await pull(xr, 1);
    await pull(xr, 0);
    expect(lampOf(await xr.readLayer()).slice(0, 3)).toEqual([255, 0, 0]);

    await pointAt(xr, placeOf(layout, ...middleOf(layout, 2, 1)));
    await pull(xr, 1);
    await pull(xr, 0);
    expect(lampOf(await xr.readLayer()).slice(0, 3)).toEqual([0, 0, 255]);

    const [x, y] = middleOf(layout, 0);
    await pointAt(xr, placeOf(layout, x, y));
    await pull(xr, 1);
    await pointAt(xr, placeOf(layout, x + 600, y - 500));
    const layer = await xr.readLayer();
    // At its largest it reaches the side of the view, straight from the middle.
    expect(pixelAt(layer, Math.round(layer.width * 0.25 - layer.height * 0.45), layer.height / 2)[2]).toBe(255);
    await pointAt(xr, placeOf(layout, x - 600, y));
    expect(lampOf(await xr.readLayer())[3]).toBe(0);
    await pointAt(xr, placeOf(layout, x + 600, y));
    await pull(xr, 0);
    expect(lampOf(await xr.readLayer()).slice(0, 3)).toEqual([0, 0, 255]);

    // Beside the panel, a tap is the program's.
    await pointAt(xr, [0.2, 1.8, -1]);
    await pull(xr, 1);
    await pull(xr, 0);
    expect(lampOf(await xr.readLayer()).slice(0, 3)).toEqual([255, 255, 255]);

    // The page shows what was set in the room.
    await xr.page.evaluate(() => scrimEmulator?.current?.endSession());
    await xr.page.getByText('AR has ended').waitFor();
    expect(await xr.page.locator('output').textContent()).toBe('0.5');
    expect(await xr.page.getByRole('radio', { name: 'Cold' }).isChecked()).toBe(true);
    expect(xr.errors).toEqual([]);
  });

  test('brighten where a ray points, only there, and only while it does', async () => {
    const { xr, layout } = await enter();
    const beside = [0.2, 1.8, -1] as const;
    const [x, y] = middleOf(layout, 1);
    await pointAt(xr, beside);
    const before = await xr.readLayer();
    await pointAt(xr, placeOf(layout, x, y));
    const pointed = await xr.readLayer();
    const brighterAt = async (left: number, top: number) => {
      const seen = await seenAt(xr, before, 0, placeOf(layout, left, top));
      return pixelAt(pointed, ...seen)[0] - pixelAt(before, ...seen)[0];
    };
    // Neither place is on a letter or on the ray.
    expect(await brighterAt(x + 60, y)).toBeGreaterThan(15);
    const [otherX, otherY] = middleOf(layout, 2, 1);
    expect(await brighterAt(otherX - 62, otherY)).toBe(0);
    await pointAt(xr, beside);
    expect(countDifferent(await xr.readLayer(), before).pixels).toBe(0);
    expect(xr.errors).toEqual([]);
  });

  test('look the same after a change as in a session that begins with it', async () => {
    const { xr, layout } = await enter();
    const beside = [0.2, 1.8, -1] as const;
    const press = async (x: number, y: number) => {
      await pointAt(xr, placeOf(layout, x, y));
      await pull(xr, 1);
      await pull(xr, 0);
    };
    await pointAt(xr, beside);
    const before = await xr.readLayer();
    const [x, y] = middleOf(layout, 0);
    await press(x - 80, y);
    await press(...middleOf(layout, 2, 1));
    await pointAt(xr, beside);
    const changed = await xr.readLayer();
    expect(countDifferent(changed, before).pixels).toBeGreaterThan(200);
    await xr.page.evaluate(() => scrimEmulator?.current?.endSession());
    await xr.page.getByText('AR has ended').waitFor();
    await xr.enter();
    await xr.step(2);
    // Areas are uploaded with straight alpha, which rounds.
    expect(countDifferent(await xr.readLayer(), changed, 1).pixels).toBe(0);
    expect(xr.errors).toEqual([]);
  });

  test('show in the room what was set on the page, repeatedly and without leaks', async () => {
    const { xr, layout } = await enter();
    await watchGl(xr.page);
    const leave = async () => {
      await xr.page.evaluate(() => scrimEmulator?.current?.endSession());
      await xr.page.getByText('AR has ended').waitFor();
      return aliveGl(xr.page);
    };
    await leave();
    await xr.page.getByRole('radio', { name: 'Cold' }).click();
    const left: number[] = [];
    for (let i = 0; i < 5; i++) {
      await xr.enter();
      left.push(await leave());
    }
    expect(left).toEqual(left.map(() => left[0]));
    await xr.enter();
    const layer = await xr.readLayer();
    const [x, y] = middleOf(layout, 2, 1);
    expect(isAccent(pixelAt(layer, ...(await seenAt(xr, layer, 0, placeOf(layout, x - 62, y)))))).toBe(true);
    expect(xr.errors).toEqual([]);
  });

  test('are not in a page with nothing to set, nor in AR that shows the page itself', async () => {
    const without = await servePage(DISC);
    const holdsPanel = async ({ folder }: ServedPage) => {
      const scripts = (await readdir(folder, { recursive: true })).filter((path) => path.endsWith('.js'));
      const texts = await Promise.all(scripts.map((path) => readFile(join(folder, path), 'utf8')));
      return texts.some((text) => text.includes('scrim:room-panel'));
    };
    expect([await holdsPanel(without), await holdsPanel(served)]).toEqual([false, true]);
    await without.close();
    const xr = await openXrPage(chromium.browser, served.url, { device: 'phone' });
    opened.push(xr);
    await xr.setPose({ position: [0, EYES_M, 0] });
    await xr.enter();
    const layer = await xr.readLayer();
    expect(pixelAt(layer, layer.width / 2, layer.height - 10)[3]).toBe(0);
    expect(xr.errors).toEqual([]);
  });
});
