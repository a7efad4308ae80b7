import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { AssetService } from '../../kit/assets.ts';
import { PHOTO_MISSING, PHOTO_REDUCED, PHOTO_WHOLE } from '../../kit/capture-asset.ts';
import { createNearestViews } from '../../kit/capture-drawing/nearest-views.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

/** Four cameras on a line; the last looks the opposite way. */
function fourCameras(loaded = [PHOTO_WHOLE, PHOTO_WHOLE, PHOTO_WHOLE, PHOTO_WHOLE]) {
  return {
    positions: Float32Array.of(3, 0, 0, 1, 0, 0, 2, 0, 0, 0, 0, 0),
    directions: Float32Array.of(0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, 1),
    loaded: Uint8Array.from(loaded),
    radiusM: 5,
    wantedView: 7,
  };
}

test('chooses the views that are near and look the same way, the nearest first', () => {
  const capture = fourCameras();
  const nearest = createNearestViews(capture, 3);
  nearest.choose([0, 0, 0], [0, 0, -1]);
  // The last camera stands at the eye, but looks the opposite way: as much as 5 m.
  expect([...nearest.views]).toEqual([1, 2, 0]);
  expect(capture.wantedView).toBe(-1);
  nearest.choose([0, 0, 0], [0, 0, 1]);
  expect(nearest.views[0]).toBe(3);
  const all = createNearestViews(capture, 16);
  all.choose([0, 0, 0], [0, 0, 1]);
  expect(all.count).toBe(4);
  // A view that is left out does not take the place of another.
  nearest.choose([0, 0, 0], [0, 0, -1], 1);
  expect([...nearest.views]).toEqual([2, 0, 3]);
});

test('chooses among the photographs that are there, and asks for the nearest that is not', () => {
  const capture = fourCameras([PHOTO_WHOLE, PHOTO_MISSING, PHOTO_REDUCED, PHOTO_MISSING]);
  const nearest = createNearestViews(capture, 3);
  nearest.choose([0, 0, 0], [0, 0, -1]);
  expect([...nearest.views.subarray(0, nearest.count)]).toEqual([2, 0]);
  expect(capture.wantedView).toBe(1);
  capture.loaded.set([PHOTO_REDUCED], 1);
  nearest.choose([0, 0, 0], [0, 0, -1]);
  expect([...nearest.views]).toEqual([1, 2, 0]);
  // A photograph that is missing comes before a nearer one that is only reduced.
  expect(capture.wantedView).toBe(3);
  capture.loaded.set([PHOTO_WHOLE], 3);
  nearest.choose([0, 0, 0], [0, 0, -1]);
  expect(capture.wantedView).toBe(1);
});

/** What it looks like is proved on pixels, in `tests/slow/capture.test.ts`. */
test('draws nothing until the capture has loaded, and releases it', () => {
  const log: string[] = [];
  const handle = { kind: 'capture', value: null, settled: Promise.resolve(), release: () => log.push('released') } as const;
  const assets = {
    capture: (id: string) => {
      log.push(id);
      return handle;
    },
  } as Partial<AssetService> as AssetService;
  const { ctx } = fakeContext(definition, { params: { file: 'room' }, services: { assets, gl: {} as never } });
  const node = create(ctx);
  node.update({} as never);
  node.draw?.({ view: {} } as never);
  node.dispose();
  expect(log).toEqual(['room', 'released']);
});
