import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { AssetService } from '../../kit/assets.ts';
import { createNearestViews } from '../../kit/capture-drawing/nearest-views.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

test('chooses the views that are near and look the same way, the nearest first', () => {
  const positions = Float32Array.of(3, 0, 0, 1, 0, 0, 2, 0, 0, 0, 0, 0);
  const directions = Float32Array.of(0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, 1);
  const nearest = createNearestViews(positions, directions, 3);
  nearest.choose([0, 0, 0], [0, 0, -1], 5);
  // The last camera stands at the eye, but looks the opposite way: as much as 5 m.
  expect([...nearest.views]).toEqual([1, 2, 0]);
  nearest.choose([0, 0, 0], [0, 0, 1], 5);
  expect(nearest.views[0]).toBe(3);
  expect(createNearestViews(positions, directions, 16).count).toBe(4);
  // A view that is left out does not take the place of another.
  nearest.choose([0, 0, 0], [0, 0, -1], 5, 1);
  expect([...nearest.views]).toEqual([2, 0, 3]);
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
