import { resolve } from 'node:path';
import { afterAll, expect, test } from '@jest/globals';
import { encode } from 'jpeg-js';
import { createPhotoWorkers } from '../photos/photo-workers.ts';
import { coarseMesh, reducedPhoto } from './coarse-capture.ts';

const workers = createPhotoWorkers(resolve('.'), 640 * 480);
afterAll(workers.dispose);

/** A hemisphere of radius 1 m around the origin; each triangle has vertices of its own. */
function hemisphere(rings: number, sectors: number) {
  const at = (ring: number, sector: number): readonly number[] => {
    const [down, around] = [(ring / rings) * (Math.PI / 2), ((sector % sectors) / sectors) * 2 * Math.PI];
    return [Math.sin(down) * Math.cos(around), Math.cos(down), Math.sin(down) * Math.sin(around)];
  };
  const corners: number[] = [];
  for (let ring = 0; ring < rings; ring++) {
    for (let sector = 0; sector < sectors; sector++) {
      const [a, b, c, d] = [at(ring, sector), at(ring + 1, sector), at(ring, sector + 1), at(ring + 1, sector + 1)];
      corners.push(...a, ...b, ...c, ...c, ...b, ...d);
    }
  }
  return { positions: Float32Array.from(corners), indices: Uint32Array.from({ length: corners.length / 3 }, (_, i) => i) };
}

test('a coarse mesh has the shape of the mesh with few triangles, also of a mesh without shared vertices', async () => {
  const coarse = await coarseMesh(hemisphere(100, 200));
  expect(coarse).not.toBeNull();
  const { positions, indices } = coarse ?? { positions: new Float32Array(), indices: new Uint32Array() };
  expect(indices.length / 3).toBeLessThanOrEqual(3000);
  expect(indices.length / 3).toBeGreaterThan(2000);
  expect(Math.max(...indices)).toBe(positions.length / 3 - 1);
  for (let i = 0; i < indices.length; i += 3) {
    const corners = [0, 1, 2].map((corner) => 3 * (indices[i + corner] ?? 0));
    const middle = [0, 1, 2].map((axis) => corners.reduce((sum, at) => sum + (positions[at + axis] ?? 0) / 3, 0));
    expect(Math.abs(Math.hypot(...middle) - 1)).toBeLessThan(0.01);
  }
});

test('a mesh that is not much larger has none', async () => {
  expect(await coarseMesh(hemisphere(30, 60))).toBeNull();
});

/** Noise, which JPEG cannot compress well, with a left half that is brighter. */
function photo(width: number, height: number): Uint8Array {
  const data = new Uint8Array(4 * width * height).fill(255);
  let state = 1;
  for (let i = 0; i < data.length; i++) {
    if (i % 4 === 3) continue;
    state = (state * 48271) % 2147483647;
    data[i] = (state % 64) + ((i / 4) % width < width / 2 ? 160 : 32);
  }
  return new Uint8Array(encode({ width, height, data }, 90).data);
}

test('a photograph is reduced to 640 pixels with its shape and colors, once', async () => {
  const kept = new Map<string, Uint8Array>();
  let reads = 0;
  const cache = {
    read: async (name: string) => {
      reads++;
      return kept.get(name) ?? null;
    },
    write: async (name: string, bytes: Uint8Array) => void kept.set(name, bytes),
  };
  const large = photo(1300, 700);
  const reduced = await reducedPhoto(large, cache, workers);
  const { widthPx: width, heightPx: height, data } = await workers.run({ kind: 'decode', file: reduced ?? new Uint8Array() });
  expect([width, height]).toEqual([433, 233]);
  const red = (x: number): number => data[4 * (116 * width + x)] ?? 0;
  // The mean of the noise is 31.5.
  expect(Math.abs(red(100) - 191.5)).toBeLessThan(25);
  expect(Math.abs(red(330) - 63.5)).toBeLessThan(25);
  expect(await reducedPhoto(large, cache, workers)).toBe(reduced);
  expect([reads, kept.size]).toEqual([2, 1]);
});

test('the reduced form of a photograph has the same bytes on each thread', async () => {
  const large = photo(1300, 700);
  const forms = await Promise.all([0, 1, 2].map(() => reducedPhoto(large, null, workers)));
  expect(forms[0]?.length).toBeGreaterThan(1000);
  expect(forms).toEqual(Array(3).fill(forms[0]));
});

test('small photographs, PNG files, and photographs that cannot be decoded have no reduced form', async () => {
  expect(await reducedPhoto(photo(100, 100), null, workers)).toBeNull();
  const arithmetic = photo(1300, 700);
  // SOF9 in the place of SOF0: a form of JPEG that browsers may read, but not the decoder.
  arithmetic[arithmetic.indexOf(0xc0)] = 0xc9;
  expect(await reducedPhoto(arithmetic, null, workers)).toBeNull();
  expect(await reducedPhoto(new Uint8Array(200_000), null, workers)).toBeNull();
});
