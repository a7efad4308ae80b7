import type { Template } from './template.ts';

/** Objects in, objects out. */
export const OBJECTS_TEMPLATE: Template = {
  definition: (type, title) => ({
    type,
    version: 1,
    title,
    doc: 'Lifts objects off the floor.',
    keywords: ['raise', 'height'],
    inputs: { objects: { type: 'objects', label: 'Objects', doc: 'What to lift.', required: true } },
    outputs: { objects: { type: 'objects', label: 'Objects', doc: 'The same objects, higher.' } },
    params: {
      heightM: { type: 'number', stage: 'uniform', label: 'Height', doc: 'How far up.', default: 0.5, min: -10, max: 10, unit: 'm' },
    },
    lowering: { kind: 'geometry' },
  }),
  runtime: `import { Matrix4 } from 'three';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { ObjectItem, ObjectList } from '../../kit/scene-lists.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const output = ctx.outputs.objects;
  let source: ObjectList | null = null;
  let sourceVersion = -1;

  /** Only when the source's list has changed: a list of one's own, sharing the subtrees. */
  function rebuild(from: ObjectList): void {
    output.items.splice(0, output.items.length, ...from.items.map((item): ObjectItem => ({ ...item, worldFromObject: new Matrix4() })));
    output.version++;
    source = from;
    sourceVersion = from.version;
  }

  return {
    update: () => {
      const input = ctx.inputs.objects;
      if (!input) return;
      if (input !== source || input.version !== sourceVersion) rebuild(input);
      for (let i = 0; i < output.items.length; i++) {
        const from = input.items[i];
        const to = output.items[i];
        if (!from || !to) continue;
        to.worldFromObject.copy(from.worldFromObject);
        // Column-major: element 13 is the translation along y.
        to.worldFromObject.elements[13] = from.worldFromObject.elements[13] + ctx.params.heightM.value;
      }
    },
    dispose: () => {},
  };
}
`,
  test: (type) => `import { expect, test } from '@jest/globals';
import { Matrix4, Object3D, Vector3 } from 'three';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { ObjectItem } from '../../kit/scene-lists.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function item(key: string, positionM: Vector3): ObjectItem {
  const worldFromObject = new Matrix4().setPosition(positionM);
  return { key, root: new Object3D(), worldFromObject, role: 'virtual', castsShadow: true, receivesShadow: true };
}

test('${type} lifts every object and leaves its source alone', () => {
  const objects = { version: 0, items: [item('a', new Vector3(1, 2, 3))] };
  const { ctx } = fakeContext(definition, { inputs: { objects }, params: { heightM: 0.25 } });
  const node = create(ctx);
  node.update({} as never);
  const [lifted] = ctx.outputs.objects.items;
  expect(new Vector3().setFromMatrixPosition(lifted?.worldFromObject ?? new Matrix4()).toArray()).toEqual([1, 2.25, 3]);
  expect(new Vector3().setFromMatrixPosition(objects.items[0]?.worldFromObject ?? new Matrix4()).y).toBe(2);
  node.dispose();
});

test('${type} takes over a changed list', () => {
  const objects = { version: 0, items: [item('a', new Vector3())] };
  const { ctx } = fakeContext(definition, { inputs: { objects } });
  const node = create(ctx);
  node.update({} as never);
  const { version } = ctx.outputs.objects;
  objects.items.push(item('b', new Vector3()));
  objects.version++;
  node.update({} as never);
  expect(ctx.outputs.objects.items.map(({ key }) => key)).toEqual(['a', 'b']);
  expect(ctx.outputs.objects.version).toBeGreaterThan(version);
});
`,
};
