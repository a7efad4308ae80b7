import type { Template } from './template.ts';

/** Template of a node that outputs a light for scenes. */
export const LIGHT_TEMPLATE: Template = {
  definition: (type, title) => ({
    type,
    version: 1,
    title,
    doc: 'A point light that flickers, as a candle does.',
    keywords: ['candle', 'fire'],
    inputs: {},
    outputs: { lights: { type: 'lights', label: 'Light', doc: 'The light, for Scene nodes.' } },
    params: {
      color: { type: 'color', stage: 'uniform', label: 'Color', doc: 'Color of the light.', default: [1, 0.8, 0.5, 1] },
      intensityCd: {
        type: 'number',
        stage: 'uniform',
        label: 'Intensity',
        doc: 'Mean brightness, in candela.',
        default: 3,
        min: 0,
        max: 100,
        unit: 'cd',
      },
      flicker: {
        type: 'number',
        stage: 'uniform',
        label: 'Flicker',
        doc: 'Largest change of the brightness, as a fraction of it.',
        default: 0.2,
        min: 0,
        max: 1,
        unit: 'ratio',
      },
      positionM: {
        type: 'vector3',
        stage: 'uniform',
        handle: 'position',
        label: 'Position',
        doc: 'Position of the light in world space, in meters.',
        default: [0, 1.5, 0],
        unit: 'm',
      },
    },
    lowering: { kind: 'geometry' },
  }),
  files: (type, name) => ({
    'runtime.ts': `import { Color } from 'three';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { PointLightItem } from '../../kit/scene-lists.ts';
import type { definition } from './definition.ts';

const FLICKER_RAD_PER_S = 40;

// Read in the call that fills it.
const scratchColor = new Color();

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { color, intensityCd, flicker, positionM } = ctx.params;
  const light: PointLightItem = {
    key: 'light',
    kind: 'point',
    intensityCd: new Float32Array(3),
    positionWorld: new Float32Array(3),
    rangeM: 0,
    shadow: null,
  };
  ctx.outputs.lights.items.push(light);
  // Readers rebuild what they derive from the list when its version changes; they read the values every frame.
  ctx.outputs.lights.version++;
  return {
    update: () => {
      const factor = 1 + flicker.value * Math.sin(ctx.clock.timeS * FLICKER_RAD_PER_S);
      // Params hold display-referred sRGB; lighting is linear-sRGB.
      scratchColor.fromArray(color.value).convertSRGBToLinear();
      scratchColor.multiplyScalar(intensityCd.value * factor).toArray(light.intensityCd);
      light.positionWorld.set(positionM.value);
    },
    dispose: () => {},
  };
}
`,
    [`${name}.test.ts`]: `import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { PointLightItem } from '../../kit/scene-lists.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

test('${type} outputs one light that flickers around its intensity', () => {
  const { ctx, tick } = fakeContext(definition, { params: { color: [1, 0, 0, 1], intensityCd: 2, positionM: [1, 2, 3] } });
  const node = create(ctx);
  const light = ctx.outputs.lights.items[0] as PointLightItem;
  node.update({} as never);
  expect(ctx.outputs.lights.version).toBeGreaterThan(0);
  expect([...light.intensityCd]).toEqual([2, 0, 0]);
  expect([...light.positionWorld]).toEqual([1, 2, 3]);
  // A quarter of a period: sin is 1.
  tick(Math.PI / 2 / 40);
  node.update({} as never);
  expect(light.intensityCd[0]).toBeCloseTo(2.4);
});
`,
  }),
};
