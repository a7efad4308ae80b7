import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { LightList, ObjectList } from '../../kit/scene-lists.ts';
import type { SceneLook } from '../../kit/scene-look.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

/** What it looks like is proved on pixels, in `tests/browser/scenes-*.test.ts`. */
test('hands its wires and its live brightness to one scene, and frees it', () => {
  const objects: ObjectList[] = [{ version: 1, items: [] }];
  const lights: LightList[] = [{ version: 1, items: [] }];
  const seen: unknown[] = [];
  let look: SceneLook | null = null;
  const scenes = {
    createScene: (wanted: SceneLook) => {
      look = wanted;
      return {
        update: (...lists: unknown[]) => seen.push(lists),
        draw: () => seen.push('drawn'),
        dispose: () => seen.push('disposed'),
      };
    },
  };
  const { ctx, set } = fakeContext(definition, { inputs: { objects, lights }, services: { scenes } });
  const node = create(ctx);
  node.update({} as never);
  node.draw?.({} as never);
  node.dispose();
  expect(seen).toEqual([[objects, lights], 'drawn', 'disposed']);
  set('ambient', 2);
  expect(look).toMatchObject({ kind: 'shaded', ambient: { value: 2 } });
});
