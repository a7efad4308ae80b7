import { expect, test } from '@jest/globals';
import { Euler, Matrix4, Quaternion, Vector3 } from 'three';
import { useBrowser } from '../support/browser.ts';
import { serveProjectText } from '../support/project-page.ts';
import { drawnMatrices, WATCH_MATRICES } from '../xr/drawn-matrices.ts';
import { openXrPage } from '../xr/xr-page.ts';

const chromium = useBrowser();
const HEAD_M = [0, 1.6, 0.5] as const;
const OFFSET_M = [0, 0.15, -0.1] as const;
const TIME_CONSTANT_S = 0.1;
const RATE_HZ = 20;

test('an object on a controller lags behind it by its time constant, keeps its offset and faces the visitor', async () => {
  const served = await serveProjectText(
    {
      nodes: {
        'controller-x1': ['input/gamepad', { hand: 'right' }],
        'head-x1': 'input/head',
        'follow-x1': ['pose/follow', { timeConstantS: TIME_CONSTANT_S }],
        'offset-x1': ['pose/offset', { offsetM: OFFSET_M }],
        'face-x1': 'pose/look-at',
        'box-x1': ['objects/primitive', { sizeM: [0.05, 0.05, 0.05] }],
        'attach-x1': 'objects/at-pose',
        'scene-x1': 'layer/scene',
        'sun-x1': 'light/directional',
        'screen-x1': 'output/screen',
      },
      wires: [
        'controller-x1.grip -> follow-x1.pose',
        'follow-x1.pose -> offset-x1.pose',
        'offset-x1.pose -> face-x1.pose',
        'head-x1.pose -> face-x1.target',
        'face-x1.pose -> attach-x1.pose',
        'box-x1.objects -> attach-x1.objects',
        'attach-x1.objects -> scene-x1.objects',
        'sun-x1.lights -> scene-x1.lights',
        'scene-x1.layer -> screen-x1.layer',
      ],
    },
    {},
  );
  const xr = await openXrPage(
    chromium.browser,
    served.url,
    { device: 'headset', framesPerSecond: RATE_HZ },
    { width: 240, height: 120 },
    WATCH_MATRICES,
  );
  await xr.setPose({ position: HEAD_M });
  const hold = (position: Vector3, turn: Quaternion) =>
    xr.page.evaluate(
      ([at, quaternion]) => {
        const controller = scrimEmulator?.current?.device.controllers.right;
        if (!controller) throw new Error('There is no right controller.');
        controller.position.set(...at);
        controller.quaternion.set(...quaternion);
      },
      [position.toArray(), turn.toArray()] as const,
    );
  /** In the room, of the box and of the grip that the page is told. */
  const box = async () => {
    const drawn = await drawnMatrices(xr);
    if (!drawn) throw new Error('The box is not drawn.');
    return new Matrix4().fromArray(drawn.viewMatrix).invert().multiply(new Matrix4().fromArray(drawn.modelViewMatrix));
  };
  const positionOf = (matrix: Matrix4) => new Vector3().setFromMatrixPosition(matrix);
  const turn = new Quaternion().setFromEuler(new Euler(0.3, -0.5, 0.2));
  const from = new Vector3(-0.1, 1.4, -0.6);
  await hold(from, turn);
  await xr.enter();
  await xr.step(30);
  const settled = positionOf(await box());
  // The device's grip is a constant distance from its ray, so differences tell of the chain alone.
  const by = new Vector3(0.3, 0.1, -0.2);
  await hold(from.clone().add(by), turn);
  const frames = 3;
  await xr.step(frames);
  const left =
    1 -
    positionOf(await box())
      .sub(settled)
      .length() /
      by.length();
  // One frame more or less, as the device tells of the move.
  expect(left).toBeGreaterThan(Math.exp(-(frames + 1) / RATE_HZ / TIME_CONSTANT_S));
  expect(left).toBeLessThan(Math.exp(-(frames - 1) / RATE_HZ / TIME_CONSTANT_S));
  await xr.step(30);
  const arrived = await box();
  expect(positionOf(arrived).sub(settled).distanceTo(by)).toBeLessThan(1e-3);
  // Turned by half a turn about the vertical, the offset turns with the hand.
  const about = new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), Math.PI);
  await hold(from.clone().add(by), about.clone().multiply(turn));
  await xr.step(30);
  const turned = await box();
  const [before, after] = [arrived, turned].map((matrix) => positionOf(matrix).sub(from).sub(by));
  expect(after?.distanceTo((before ?? new Vector3()).applyQuaternion(about))).toBeLessThan(1e-3);
  // Billboard: the front, +z, points to the eyes, wherever the hand is and however it is turned.
  for (const matrix of [arrived, turned]) {
    const toHead = new Vector3(...HEAD_M).sub(positionOf(matrix)).normalize();
    expect(new Vector3().setFromMatrixColumn(matrix, 2).normalize().dot(toHead)).toBeGreaterThan(0.9999);
  }
  expect(xr.errors).toEqual([]);
  await xr.close();
  await served.close();
});
