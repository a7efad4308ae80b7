import type { Template } from './template.ts';

/** Template of a node that outputs what the session detects in the real room. */
export const WORLD_TEMPLATE: Template = {
  definition: (type, title) => ({
    type,
    version: 1,
    title,
    doc: 'Outputs the height of the lowest horizontal plane that the device has detected, such as the floor.',
    keywords: ['floor', 'plane detection'],
    inputs: {},
    outputs: { height: { type: 'number', label: 'Height', doc: 'Height in world space, in meters; 0 until a plane is detected.' } },
    params: {
      offsetM: { type: 'number', stage: 'uniform', label: 'Offset', doc: 'Added to the height.', default: 0, min: -10, max: 10, unit: 'm' },
    },
    lowering: { kind: 'source' },
    needs: [
      {
        capability: 'planes',
        required: false,
        when: 'always',
        why: 'to find the height of the floor',
        without: 'The height is the offset.',
      },
    ],
  }),
  files: (type, name) => ({
    'runtime.ts': `import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { DetectedPlane } from '../../kit/session.ts';
import type { definition } from './definition.ts';

/** Made once: a frame allocates nothing. */
const NOTHING: readonly DetectedPlane[] = [];

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  return {
    update: ({ surfaces }) => {
      const planes = surfaces?.planes ?? NOTHING;
      let lowestM = Number.POSITIVE_INFINITY;
      for (let i = 0; i < planes.length; i++) {
        const plane = planes[i];
        // Column-major: element 13 is the translation along y.
        if (plane?.orientation === 'horizontal') lowestM = Math.min(lowestM, plane.worldFromSurface[13] ?? 0);
      }
      ctx.outputs.height.value = (Number.isFinite(lowestM) ? lowestM : 0) + ctx.params.offsetM.value;
    },
    dispose: () => {},
  };
}
`,
    [`${name}.test.ts`]: `import { expect, test } from '@jest/globals';
import { Matrix4 } from 'three';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { DetectedPlane, SessionFrame } from '../../kit/session.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function plane(orientation: DetectedPlane['orientation'], heightM: number): DetectedPlane {
  const worldFromSurface = Float32Array.from(new Matrix4().setPosition(0, heightM, 0).elements);
  return { id: \`\${orientation} \${heightM}\`, version: 0, label: '', orientation, worldFromSurface, outlineXZ: new Float32Array() };
}

test('${type} outputs the height of the lowest horizontal plane', () => {
  const { ctx } = fakeContext(definition, { params: { offsetM: 0.25 } });
  const node = create(ctx);
  const see = (...planes: DetectedPlane[]): number => {
    node.update({ surfaces: { planes, meshes: [] } } as unknown as SessionFrame);
    return ctx.outputs.height.value;
  };
  expect(see()).toBe(0.25);
  expect(see(plane('horizontal', 0.75), plane('horizontal', -0.5), plane('vertical', -2))).toBe(-0.25);
});
`,
  }),
};
