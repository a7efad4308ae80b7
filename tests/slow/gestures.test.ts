import { expect, test } from '@jest/globals';
import { Euler, Matrix4, Vector3 } from 'three';
import type { Emulator } from '../../export/emulator/emulator.ts';
import { useBrowser } from '../support/browser.ts';
import { serveProjectText } from '../support/project-page.ts';
import { drawnMatrices, WATCH_MATRICES } from '../xr/drawn-matrices.ts';
import { openXrPage } from '../xr/xr-page.ts';

const chromium = useBrowser();
const SIZE = { width: 240, height: 180 } as const;
/** A low rate makes long presses short. */
const RATE_HZ = 20;
/** Straight ahead. */
const HEAD = { position: [0, 1.5, 0] } as const;
/** Radius of the fingers around the middle, in heights of the screen. */
const RADIUS = 0.15;
/** How far a count moves the box. */
const STEP_M = 0.1;
const DISTANCE_M = 2;

type Touch = readonly ['press' | 'move' | 'release', ...points: readonly (readonly [x: number, y: number])[]];

test('a box counts taps, double taps and long presses, and follows drag, pinch and twist of fingers on a phone', async () => {
  const served = await serveProjectText(
    {
      nodes: {
        'box-x1': ['objects/primitive', { sizeM: [0.2, 0.2, 0.2] }],
        'gestures-x1': ['input/gestures', { longPressS: 0.3, distanceM: DISTANCE_M }],
        'taps-x1': ['value/counter', { step: STEP_M }],
        'doubles-x1': ['value/counter', { step: STEP_M }],
        'longs-x1': ['value/counter', { step: STEP_M }],
        'counts-x1': ['value/make-vector3', { x: { port: 0 }, y: { port: 0 }, z: { port: 0 } }],
        'angles-x1': ['value/make-vector3', { z: { port: 0 } }],
        'move-x1': ['objects/transform', { positionM: { port: [0, 0, 0] }, rotationRad: { port: [0, 0, 0] }, scale: { port: 1 } }],
        'count-x1': ['objects/transform', { positionM: { port: [0, 0, 0] } }],
        'ahead-x1': ['objects/transform', { positionM: [0, 1.5, -3] }],
        'scene-x1': 'layer/scene',
        'sun-x1': 'light/directional',
        'screen-x1': 'output/screen',
      },
      wires: [
        'gestures-x1.tapped -> taps-x1.up',
        'gestures-x1.doubleTapped -> doubles-x1.up',
        'gestures-x1.longPressed -> longs-x1.up',
        'taps-x1.number -> counts-x1.x',
        'doubles-x1.number -> counts-x1.y',
        'longs-x1.number -> counts-x1.z',
        'gestures-x1.dragM -> move-x1.positionM',
        'gestures-x1.twistRad -> angles-x1.z',
        'angles-x1.vector -> move-x1.rotationRad',
        'gestures-x1.scale -> move-x1.scale',
        'box-x1.objects -> move-x1.objects',
        'counts-x1.vector -> count-x1.positionM',
        'move-x1.objects -> count-x1.objects',
        'count-x1.objects -> ahead-x1.objects',
        'ahead-x1.objects -> scene-x1.objects',
        'sun-x1.lights -> scene-x1.lights',
        'scene-x1.layer -> screen-x1.layer',
      ],
    },
    {},
  );
  const xr = await openXrPage(chromium.browser, served.url, { device: 'phone', framesPerSecond: RATE_HZ }, SIZE, WATCH_MATRICES);
  await xr.setPose(HEAD);
  await xr.enter();
  const play = async (frames: number, ...[act, ...points]: Touch) => {
    await xr.page.evaluate(
      ([how, places]) => {
        for (const [finger, [x, y]] of places.entries()) {
          const emulator = (globalThis as { scrimEmulator?: { current: Emulator | null } }).scrimEmulator?.current;
          if (how === 'release') emulator?.release(finger);
          else emulator?.[how](x, y, finger);
        }
      },
      [act, points] as const,
    );
    await xr.step(frames);
  };
  /** From where the box stands at first. */
  const seen = async () => {
    const drawn = await drawnMatrices(xr);
    if (!drawn) throw new Error('The box is not drawn.');
    const view = new Matrix4().fromArray(drawn.viewMatrix).invert();
    const matrix = new Matrix4().makeTranslation(0, -1.5, 3).multiply(view).multiply(new Matrix4().fromArray(drawn.modelViewMatrix));
    const scale = new Vector3().setFromMatrixScale(matrix).x / 0.2;
    const { x, y, z } = new Euler().setFromRotationMatrix(new Matrix4().extractRotation(matrix));
    return { at: new Vector3().setFromMatrixPosition(matrix).toArray(), turnRad: [x, y, z], scale };
  };
  const near = (numbers: readonly number[], digits = 4) => numbers.map((n) => expect.closeTo(n, digits));
  const still = { turnRad: near([0, 0, 0]), scale: expect.closeTo(1, 4) };
  const tap = async () => {
    await play(2, 'press', [0.5, 0.5]);
    await play(3, 'release', [0.5, 0.5]);
  };
  expect(await seen()).toEqual({ at: near([0, 0, 0]), ...still });
  await tap();
  expect(await seen()).toEqual({ at: near([STEP_M, 0, 0]), ...still });
  await tap();
  expect(await seen()).toEqual({ at: near([2 * STEP_M, STEP_M, 0]), ...still });
  // The third begins anew.
  await tap();
  expect(await seen()).toEqual({ at: near([3 * STEP_M, STEP_M, 0]), ...still });
  await play(8, 'press', [0.5, 0.5]);
  await play(3, 'release', [0.5, 0.5]);
  const counted = [3 * STEP_M, STEP_M, STEP_M] as const;
  expect(await seen()).toEqual({ at: near(counted), ...still });

  // A drag to the right: the point of the ray at the distance goes around the head.
  await play(2, 'press', [0.5, 0.5]);
  await play(2, 'move', [0.55, 0.5]);
  await play(2, 'move', [0.65, 0.5]);
  await play(3, 'release', [0.65, 0.5]);
  const fovY = await xr.page.evaluate(() => scrimEmulator?.current?.device.fovy ?? 0);
  const angle = Math.atan(2 * 0.15 * Math.tan(fovY / 2) * (SIZE.width / SIZE.height));
  const dragged = [counted[0] + DISTANCE_M * Math.sin(angle), counted[1], counted[2] + DISTANCE_M * (1 - Math.cos(angle))];
  expect(await seen()).toEqual({ at: near(dragged, 3), ...still });

  // Fingers around the middle: first apart, then around each other. A gesture counts from its threshold on.
  const around = (radius: number, turnRad: number) =>
    [0, Math.PI].map((side): readonly [number, number] => [
      0.5 + (radius * Math.cos(turnRad + side) * SIZE.height) / SIZE.width,
      0.5 - radius * Math.sin(turnRad + side),
    ]);
  await play(2, 'press', ...around(RADIUS, 0));
  for (const factor of [1.1, 1.4, 1.8, 2.2]) await play(1, 'move', ...around(RADIUS * factor, 0));
  await play(3, 'release', ...around(RADIUS * 2.2, 0));
  const pinched = await seen();
  expect(pinched).toEqual({ at: near(dragged, 3), turnRad: near([0, 0, 0], 3), scale: expect.any(Number) });
  expect(pinched.scale / 2).toBeGreaterThan(0.95);
  expect(pinched.scale / 2).toBeLessThan(1.05);
  await play(2, 'press', ...around(RADIUS, 0));
  for (const degrees of [10, 25, 40, 55, 70]) await play(1, 'move', ...around(RADIUS, (degrees * Math.PI) / 180));
  await play(3, 'release', ...around(RADIUS, (70 * Math.PI) / 180));
  const twisted = await seen();
  expect(twisted).toEqual({ at: near(dragged, 3), turnRad: near([0, 0, Math.PI / 3], 1), scale: expect.closeTo(pinched.scale, 2) });
  expect(Math.abs((twisted.turnRad[2] ?? 0) - Math.PI / 3)).toBeLessThan(0.02);

  expect(xr.errors).toEqual([]);
  await xr.close();
  await served.close();
});
