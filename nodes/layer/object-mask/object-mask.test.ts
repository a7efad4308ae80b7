import { expect, test } from '@jest/globals';
import { Group, Matrix4, Mesh, type Object3D } from 'three';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { ObjectItem, ObjectList } from '../../kit/scene-lists.ts';
import type { SceneLook } from '../../kit/scene-look.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function listOf(root: Object3D): ObjectList & { readonly first: ObjectItem } {
  const first: ObjectItem = {
    key: 'a',
    root,
    worldFromObject: new Matrix4(),
    role: 'virtual',
    castsShadow: true,
    receivesShadow: true,
  };
  return { version: 1, items: [first], first };
}

function robot(): { root: Group; arm: Mesh; hand: Mesh } {
  const root = new Group();
  const arm = Object.assign(new Mesh(), { name: 'Arm' });
  const hand = Object.assign(new Mesh(), { name: 'Hand' });
  root.add(arm);
  arm.add(hand);
  return { root, arm, hand };
}

function run(names: string) {
  const { root, arm, hand } = robot();
  const objects = listOf(root);
  const hiders = listOf(robot().root);
  const looks: SceneLook[] = [];
  const seen: unknown[] = [];
  const scenes = {
    createScene: (look: SceneLook) => {
      looks.push(look);
      return { update: (...lists: unknown[]) => seen.push(lists), draw: () => seen.push('drawn'), dispose: () => seen.push('disposed') };
    },
  };
  const { ctx } = fakeContext(definition, { inputs: { objects: [objects], hiders: [hiders] }, params: { names }, services: { scenes } });
  const node = create(ctx);
  node.update({} as never);
  node.draw?.({} as never);
  node.dispose();
  const [look] = looks;
  if (look?.kind !== 'mask') throw new Error('A mask has a look of its own.');
  return { look, seen, objects, hiders, arm, hand };
}

/** What it looks like is proved on pixels, in `tests/browser/object-mask.test.ts`. */
test('draws objects and what hides them in one scene, shows its objects alone, and frees it', () => {
  const { look, seen, objects, hiders, arm } = run('');
  expect(seen).toEqual([[[objects, hiders], []], 'drawn', 'disposed']);
  expect(look.shows(objects.first, arm)).toBe(true);
  expect(look.shows(hiders.first, arm)).toBe(false);
});

test('shows the named parts with their children', () => {
  const named = (names: string) => {
    const { look, objects, arm, hand } = run(names);
    return [arm, hand].map((part) => look.shows(objects.first, part));
  };
  expect(named('Hand')).toEqual([false, true]);
  expect(named(' Head , Arm')).toEqual([true, true]);
  expect(named('Head')).toEqual([false, false]);
});
