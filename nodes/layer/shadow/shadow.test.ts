import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { LightList, ObjectList } from '../../kit/scene-lists.ts';
import type { SceneLook } from '../../kit/scene-look.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

/** What it looks like is proved on pixels, in `tests/browser/scenes-shadows.test.ts`. */
test('draws its phantoms, not its casters, and frees its scene', () => {
  const casters: ObjectList[] = [{ version: 1, items: [] }];
  const receivers: ObjectList[] = [{ version: 2, items: [] }];
  const lights: LightList[] = [{ version: 1, items: [] }];
  const seen: unknown[] = [];
  let look: SceneLook | null = null;
  const scenes = {
    createScene: (wanted: SceneLook) => {
      look = wanted;
      return { update: (...lists: unknown[]) => seen.push(lists), draw: () => seen.push('drawn'), dispose: () => seen.push('disposed') };
    },
  };
  const { ctx, set } = fakeContext(definition, { inputs: { casters, receivers, lights }, services: { scenes } });
  const node = create(ctx);
  node.update({} as never);
  node.draw?.({} as never);
  node.dispose();
  expect(seen).toEqual([[receivers, lights], 'drawn', 'disposed']);
  set('strength', 0.9);
  expect(look).toMatchObject({ kind: 'shadow-catcher', strength: { value: 0.9 } });
});

test('with room depth needs nothing else to fall on; with neither says so', () => {
  const depth = { views: [] };
  let look: SceneLook | null = null;
  const scenes = {
    createScene: (wanted: SceneLook) => {
      look = wanted;
      return { update: () => {}, draw: () => {}, dispose: () => {} };
    },
  };
  const without = fakeContext(definition, { inputs: { casters: [], receivers: [], lights: [] }, services: { scenes } });
  create(without.ctx).update({} as never);
  expect(without.reports).toEqual([expect.objectContaining({ code: 'SCR015', port: 'receivers' })]);
  expect(look).not.toHaveProperty('room');
  const within = fakeContext(definition, { inputs: { casters: [], receivers: [], lights: [], depth }, services: { scenes } });
  create(within.ctx).update({} as never);
  expect(within.reports).toEqual([]);
  const volumes = fakeContext(definition, {
    params: { method: 'volume' },
    inputs: { casters: [], receivers: [], lights: [], depth },
    services: { scenes },
  });
  create(volumes.ctx).update({} as never);
  expect(volumes.reports).toEqual([
    expect.objectContaining({ code: 'SCR015', port: 'receivers', fix: expect.stringContaining('Shadow map') }),
  ]);
  expect(look).toMatchObject({ room: { depth, toleranceM: { value: 0.05 } } });
});
