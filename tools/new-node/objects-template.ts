import type { Template } from './template.ts';

/** Template of a node with objects as input and output. */
export const OBJECTS_TEMPLATE: Template = {
  definition: (type, title) => ({
    type,
    version: 1,
    title,
    doc: 'Lifts objects off the floor.',
    keywords: ['raise', 'height'],
    inputs: { objects: { type: 'objects', label: 'Objects', doc: 'The objects to lift.', required: true } },
    outputs: { objects: { type: 'objects', label: 'Objects', doc: 'The lifted objects.' } },
    params: {
      heightM: {
        type: 'number',
        stage: 'uniform',
        label: 'Height',
        doc: 'Distance to move the objects up.',
        default: 0.5,
        min: -10,
        max: 10,
        unit: 'm',
      },
    },
    lowering: { kind: 'geometry' },
  }),
  files: (type, name) => ({
    'runtime.ts': `import { deriveObjects } from '../../kit/derive-objects.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { objects } = ctx.inputs;
  const inputs = objects ? [objects] : [];
  const derived = deriveObjects(ctx.outputs.objects, ({ worldFromObject }) => {
    // Column-major: element 13 is the translation along y.
    worldFromObject.elements[13] += ctx.params.heightM.value;
  });
  return { update: () => derived.update(inputs), dispose: () => {} };
}
`,
    [`${name}.test.ts`]: `import { expect, test } from '@jest/globals';
import { Matrix4, Object3D, Vector3 } from 'three';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { ObjectItem } from '../../kit/scene-lists.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function item(key: string, positionM: Vector3): ObjectItem {
  const worldFromObject = new Matrix4().setPosition(positionM);
  return { key, root: new Object3D(), worldFromObject, role: 'virtual', castsShadow: true, receivesShadow: true };
}

test('${type} lifts every object and does not change its input', () => {
  const objects = { version: 0, items: [item('a', new Vector3(1, 2, 3))] };
  const { ctx } = fakeContext(definition, { inputs: { objects }, params: { heightM: 0.25 } });
  const node = create(ctx);
  node.update({} as never);
  const [lifted] = ctx.outputs.objects.items;
  expect(new Vector3().setFromMatrixPosition(lifted?.worldFromObject ?? new Matrix4()).toArray()).toEqual([1, 2.25, 3]);
  expect(new Vector3().setFromMatrixPosition(objects.items[0]?.worldFromObject ?? new Matrix4()).y).toBe(2);
  node.dispose();
});

test('${type} follows changes of the input list', () => {
  const objects = { version: 0, items: [item('a', new Vector3())] };
  const { ctx } = fakeContext(definition, { inputs: { objects } });
  const node = create(ctx);
  node.update({} as never);
  const { version } = ctx.outputs.objects;
  objects.items.push(item('b', new Vector3()));
  objects.version++;
  node.update({} as never);
  expect(ctx.outputs.objects.items).toHaveLength(2);
  expect(ctx.outputs.objects.version).toBeGreaterThan(version);
});
`,
  }),
};
