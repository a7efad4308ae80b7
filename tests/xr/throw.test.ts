import { afterEach, expect, test } from '@jest/globals';
import { projectEye } from '../../export/emulator/session/projection.ts';
import { useBrowser } from '../support/browser.ts';
import { captureHand } from '../support/captured-hand.ts';
import type { RgbaImage } from '../support/image.ts';
import { serveProjectText } from '../support/project-page.ts';
import { openXrPage, type XrPage } from './xr-page.ts';

const chromium = useBrowser();

const closing: { close(): Promise<void> }[] = [];
afterEach(async () => {
  for (const each of closing.splice(0).reverse()) await each.close();
});

const SIZE = { width: 480, height: 360 };
const FOV_Y_RAD = 1.4;
const EYE = [0, 1.5, 0.5] as const;
const RADIUS_M = 0.04;
/** Where the ball lies on an obstacle that is not drawn. The hand moves it in the plane through this point that faces the eye. */
const BALL = [-1, 1, -0.7] as const;
/** Velocity of the hand when it opens, meters per second. */
const HAND_MPS = [2.4, 1.8] as const;
const G = 9.81;
/** Frames in which the hand speeds up, and in which it keeps its speed, before it opens. */
const FASTER = 18;
const STEADY = 6;

const GRAPH = {
  nodes: {
    'ball-x1': ['objects/primitive', { shape: 'sphere', sizeM: [2 * RADIUS_M, 2 * RADIUS_M, 2 * RADIUS_M] }],
    'start-x1': ['objects/transform', { positionM: [...BALL] }],
    'body-x1': ['physics/body', { massKg: 0.1 }],
    'stand-x1': ['objects/primitive', { shape: 'box', sizeM: [0.2, 0.2, 0.2] }],
    'under-x1': ['objects/transform', { positionM: [BALL[0], BALL[1] - RADIUS_M - 0.1, BALL[2]] }],
    'fixed-x1': ['physics/body', { mode: 'static' }],
    'grab-x1': 'physics/grab',
    'world-x1': 'physics/world',
    'sun-x1': 'light/directional',
    'scene-x1': 'layer/scene',
    'screen-x1': 'output/screen',
  },
  wires: [
    'ball-x1.objects -> start-x1.objects',
    'start-x1.objects -> body-x1.objects',
    'stand-x1.objects -> under-x1.objects',
    'under-x1.objects -> fixed-x1.objects',
    'body-x1.body -> world-x1.bodies',
    'fixed-x1.body -> world-x1.bodies',
    'body-x1.body -> grab-x1.body',
    'grab-x1.hands -> world-x1.bodies',
    'body-x1.objects -> scene-x1.objects',
    'sun-x1.lights -> scene-x1.lights',
    'scene-x1.layer -> screen-x1.layer',
  ],
} as const;

/** The pinch of the captured left hand, from its origin. */
function pinchOffset(): number[] {
  const { worldFromJoints: m } = captureHand('pinch');
  // The tips of thumb and index finger.
  return [12, 13, 14].map((i) => 0.5 * ((m[16 * 4 + i] ?? 0) + (m[16 * 9 + i] ?? 0)));
}

/** Where the middle of what is drawn lies in the ball's plane, meters. */
function ballAt({ data, width }: RgbaImage): readonly [number, number] {
  let [x, y, count] = [0, 0, 0];
  for (let i = 0; 4 * i < data.length; i++) {
    if ((data[4 * i + 3] ?? 0) < 128) continue;
    x += (i % width) + 0.5;
    y += Math.floor(i / width) + 0.5;
    count++;
  }
  expect(count).toBeGreaterThan(20);
  const clipFromView = projectEye('none', FOV_Y_RAD, SIZE.width / SIZE.height, 0.1, 100);
  const depthM = EYE[2] - BALL[2];
  const right = (2 * x) / count / SIZE.width - 1;
  const up = 1 - (2 * y) / count / SIZE.height;
  return [EYE[0] + (right * depthM) / (clipFromView[0] ?? 1), EYE[1] + (up * depthM) / (clipFromView[5] ?? 1)];
}

/** Moves the hand so that its pinch is at a point of the ball's plane, opens or closes it, and plays a frame. */
async function play(xr: XrPage, [x, y]: readonly [number, number], isClosed: boolean): Promise<void> {
  const [dx = 0, dy = 0, dz = 0] = pinchOffset();
  await xr.page.evaluate(
    async ([position, closed]) => {
      const emulator = scrimEmulator?.current;
      emulator?.device.hands.left?.position.set(...position);
      emulator?.setGesture('left', closed ? 'pinch' : 'relaxed');
      await emulator?.stepFrame(1);
    },
    [[x - dx, y - dy, BALL[2] - dz] as [number, number, number], isClosed] as const,
  );
}

test('a bare hand picks up a ball in a headset and throws it: it flies as fast and the same way as the hand', async () => {
  const served = await serveProjectText(GRAPH, {});
  // Without workers each frame has its own step, however fast the test plays.
  const xr = await openXrPage(chromium.browser, served.url, { device: 'headset', views: 1 }, SIZE, 'delete globalThis.Worker;');
  closing.push(served, xr);
  await xr.enter();
  await xr.setPose({ position: EYE });
  await xr.page.evaluate(() => {
    const device = scrimEmulator?.current?.device;
    if (device?.hands.right) device.hands.right.connected = false;
    if (device) device.primaryInputMode = 'hand';
  });
  // It opens above the ball, comes down, pinches and lifts the ball.
  const over = (y: number): readonly [number, number] => [BALL[0], BALL[1] + y];
  for (let i = 0; i <= 10; i++) await play(xr, over(0.3 - 0.03 * i + RADIUS_M), false);
  const lying = ballAt(await xr.readLayer());
  for (let i = 0; i < 5; i++) await play(xr, over(RADIUS_M), true);
  for (let i = 0; i < 20; i++) await play(xr, over(RADIUS_M + 0.005 * i), true);
  const lifted = ballAt(await xr.readLayer());
  expect(Math.hypot(lying[0] - BALL[0], lying[1] - BALL[1])).toBeLessThan(0.01);
  expect(lifted[1] - lying[1]).toBeGreaterThan(0.08);

  // It swings, opens in full motion and goes on.
  const at = [BALL[0], BALL[1] + RADIUS_M + 0.095] as [number, number];
  const swing = async (part: number, isClosed: boolean) => {
    for (const axis of [0, 1] as const) at[axis] += (part * HAND_MPS[axis]) / 60;
    await play(xr, at, isClosed);
  };
  for (let i = 1; i <= FASTER; i++) await swing(i / FASTER, true);
  for (let i = 0; i < STEADY; i++) await swing(1, true);
  const before = 3;
  for (let i = 0; i < before; i++) await swing(1, false);
  const first = ballAt(await xr.readLayer());
  const frames = 9;
  for (let i = 0; i < frames; i++) await swing(Math.max(1 - i / 3, 0), false);
  const last = ballAt(await xr.readLayer());

  const flightS = frames / 60;
  const x = (last[0] - first[0]) / flightS;
  // Gravity acts since the hand opened.
  const y = (last[1] - first[1]) / flightS + G * (before / 60 + 0.5 * flightS);
  expect(Math.hypot(x - HAND_MPS[0], y - HAND_MPS[1])).toBeLessThan(0.1 * Math.hypot(...HAND_MPS));
  expect(xr.errors).toEqual([]);
});
