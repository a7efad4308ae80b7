import { describe, expect, test } from '@jest/globals';
import { Matrix4, Vector3 } from 'three';
import { type DeviceAngles, setUpright } from '../../../../nodes/kit/device-orientation.ts';
import { createMatrix } from '../matrix.ts';
import { createCameraViewer } from './camera-viewer.ts';

function start(given: Partial<DeviceAngles> | null) {
  const angles: DeviceAngles = { alphaRad: 0, betaRad: 0, gammaRad: 0, screenRad: 0 };
  setUpright(angles);
  Object.assign(angles, given);
  const viewer = createCameraViewer({ angles, present: given !== null });
  const look = () => {
    const m = createMatrix();
    viewer.writeWorldFromView(m);
    const pose = new Matrix4().fromArray(m);
    const round = (v: Vector3) => v.toArray().map((x) => Number(x.toFixed(4)) + 0);
    return { ahead: round(new Vector3(0, 0, -1).transformDirection(pose)), at: round(new Vector3().setFromMatrixPosition(pose)) };
  };
  return { viewer, angles, look };
}

describe('where a viewer with a camera stands', () => {
  test('ahead is where the device points first; from then on it turns with the device', () => {
    const { angles, look } = start({ alphaRad: 2 });
    expect(look()).toEqual({ ahead: [0, 0, -1], at: [0, 1.5, 2] });
    angles.alphaRad += Math.PI / 2;
    expect(look().ahead).toEqual([-1, 0, 0]);
    angles.betaRad = Math.PI / 4;
    expect(look().ahead[1]).toBeCloseTo(-Math.SQRT1_2, 4);
    // Turning is all it tells.
    expect(look().at).toEqual([0, 1.5, 2]);
  });

  test('going back to the start makes the present direction ahead', () => {
    const { viewer, angles, look } = start({});
    look();
    angles.alphaRad = 1;
    viewer.zoom(2);
    viewer.reset();
    expect(look()).toEqual({ ahead: [0, 0, -1], at: [0, 1.5, 2] });
  });

  test('steps go the way one looks, along the floor, and not out of sight', () => {
    const { viewer, look } = start(null);
    look();
    viewer.zoom(Math.E);
    expect(look().at).toEqual([0, 1.5, 1]);
    viewer.rotate(-Math.PI / 2, 0);
    expect(look().ahead[0]).toBeLessThan(-0.8);
    viewer.zoom(Math.E);
    expect(look().at).toEqual([-1, 1.5, 1]);
    viewer.pan(0.5, 0);
    expect(look().at).toEqual([-1, 1.5, 0.5]);
    for (let i = 0; i < 100; i++) viewer.zoom(2);
    expect(look().at).toEqual([-5, 1.5, 0.5]);
  });

  test('without a sensor, dragging looks up and down, too; with one, the device alone does', () => {
    const without = start(null);
    expect(without.look().ahead[1]).toBeCloseTo(-Math.sin(0.35), 4);
    without.viewer.rotate(0, 0.5);
    expect(without.look().ahead[1]).toBeCloseTo(Math.sin(0.15), 4);
    without.viewer.rotate(0, 10);
    expect(without.look().ahead[1]).toBeLessThan(1);
    const withOne = start({});
    withOne.viewer.rotate(0, 0.5);
    expect(withOne.look().ahead[1]).toBeCloseTo(0, 4);
  });

  test('a drag up or down sets the height of the eyes, within reach, and going back resets it', () => {
    // 30° down: the view meets the floor 3 m away.
    const { viewer, look } = start({ betaRad: Math.PI / 3 });
    look();
    viewer.rotate(0.01, 0.5);
    // 0.5 / π of an image that shows 0.9 rad, at 3 m.
    expect(look().at[1]).toBeCloseTo(1.5 + (0.5 / Math.PI) * 0.9 * 3, 3);
    viewer.rotate(1, 0.5);
    expect(look().at[1]).toBeCloseTo(1.9297, 3);
    viewer.rotate(0, -50);
    expect(look().at[1]).toBe(0.3);
    viewer.reset();
    expect(look().at[1]).toBe(1.5);
    const without = start(null);
    without.viewer.rotate(0, 0.5);
    expect(without.look().at[1]).toBe(1.5);
    without.viewer.pan(0, 0.25);
    expect(without.look().at[1]).toBe(1.75);
  });
});
