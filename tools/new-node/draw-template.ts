import type { Template } from './template.ts';

/** Template of a node that draws objects into a layer with three.js. */
export const DRAW_TEMPLATE: Template = {
  definition: (type, title) => ({
    type,
    version: 1,
    title,
    doc: 'Draws objects as a layer.',
    keywords: ['render'],
    inputs: {
      objects: { type: 'objects', label: 'Objects', doc: 'The objects to draw.', required: true, multiple: true },
      lights: {
        type: 'lights',
        label: 'Lights',
        doc: 'Lights of the objects. Not connected: the objects are black.',
        required: false,
        multiple: true,
      },
    },
    outputs: { layer: { type: 'layer', label: 'Layer', doc: 'The drawn objects.', domain: 'view', depth: true } },
    params: {},
    lowering: { kind: 'geometry' },
  }),
  files: (type, name) => ({
    'runtime.ts': `import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const scene = ctx.scenes.createScene({ kind: 'shaded' });
  return {
    update: () => scene.update(ctx.inputs.objects, ctx.inputs.lights),
    draw: (view) => scene.draw(view),
    dispose: () => scene.dispose(),
  };
}
`,
    [`${name}.test.ts`]: `import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { DrawnScene, DrawView } from '../../kit/runtime.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

test('${type} draws its objects with its lights, and disposes its scene', () => {
  const objects = [{ version: 0, items: [] }];
  const lights = [{ version: 0, items: [] }];
  const view = { viewIndex: 1 } as DrawView;
  const calls: unknown[] = [];
  const scene: DrawnScene = {
    update: (...lists) => calls.push(lists),
    draw: (drawn) => calls.push(drawn),
    dispose: () => calls.push('disposed'),
  };
  const { ctx } = fakeContext(definition, { inputs: { objects, lights }, services: { scenes: { createScene: () => scene } } });
  const node = create(ctx);
  node.update({} as never);
  node.draw?.(view);
  node.dispose();
  expect(calls).toEqual([[objects, lights], view, 'disposed']);
});
`,
  }),
};
