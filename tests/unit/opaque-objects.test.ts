import { describe, expect, test } from '@jest/globals';
import { BoxGeometry, type Material, Matrix4, Mesh, MeshStandardMaterial } from 'three';
import { COLORED, KEEPING_MATERIALS } from '../../export/compiler/schedule/fuse/opaque-objects.ts';
import { isOpaque } from '../../export/runtime/scenes/materials/layer-blending.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import { subsetGlyphs } from '../../nodes/kit/glyphs.ts';
import type { NodeModule } from '../../nodes/kit/runtime.ts';
import type { ObjectList } from '../../nodes/kit/scene-lists.ts';
import { definitionOf } from '../support/fusion-kit.ts';
import { LIBRARY } from '../support/library.ts';
import { fakeContext } from '../support/node-context.ts';

/** What the compiler knows of the materials of objects before it sees them. */

/** The materials of the objects that a node outputs in its second frame. */
function materialsOf(type: string, params: object, inputs: object = {}): Material[] {
  const definition = definitionOf(type) as NodeDefinition;
  const { ctx, tick } = fakeContext(definition, { params, inputs } as never);
  const runtime = (RUNTIMES[type] as NodeModule).create(ctx as never);
  for (let i = 0; i < 2; i++) {
    runtime.update({ views: [], viewCount: 0 } as never);
    tick(1 / 30);
  }
  const found = new Set<Material>();
  for (const { root } of (ctx.outputs as unknown as { objects: ObjectList }).objects.items) {
    root.traverse((part) => {
      if (part instanceof Mesh) for (const material of [part.material].flat()) found.add(material);
    });
  }
  return [...found];
}

const characters = subsetGlyphs(LIBRARY.shader('fonts/inter') ?? '', 'A');

describe('node types that the compiler knows', () => {
  test.each(COLORED)('%s has one material, which is transparent if the alpha of its color is below 1', (type) => {
    const more = type === 'objects/text-3d' ? { text: 'A', characters } : {};
    expect(materialsOf(type, { color: [0.2, 0.4, 0.6, 1], ...more }).map(isOpaque)).toEqual([true]);
    expect(materialsOf(type, { color: [0.2, 0.4, 0.6, 0.9], ...more }).map(isOpaque)).toEqual([false]);
  });

  test.each(KEEPING_MATERIALS)('%s hands objects on with their materials', (type) => {
    const material = new MeshStandardMaterial();
    const root = new Mesh(new BoxGeometry(), material);
    const item = { key: 'a', root, worldFromObject: new Matrix4(), role: 'virtual', castsShadow: true, receivesShadow: true };
    const pose = { valid: true, worldFromPose: new Float32Array(new Matrix4().elements), jumps: 0 };
    expect(materialsOf(type, {}, { objects: [{ version: 1, items: [item] }], ...(type === 'objects/at-pose' && { pose }) })).toEqual([
      material,
    ]);
  });
});
