import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { Matrix4, Vector3 } from 'three';
import type { HeadPose } from '../../export/emulator/emulator.ts';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import { useBrowser } from '../support/browser.ts';
import { eventually } from '../support/patience.ts';
import { type ServedExport, serveProjectText } from '../support/project-page.ts';
import { drawnMatrices, forgetDrawn, WATCH_MATRICES } from '../xr/drawn-matrices.ts';
import { openXrPage, type XrPage } from '../xr/xr-page.ts';

const chromium = useBrowser();
let served: ServedExport;
beforeAll(async () => {
  served = await serveProjectText(
    {
      nodes: {
        'box-x1': ['objects/primitive', { sizeM: [0.2, 0.2, 0.2] }],
        'place-x1': ['objects/place', { reticle: false }],
        'scene-x1': 'layer/scene',
        'sun-x1': 'light/directional',
        'screen-x1': 'output/screen',
      },
      wires: [
        'box-x1.objects -> place-x1.objects',
        'place-x1.objects -> scene-x1.objects',
        'sun-x1.lights -> scene-x1.lights',
        'scene-x1.layer -> screen-x1.layer',
      ],
    },
    {},
  );
});
afterAll(() => served.close());

const SIZE = { width: 480, height: 360 } as const;
/** No test looks at pixels, which take most of the time without a GPU. */
const PHONE = { device: 'phone', room: 'studio', sizePx: [120, 90] } as const;
/** From (0, 1.5, 1), 0.7 rad below the horizon. */
const PITCH_RAD = 0.7;
const HEAD = { position: [0, 1.5, 1], quaternion: [-Math.sin(PITCH_RAD / 2), 0, 0, Math.cos(PITCH_RAD / 2)] } as const satisfies HeadPose;
const ROOM_FROM_VIEW = new Matrix4().makeRotationX(-PITCH_RAD).setPosition(...HEAD.position);

/** Where a matrix has its origin, seen from another space. */
function originOf(matrix: readonly number[], outerFromSpace: Matrix4): Vector3 {
  return new Vector3().setFromMatrixPosition(new Matrix4().fromArray(matrix)).applyMatrix4(outerFromSpace);
}

interface Visit {
  readonly xr: XrPage;
  /** Where the box is in the room, whatever the page takes for its origin; null while it is not drawn. */
  boxInRoom(): Promise<readonly number[] | null>;
  /** Where the ray through a point of the screen meets the floor of the room. */
  floorAt(x: number, y: number): readonly number[];
}

async function visit(options: EmulatorOptions = {}, { tracked = true } = {}): Promise<Visit> {
  const xr = await openXrPage(chromium.browser, served.url, { ...PHONE, ...options }, SIZE, WATCH_MATRICES);
  await xr.setPose(HEAD);
  await xr.page.evaluate((on) => scrimEmulator?.current?.setTracked(on), tracked);
  await xr.enter();
  await xr.step(2);
  const tanHalfFovY = Math.tan((await xr.page.evaluate(() => scrimEmulator?.current?.device.fovy ?? 0)) / 2);
  return {
    xr,
    boxInRoom: async () => {
      const drawn = await drawnMatrices(xr);
      return drawn && originOf(drawn.modelViewMatrix, ROOM_FROM_VIEW).toArray();
    },
    floorAt: (x, y) => {
      const [eye, ahead] = [
        new Vector3(),
        new Vector3((2 * x - 1) * tanHalfFovY * (SIZE.width / SIZE.height), (1 - 2 * y) * tanHalfFovY, -1),
      ];
      eye.setFromMatrixPosition(ROOM_FROM_VIEW);
      ahead.transformDirection(ROOM_FROM_VIEW);
      return eye.addScaledVector(ahead, -eye.y / ahead.y).toArray();
    },
  };
}

/** Counts the programs that the page links. */
const COUNT = `
  const { linkProgram } = WebGL2RenderingContext.prototype;
  WebGL2RenderingContext.prototype.linkProgram = function (program) {
    globalThis.linked = (globalThis.linked ?? 0) + 1;
    linkProgram.call(this, program);
  };
`;

/** 1 mm. */
const near = (place: readonly number[]) => place.map((x) => expect.closeTo(x, 3));

describe('objects that a visitor of a phone places', () => {
  test('stand where the tap meets the floor, follow a drag, and stay there while the visitor re-centers', async () => {
    const { xr, boxInRoom, floorAt } = await visit();
    expect(await boxInRoom()).toBe(null);
    await xr.touch([0.6, 0.55]);
    expect(await boxInRoom()).toEqual(near(floorAt(0.6, 0.55)));
    await xr.touch([0.6, 0.55], [0.5, 0.6], [0.35, 0.7]);
    expect(await boxInRoom()).toEqual(near(floorAt(0.35, 0.7)));
    await xr.page.evaluate(() => scrimEmulator?.current?.recenter());
    await xr.step(3);
    expect(await boxInRoom()).toEqual(near(floorAt(0.35, 0.7)));
    expect(xr.errors).toEqual([]);
    await xr.close();
  });

  test('move with the visitor’s origin where the device has no anchors', async () => {
    const { xr, boxInRoom, floorAt } = await visit({ refuse: ['anchors'] });
    await xr.touch([0.6, 0.55]);
    const [x = 0, , z = 0] = floorAt(0.6, 0.55);
    expect(await boxInRoom()).toEqual(near([x, 0, z]));
    await xr.page.evaluate(() => scrimEmulator?.current?.recenter());
    await xr.step(3);
    // The origin came from the room’s to below the visitor.
    expect(await boxInRoom()).toEqual(near([x, 0, z + HEAD.position[2]]));
    expect(xr.errors).toEqual([]);
    await xr.close();
  });
});

test('taps before tracking begins, and while it is lost, place nothing and break nothing', async () => {
  const { xr, boxInRoom, floorAt } = await visit({}, { tracked: false });
  await forgetDrawn(xr);
  await xr.touch([0.6, 0.55]);
  await xr.touch([0.4, 0.6], [0.5, 0.6]);
  expect(await boxInRoom()).toBe(null);
  // A finger that is still down when tracking begins places where it points as it lifts.
  await xr.page.evaluate(() => scrimEmulator?.current?.press(0.5, 0.6));
  await xr.step(2);
  await xr.page.evaluate(() => scrimEmulator?.current?.setTracked(true));
  await xr.step(2);
  expect(await boxInRoom()).toBe(null);
  await xr.page.evaluate(() => scrimEmulator?.current?.release());
  await xr.step(3);
  expect(await boxInRoom()).toEqual(near(floorAt(0.5, 0.6)));
  await xr.page.evaluate(() => scrimEmulator?.current?.setTracked(false));
  await xr.touch([0.3, 0.7]);
  await xr.page.evaluate(() => scrimEmulator?.current?.setTracked(true));
  await xr.step(3);
  expect(await boxInRoom()).toEqual(near(floorAt(0.5, 0.6)));
  await xr.touch([0.3, 0.7]);
  expect(await boxInRoom()).toEqual(near(floorAt(0.3, 0.7)));
  expect(xr.errors).toEqual([]);
  await xr.close();
});

test('a controller places the box where its ray meets the floor, and drags it onto a table', async () => {
  const xr = await openXrPage(
    chromium.browser,
    served.url,
    { device: 'headset', room: 'studio', sizePx: [160, 80] },
    { width: 640, height: 320 },
    WATCH_MATRICES,
  );
  await xr.setPose(HEAD);
  /** Straight down from 1.2 m. */
  const hold = (x: number, z: number, trigger: number) =>
    xr.page.evaluate(
      ([x, z, trigger]) => {
        const controller = scrimEmulator?.current?.device.controllers.right;
        if (!controller) throw new Error('There is no right controller.');
        controller.position.set(x, 1.2, z);
        controller.quaternion.set(-Math.SQRT1_2, 0, 0, Math.SQRT1_2);
        controller.updateButtonValue('trigger', trigger);
      },
      [x, z, trigger] as const,
    );
  const box = async () => {
    const drawn = await drawnMatrices(xr);
    return drawn && originOf(drawn.modelViewMatrix, new Matrix4().fromArray(drawn.viewMatrix).invert()).toArray();
  };
  const play = async (...moments: readonly (readonly [x: number, z: number, trigger: number])[]) => {
    for (const moment of moments) {
      await hold(...moment);
      await xr.step(2);
    }
  };
  await hold(0.2, 0.5, 0);
  await xr.enter();
  await play([0.2, 0.5, 1], [0.2, 0.5, 0]);
  expect(await box()).toEqual(near([0.2, 0, 0.5]));
  const tableM = 1.2 - ((await xr.measure([0.2, 1.2, -0.4], [0, -1, 0])) ?? 0);
  expect(tableM).toBeGreaterThan(0.3);
  await play([0.2, 0.5, 1], [0.2, 0, 1], [0.2, -0.4, 1], [0.2, -0.4, 0]);
  expect(await box()).toEqual(near([0.2, tableM, -0.4]));
  expect(xr.errors).toEqual([]);
  await xr.close();
});

test('without AR the mouse places and drags the box on the floor', async () => {
  const xr = await openXrPage(chromium.browser, served.url, { modes: [] }, SIZE, WATCH_MATRICES);
  const { page } = xr;
  await page.getByText('Drag to look around').waitFor();
  const area = await page.locator('canvas').boundingBox();
  if (!area) throw new Error('The page has no canvas.');
  /** Height above the floor in meters, and where on the page, in pixels. */
  const box = async () => {
    const drawn = await drawnMatrices(xr);
    if (!drawn) return null;
    const clip = originOf(drawn.modelViewMatrix, new Matrix4().fromArray(drawn.projectionMatrix));
    const heightM = originOf(drawn.modelViewMatrix, new Matrix4().fromArray(drawn.viewMatrix).invert()).y;
    return [heightM, area.x + ((1 + clip.x) / 2) * area.width, area.y + ((1 - clip.y) / 2) * area.height];
  };
  const showsAt = (x: number, y: number) =>
    eventually(async () => expect(await box()).toEqual([expect.closeTo(0, 3), expect.closeTo(x, 0), expect.closeTo(y, 0)]));
  const from = [area.x + area.width * 0.6, area.y + area.height * 0.7] as const;
  const to = [area.x + area.width * 0.4, area.y + area.height * 0.8] as const;
  expect(await box()).toBe(null);
  await page.mouse.click(...from);
  await showsAt(...from);
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(...to, { steps: 4 });
  await page.mouse.up();
  // The view has not turned: the box is where the mouse is.
  await showsAt(...to);
  // The arrow keys move it, and do not turn the view.
  await page.keyboard.press('ArrowRight');
  await eventually(async () => expect((await box())?.[1]).toBeGreaterThan(to[0] + 5));
  await page.keyboard.press('Control+z');
  await showsAt(...to);
  // It stays there when the graphics context is lost and restored.
  await page.evaluate(async () => {
    const canvas = document.querySelector('canvas');
    const gl = canvas?.getContext('webgl2') as (WebGL2RenderingContext & { drawn?: unknown }) | null | undefined;
    const extension = gl?.getExtension('WEBGL_lose_context');
    if (!canvas || !gl || !extension) throw new Error('The context cannot be lost.');
    const happens = (type: string) => new Promise((resolve) => canvas.addEventListener(type, resolve, { once: true }));
    const lost = happens('webglcontextlost');
    extension.loseContext();
    await lost;
    // Browsers restore no context before the event has been handled.
    await new Promise((resolve) => setTimeout(resolve));
    delete gl.drawn;
    const restored = happens('webglcontextrestored');
    extension.restoreContext();
    await restored;
  });
  await showsAt(...to);
  // After Escape they turn the view.
  await page.keyboard.press('Escape');
  await eventually(async () => {
    await page.keyboard.press('ArrowRight');
    expect((await box())?.[1]).not.toBeCloseTo(to[0], 0);
  });
  expect(xr.errors).toEqual([]);
  await xr.close();
});

test.each([
  ['phone', 'move'],
  ['headset', 'add'],
] as const)('a first tap on a %s compiles nothing', async (device, mode) => {
  const shadowed = await serveProjectText(
    {
      nodes: {
        'box-x1': ['objects/primitive', { sizeM: [0.2, 0.2, 0.2] }],
        'place-x1': ['objects/place', { mode }],
        'scene-x1': 'layer/scene',
        'sun-x1': 'light/directional',
        'shadow-x1': 'layer/shadow',
        'planes-x1': 'world/planes',
        'over-x1': 'operator/over',
        'screen-x1': 'output/screen',
      },
      wires: [
        'box-x1.objects -> place-x1.objects',
        'place-x1.objects -> scene-x1.objects',
        'sun-x1.lights -> scene-x1.lights',
        'place-x1.objects -> shadow-x1.casters',
        'planes-x1.objects -> shadow-x1.receivers',
        'sun-x1.lights -> shadow-x1.lights',
        'scene-x1.layer -> over-x1.top',
        'shadow-x1.layer -> over-x1.bottom',
        'over-x1.layer -> screen-x1.layer',
      ],
    },
    {},
  );
  const xr = await openXrPage(chromium.browser, shadowed.url, { ...PHONE, device }, SIZE, `${WATCH_MATRICES}${COUNT}`);
  await xr.setPose(HEAD);
  await xr.enter();
  await xr.step(3);
  const linked = () => xr.page.evaluate(() => (globalThis as { linked?: number }).linked ?? 0);
  const before = await linked();
  expect(before).toBeGreaterThan(2);
  if (device === 'phone') await xr.touch([0.6, 0.55]);
  else {
    for (const trigger of [0, 1, 0]) {
      await xr.page.evaluate((trigger) => {
        const controller = scrimEmulator?.current?.device.controllers.right;
        controller?.position.set(0.2, 1.2, 0.5);
        controller?.quaternion.set(-Math.SQRT1_2, 0, 0, Math.SQRT1_2);
        controller?.updateButtonValue('trigger', trigger);
      }, trigger);
      await xr.step(2);
    }
  }
  expect(await linked()).toBe(before);
  expect(xr.errors).toEqual([]);
  await xr.close();
  await shadowed.close();
});
