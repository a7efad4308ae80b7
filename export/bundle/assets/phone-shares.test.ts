import { describe, expect, test } from '@jest/globals';
import type { CaptureDocument } from '../../../nodes/kit/capture.ts';
import { type Place, phoneShares, sizeOfCapture, sizeOfSplats } from './phone-shares.ts';

const MESH = { file: 'mesh.bin', vertexCount: 60_000, triangleCount: 120_000 };

/** A capture of photographs of 2 megapixels. */
function capture(path: string, views: number): Place {
  const view = { widthPx: 1600, heightPx: 1200, fxPx: 1400, fyPx: 1400, cxPx: 800, cyPx: 600, worldFromCamera: [] };
  const document: CaptureDocument = {
    format: 'scrim-capture',
    version: 1,
    mesh: MESH,
    coarseMesh: { file: 'coarse.bin', vertexCount: 1500, triangleCount: 3000 },
    views: Array.from({ length: views }, (_, i) => ({ ...view, file: `${i}.avif` })),
  };
  return { asset: { id: path, kind: 'capture', path }, capture: document };
}

function splats(path: string, count: number): Place {
  return { asset: { id: path, kind: 'splats', path }, capture: null, splats: { count, degree: 3 } };
}

const bytesOn = (shares: ReadonlyMap<Place, number>, place: Place): number =>
  (sizeOfCapture(place, shares.get(place)) ?? sizeOfSplats(place, shares.get(place)))?.gpuBytes ?? 0;

describe('the memory of a page on phones', () => {
  test('belongs to its only place, as before', () => {
    for (const place of [capture('room', 40), capture('corner', 2), splats('garden', 3_000_000)]) {
      expect(phoneShares([place]).get(place)).toBe(128e6);
    }
  });

  test('is shared by two captures and splats, of which a small one stays whole', () => {
    const places = [capture('room', 40), capture('hall', 30), splats('plant', 100_000)];
    const shares = phoneShares(places);
    const bytes = places.map((place) => bytesOn(shares, place));
    expect(bytes.reduce((sum, each) => sum + each)).toBeLessThanOrEqual(128e6);
    expect(bytes.reduce((sum, each) => sum + each)).toBeGreaterThan(0.95 * 128e6);
    expect(bytes[2]).toBe(100_000 * 84);
    expect(shares.get(places[0] as Place)).toBe(shares.get(places[1] as Place));
  });

  test('leaves nothing out of a place that needs less than an equal part', () => {
    // Most of it is its mesh.
    const small = capture('corner', 1);
    const shares = phoneShares([small, splats('garden', 3_000_000)]);
    const size = sizeOfCapture(small, shares.get(small));
    expect(size).toMatchObject({ photoPx: [1600, 1200], wholeMesh: true });
    expect(shares.get(small)).toBeLessThan(30e6);
  });

  test('counts a file once that two assets name, and twice if it is loaded twice', () => {
    const [room, same] = [capture('room', 40), capture('room', 40)];
    expect([...phoneShares([room, same]).values()]).toEqual([128e6, 128e6]);
    const withMeshes: Place = { ...same, asset: { ...same.asset, depthMeshes: true } };
    expect([...phoneShares([room, withMeshes]).values()]).toEqual([64e6, 64e6]);
  });

  test('is not given to other assets', () => {
    const model: Place = { asset: { id: 'robot', kind: 'model', path: 'robot.glb' }, capture: null };
    const room = capture('room', 40);
    expect([...phoneShares([model, room])]).toEqual([[room, 128e6]]);
  });
});
