import { inflateSync } from 'node:zlib';
import { expect, test } from '@jest/globals';
import { DataTexture, FloatType, HalfFloatType, RGBAFormat } from 'three';
import { EXRExporter, NO_COMPRESSION, ZIP_COMPRESSION, ZIPS_COMPRESSION } from 'three/addons/exporters/EXRExporter.js';
import type { CaptureMesh } from '../../../nodes/kit/capture.ts';
import { checkLens } from '../lens.ts';
import { pinholeFor } from '../undistort.ts';
import { depthFromMesh } from './depth-from-mesh.ts';
import { type DepthMap, depthForPinhole } from './depth-map.ts';
import { depthOfPoints } from './depth-of-points.ts';
import { type DepthAnswers, depthScaleOf } from './depth-scale.ts';
import { readExr } from './exr.ts';
import { readColmapDepth, readPfm } from './read-depth.ts';

const ascii = (text: string, floats: readonly number[], isLittleEndian = true): Uint8Array => {
  const bytes = new Uint8Array(text.length + 4 * floats.length);
  bytes.set(new TextEncoder().encode(text));
  const view = new DataView(bytes.buffer, text.length);
  floats.forEach((value, i) => {
    view.setFloat32(4 * i, value, isLittleEndian);
  });
  return bytes;
};
/** The attribute `a` of the type `b` has −8 bytes. */
const ENDLESS_EXR = Uint8Array.of(0x76, 0x2f, 0x31, 1, 2, 0, 0, 0, 0x61, 0, 0x62, 0, 0xf8, 0xff, 0xff, 0xff, 0);
const inflate = (bytes: Uint8Array) => new Uint8Array(inflateSync(bytes));

test('reads PFM files of both byte orders, whose first row is the lowest, and depth maps of COLMAP', () => {
  const upwards = [5, 6, 1, 2];
  for (const isLittleEndian of [true, false]) {
    const map = readPfm(ascii(`Pf\n2 2\n${isLittleEndian ? '-1.0' : '1'}\n`, upwards, isLittleEndian), 'a.pfm');
    expect([map.widthPx, map.heightPx, ...map.values]).toEqual([2, 2, 1, 2, 5, 6]);
  }
  expect([...readColmapDepth(ascii('2&2&1&', upwards), 'a.bin').values]).toEqual(upwards);
});

test.each([
  [ZIP_COMPRESSION, FloatType],
  [ZIPS_COMPRESSION, FloatType],
  [NO_COMPRESSION, HalfFloatType],
])('reads EXR files with the compression %i and the type %i', async (compression, type) => {
  const [width, height] = [7, 37];
  const depths = Float32Array.from({ length: width * height }, (_, i) => 0.5 + (i % 64) / 8);
  const data = Float32Array.from({ length: 4 * depths.length }, (_, i) => (i % 4 === 0 ? (depths[i / 4] ?? 0) : 9));
  const texture = new DataTexture(data, width, height, RGBAFormat, FloatType);
  texture.flipY = true;
  const map = readExr(await new EXRExporter().parse(texture, { compression, type }), 'a.exr', inflate);
  expect([map.widthPx, map.heightPx]).toEqual([width, height]);
  // Every depth is there, row by row; the exporter may turn the picture over.
  const rows = Array.from({ length: height }, (_, row) => [...map.values.subarray(row * width, (row + 1) * width)]);
  const given = Array.from({ length: height }, (_, row) => [...depths.subarray(row * width, (row + 1) * width)]);
  expect([given, [...given].reverse()]).toContainEqual(rows);
});

test.each<[string, () => unknown, string]>([
  ['a PFM file that was cut', () => readPfm(ascii('Pf\n2 2\n-1\n', [1, 2]), 'a.pfm'), 'a.pfm is incomplete'],
  ['a PFM file of colors', () => readPfm(ascii('PF\n2 2\n-1\n', [1, 2]), 'a.pfm'), 'colors'],
  ['a huge PFM file', () => readPfm(ascii('Pf\n99999 99999\n-1\n', []), 'a.pfm'), 'more than 8192'],
  ['a normal map of COLMAP', () => readColmapDepth(ascii('2&2&3&', []), 'a.bin'), '3 channels'],
  ['another file', () => readColmapDepth(ascii('hello', []), 'a.bin'), 'not a depth map of COLMAP'],
  ['no EXR file', () => readExr(ascii('hello world', []), 'a.exr', inflate), 'not an EXR file'],
  ['an EXR file whose first attribute leads back to itself', () => readExr(ENDLESS_EXR, 'a.exr', inflate), 'incomplete'],
  ['an EXR file that was cut', () => readExr(Uint8Array.of(0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0, 99), 'a.exr', inflate), 'incomplete'],
])('refuses %s', (_, read, reason) => {
  expect(read).toThrow(reason);
});

const LENS = checkLens({
  projection: 'perspective',
  widthPx: 40,
  heightPx: 30,
  fxPx: 30,
  fyPx: 30,
  cxPx: 20,
  cyPx: 15,
  radial: [],
  tangential: [0, 0],
});
const PINHOLE = pinholeFor(LENS, 40);
const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** A wall 4 m away, and a floor that passes below and behind the camera. */
const ROOM: CaptureMesh = {
  positions: Float32Array.of(-9, -9, -4, 9, -9, -4, 9, 9, -4, -9, 9, -4, -9, -1, -4, 9, -1, -4, 9, -1, 4, -9, -1, 4),
  indices: Uint32Array.of(0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7),
};

test('draws the depth of a mesh, also of triangles that are partly behind the camera', () => {
  const map = depthFromMesh(ROOM, PINHOLE, IDENTITY);
  const at = (column: number, row: number) => map.values[row * 40 + column];
  expect(at(20, 5)).toBeCloseTo(4, 4);
  // The ray through the center of row 29 falls 14.5/30 m per meter; the floor is 1 m below.
  expect(at(20, 29)).toBeCloseTo(30 / 14.5, 3);
  expect(map.values.every((depth) => depth > 0)).toBe(true);
});

const mesh = depthFromMesh(ROOM, PINHOLE, IDENTITY);
const changed = (map: DepthMap, change: (depth: number, i: number) => number): DepthMap => ({ ...map, values: map.values.map(change) });
const alongRay = changed(mesh, (depth, i) => depth * Math.hypot(((i % 40) + 0.5 - 20) / 30, (Math.floor(i / 40) + 0.5 - 15) / 30, 1));
const scaleOf = (map: DepthMap, answers: Partial<DepthAnswers> = {}, metersPerUnit = 1, withMesh = true, isGuess = false) => {
  const file = { z: depthForPinhole(map, LENS, PINHOLE, 'z', 1), ray: depthForPinhole(map, LENS, PINHOLE, 'ray', 1) };
  const sample = { name: 'a.jpg', file, surface: withMesh ? { kind: 'mesh' as const, map: mesh } : null, usualUnit: 'mm' } as const;
  return depthScaleOf([sample], { unit: null, kind: null, ...answers }, metersPerUnit, isGuess);
};

test('finds the unit and the kind of depth by the mesh', () => {
  expect(scaleOf(changed(mesh, (depth) => depth * 1000))).toMatchObject({ unit: 'mm', kind: 'z', scale: 0.001 });
  expect(scaleOf(alongRay)).toMatchObject({ unit: 'm', kind: 'ray', scale: 1 });
  // A reconstruction of 0.25 m per unit, and a sensor that measures in millimeters.
  expect(
    scaleOf(
      changed(mesh, (depth) => depth * 250),
      {},
      0.25,
    ),
  ).toMatchObject({ unit: 'mm', kind: 'z', scale: 0.004 });
  expect(scaleOf(mesh, {}, 0.25)).toMatchObject({ unit: 'reconstruction', scale: 1 });
  // Unknown values and infinities take no part.
  const holes = changed(mesh, (depth, i) => [depth, Number.NaN, Infinity, -1, 1e10][i % 5] ?? 0);
  expect(scaleOf(holes)).toMatchObject({ unit: 'm', kind: 'z' });
});

test('finds units of sensors that are not millimeters, if they fit', () => {
  const units = [5000, 4000, 10_000, 100].map((perMeter) => scaleOf(changed(mesh, (depth) => depth * perMeter * 1.03)).unit);
  expect(units).toEqual([0.0002, 0.00025, 0.0001, 0.01]);
  // Twice as far as the mesh is not a rare unit.
  expect(scaleOf(changed(mesh, (depth) => depth * 1000 * 1.9))).toMatchObject({ unit: 'mm', timesSurface: expect.closeTo(1.9, 3) });
});

test('depth in meters corrects a guessed scale, and no other', () => {
  const map = changed(mesh, (depth) => depth * 700);
  expect(scaleOf(map, {}, 3, true, true)).toMatchObject({
    unit: 'mm',
    kind: 'z',
    scale: expect.closeTo(1 / 700, 6),
    metersPerUnit: expect.closeTo(0.7, 4),
  });
  expect(scaleOf(map, { unit: 0.0002 }, 3, true, true).metersPerUnit).toBeCloseTo(0.14, 4);
  expect(scaleOf(mesh, { unit: 'reconstruction' }, 3, false, true).metersPerUnit).toBe(3);
  expect(scaleOf(map, {}, 0.7).metersPerUnit).toBe(0.7);
});

test('finds the depth of points at their pixels, the nearest of each', () => {
  // Of a camera at height 2: a point 4 m ahead, one behind it, one at the left, one outside, and one behind the camera.
  const observations = [0, 2, -4, 0.001, 2, -5, -1, 2, -3, -9, 2, -4, 0, 2, 4];
  const view = { name: 'a.jpg', model: 'PINHOLE', lens: () => LENS, sizePx: null, depthName: null };
  const seen = Float64Array.from({ length: 25 }, (_, i) => (i % 5 < 2 ? 0 : (observations[3 * Math.floor(i / 5) + (i % 5) - 2] ?? 0)));
  const map = depthOfPoints({ ...view, worldFromCamera: [...IDENTITY.slice(0, 12), 0, 2, 0, 1], observations: seen }, PINHOLE);
  const found = [...(map?.values ?? [])].flatMap((depth, i) => (depth > 0 ? [[i % 40, Math.floor(i / 40), depth]] : []));
  expect(found).toEqual([
    [10, 15, 3],
    [20, 15, 4],
  ]);
});

test('refuses a unit that neither the mesh nor a place allows', () => {
  expect(() => scaleOf(mesh, { unit: 'mm' })).toThrow('the depth of a.jpg is 0.001 times that of the mesh with the unit mm');
  expect(() => scaleOf(changed(mesh, (depth) => depth * 5e4))).toThrow('in any usual unit');
  expect(() => scaleOf(mesh, { unit: 'mm' }, 1, false)).toThrow('is 0.004 m in the middle, if its unit is mm');
});
