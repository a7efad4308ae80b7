import type { Template } from './template.ts';

/** Template of a node that outputs a layer from outside the graph, here from a file. */
export const SOURCE_TEMPLATE: Template = {
  definition: (type, title) => ({
    type,
    version: 1,
    title,
    doc: 'Outputs one of two images from files, selected by a toggle.',
    keywords: ['picture', 'switch'],
    inputs: {},
    outputs: {
      layer: { type: 'layer', label: 'Layer', doc: 'The selected image; transparent until it has loaded.', domain: 'image', depth: false },
    },
    params: {
      off: {
        type: 'asset',
        stage: 'asset',
        label: 'Image when off',
        doc: 'The image file to show when the toggle is off.',
        default: '',
        accept: 'image',
      },
      on: {
        type: 'asset',
        stage: 'asset',
        label: 'Image when on',
        doc: 'The image file to show when the toggle is on.',
        default: '',
        accept: 'image',
      },
      isOn: { type: 'toggle', stage: 'uniform', label: 'On', doc: 'Which image to show.', default: false },
    },
    lowering: { kind: 'source' },
  }),
  files: (type, name) => ({
    'runtime.ts': `import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { off, on } = ctx.assetIds;
  // The asset service loads each file once; each handle is released in \`dispose\`.
  const imageOff = off === null ? null : ctx.assets.image(off);
  const imageOn = on === null ? null : ctx.assets.image(on);
  // A layer of the image domain has one entry for all views.
  const [view] = ctx.outputs.layer.views;
  return {
    update: () => {
      if (!view) return;
      const image = (ctx.params.isOn.value ? imageOn : imageOff)?.value ?? null;
      view.texture = image?.texture ?? null;
      view.widthPx = image?.widthPx ?? 0;
      view.heightPx = image?.heightPx ?? 0;
    },
    dispose: () => {
      imageOff?.release();
      imageOn?.release();
    },
  };
}
`,
    [`${name}.test.ts`]: `import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { AssetService } from '../../kit/assets.ts';
import type { LayerTexture } from '../../kit/runtime.ts';
import type { Writable } from '../../kit/value-views.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

test('${type} outputs the selected image, and releases both', () => {
  const released: string[] = [];
  const image = (id: string) => ({
    kind: 'image',
    value: { texture: {} as WebGLTexture, widthPx: id === 'day' ? 2 : 4, heightPx: 1 },
    settled: Promise.resolve(),
    release: () => released.push(id),
  });
  const { ctx, set } = fakeContext(definition, {
    params: { off: 'day', on: 'night' },
    services: { assets: { image } as Partial<AssetService> as AssetService },
  });
  const view: Writable<LayerTexture> = { texture: null, widthPx: 0, heightPx: 0, uvFromViewUv: new Float32Array(9) };
  (ctx.outputs.layer.views as Writable<LayerTexture>[]).push(view);
  const node = create(ctx);
  node.update({} as never);
  expect(view.widthPx).toBe(2);
  set('isOn', true);
  node.update({} as never);
  expect(view.widthPx).toBe(4);
  node.dispose();
  expect(released).toEqual(['day', 'night']);
});
`,
  }),
};
