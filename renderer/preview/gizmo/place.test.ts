import { describe, expect, test } from '@jest/globals';
import { Euler, Quaternion, Vector3 } from 'three';
import { type HandleNames, type Place, paramsOf, readPlace } from './place.ts';

function place(): Place {
  return { position: new Vector3(), quaternion: new Quaternion(), scale: new Vector3(1, 1, 1) };
}

function reader(values: Readonly<Record<string, readonly number[]>>) {
  return (param: string) => values[param] ?? null;
}

function read(handles: HandleNames, values: Readonly<Record<string, readonly number[]>>): Place {
  const out = place();
  readPlace(handles, reader(values), out);
  return out;
}

const TRANSFORM: HandleNames = { position: 'positionM', rotation: 'rotationRad', scale: 'scale' };

describe('a frame of position, angles and one factor', () => {
  const values = { positionM: [1, 2, 3], rotationRad: [0.3, -0.8, 0.4], scale: [2] };

  test('is turned about z, then x, then y', () => {
    const { position, quaternion, scale } = read(TRANSFORM, values);
    expect(position.toArray()).toEqual([1, 2, 3]);
    expect(scale.toArray()).toEqual([2, 2, 2]);
    const about = (x: number, y: number, z: number, angle: number) => new Quaternion().setFromAxisAngle(new Vector3(x, y, z), angle);
    const expected = about(0, 1, 0, -0.8)
      .multiply(about(1, 0, 0, 0.3))
      .multiply(about(0, 0, 1, 0.4));
    expect(quaternion.angleTo(expected)).toBeLessThan(1e-6);
  });

  test('comes back as it was', () => {
    const from = read(TRANSFORM, values);
    expect(paramsOf('move', TRANSFORM, reader(values), from, from)).toEqual({ positionM: [1, 2, 3] });
    const { rotationRad } = paramsOf('rotate', TRANSFORM, reader(values), from, from) as { rotationRad: number[] };
    expect(rotationRad.map((angle) => Math.round(angle * 1e6) / 1e6)).toEqual([0.3, -0.8, 0.4]);
  });

  test('follows whichever axis is pulled, up or down', () => {
    const from = read(TRANSFORM, values);
    const to = { ...from, scale: new Vector3(2, 3, 2) };
    expect(paramsOf('scale', TRANSFORM, reader(values), from, to)).toEqual({ scale: 3 });
    expect(paramsOf('scale', TRANSFORM, reader(values), from, { ...from, scale: new Vector3(0.5, 2, 2) })).toEqual({ scale: 0.5 });
  });
});

test('a size of three numbers changes along each axis, and one of nothing can still be pulled', () => {
  const handles: HandleNames = { scale: 'sizeM' };
  const values = { sizeM: [0.3, 0, 0.5] };
  const from = read(handles, values);
  expect(from.scale.y).toBeGreaterThan(0);
  const to = { ...from, scale: new Vector3(0.3, 0.2, 0.5) };
  expect(paramsOf('scale', handles, reader(values), from, to)).toEqual({ sizeM: [0.3, 0.2, 0.5] });
});

test('a spot light is turned by moving what it is aimed at, as far away as that was', () => {
  const handles: HandleNames = { position: 'positionM', aim: 'targetM' };
  const values = { positionM: [0, 2, 0], targetM: [0, 2, 3] };
  const from = read(handles, values);
  const turned = { ...from, quaternion: new Quaternion().setFromEuler(new Euler(0, Math.PI / 2, 0)).multiply(from.quaternion) };
  const { targetM } = paramsOf('rotate', handles, reader(values), from, turned) as { targetM: [number, number, number] };
  expect(new Vector3(...targetM).distanceTo(new Vector3(3, 2, 0))).toBeLessThan(1e-6);
  const down = read(handles, { positionM: [0, 2, 0], targetM: [0, 0, 0] });
  expect(new Vector3(0, 0, 1).applyQuaternion(down.quaternion).distanceTo(new Vector3(0, -1, 0))).toBeLessThan(1e-6);
});

test('azimuth and elevation are those of a directional light: azimuth a quarter turn from the right, elevation upwards', () => {
  const handles: HandleNames = { azimuth: 'azimuthRad', elevation: 'elevationRad' };
  const values = { azimuthRad: [0.6], elevationRad: [1] };
  const from = read(handles, values);
  const towardsLight = new Vector3(0, 0, 1).applyQuaternion(from.quaternion);
  const expected = new Vector3(Math.sin(0.6) * Math.cos(1), Math.sin(1), Math.cos(0.6) * Math.cos(1));
  expect(towardsLight.distanceTo(expected)).toBeLessThan(1e-6);
  const { azimuthRad, elevationRad } = paramsOf('rotate', handles, reader(values), from, from) as Record<string, number>;
  expect(azimuthRad).toBeCloseTo(0.6, 6);
  expect(elevationRad).toBeCloseTo(1, 6);
});

describe('copies', () => {
  test('of a row or a grid are spaced by the place of the second one, and turned about y', () => {
    const handles: HandleNames = { step: 'stepM', turn: 'turnRad' };
    const values = { stepM: [0.5, 0.1, -0.2], turnRad: [0.4] };
    const from = read(handles, values);
    expect(from.position.toArray()).toEqual([0.5, 0.1, -0.2]);
    expect(from.quaternion.angleTo(new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), 0.4))).toBeLessThan(1e-6);
    const to = { ...from, position: new Vector3(1, 0.1, -0.2) };
    expect(paramsOf('move', handles, reader(values), from, to)).toEqual({ stepM: [1, 0.1, -0.2] });
    const turned = { ...from, quaternion: new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), -1.1) };
    expect(paramsOf('rotate', handles, reader(values), from, turned)).toEqual({ turnRad: expect.closeTo(-1.1, 6) });
  });

  test('of a ring are as far from its middle as the first one, which is in front', () => {
    const handles: HandleNames = { radius: 'radiusM', turn: 'turnRad' };
    const values = { radiusM: [1.5], turnRad: [0] };
    const from = read(handles, values);
    expect(from.position.toArray()).toEqual([0, 0, 1.5]);
    const to = { ...from, position: new Vector3(0, 0, 2) };
    expect(paramsOf('move', handles, reader(values), from, to)).toEqual({ radiusM: 2 });
  });
});
