import { describe, expect, test } from '@jest/globals';
import { Matrix4, Object3D } from 'three';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { ObjectList } from '../../kit/scene-lists.ts';
import type { TechniqueView } from '../../kit/technique-view.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function technique(key: string): TechniqueView & { version: number } {
  return { version: 1, key, vertex: '', fragment: '', passes: [{ side: 'object' }], uniforms: [], images: [] };
}

function listOf(...keys: string[]): ObjectList {
  const items = keys.map((key) => ({
    key,
    root: new Object3D(),
    worldFromObject: new Matrix4(),
    role: 'virtual' as const,
    castsShadow: true,
    receivesShadow: true,
  }));
  return { version: 1, items };
}

/** What it looks like is proved on pixels, in `tests/browser/techniques.test.ts`. */
describe('objects/apply-technique', () => {
  test('sets the technique on its own items and does not change its inputs', () => {
    const source = listOf('a', 'b');
    const gooch = technique('gooch');
    const { ctx } = fakeContext(definition, { inputs: { objects: [source], technique: gooch }, params: { materials: ' Skin, Cloth ,' } });
    const node = create(ctx);
    node.update({} as never);
    expect(ctx.outputs.objects.items.map(({ techniques }) => techniques)).toEqual([
      [{ technique: gooch, materials: ['Skin', 'Cloth'] }],
      [{ technique: gooch, materials: ['Skin', 'Cloth'] }],
    ]);
    expect(source.items[0]?.techniques).toBeUndefined();
    const { version } = ctx.outputs.objects;
    node.update({} as never);
    expect(ctx.outputs.objects.version).toBe(version);
  });

  test('keeps earlier techniques, and applies to objects that are added later', () => {
    const toon = technique('toon');
    const source = listOf('a');
    const before = { technique: technique('gooch'), materials: null };
    if (source.items[0]) source.items[0].techniques = [before];
    const { ctx } = fakeContext(definition, { inputs: { objects: [source], technique: toon } });
    const node = create(ctx);
    node.update({} as never);
    expect(ctx.outputs.objects.items[0]?.techniques).toEqual([before, { technique: toon, materials: null }]);
    source.items.push(...listOf('b').items);
    source.version++;
    node.update({} as never);
    expect(ctx.outputs.objects.items.map(({ techniques }) => techniques?.length)).toEqual([2, 1]);
  });

  test('increases its version when the text of the technique changes', () => {
    const toon = technique('toon');
    const { ctx } = fakeContext(definition, { inputs: { objects: [listOf('a')], technique: toon } });
    const node = create(ctx);
    node.update({} as never);
    const { version, items } = ctx.outputs.objects;
    toon.version++;
    node.update({} as never);
    expect(ctx.outputs.objects.version).toBe(version + 1);
    expect(items[0]?.techniques).toHaveLength(1);
  });
});
