import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'layer/previous-frame',
  version: 1,
  title: 'Feedback',
  doc: 'Outputs the layer of the previous frame; in the first frame it is transparent. Connect it in a loop, with a filter that moves, blurs or fades it a little each frame, to make trails, echoes and tunnels. Layers have 8 bits per channel, so an image that fades by a factor leaves a faint residue; a filter that subtracts or thresholds removes it.',
  keywords: ['previous frame', 'delay', 'history', 'trail', 'echo', 'loop', 'motion blur', 'memory'],
  inputs: {
    layer: {
      type: 'layer',
      label: 'Layer',
      doc: 'The layer to output in the next frame. An image of another size is scaled to cover the view.',
      required: true,
    },
  },
  outputs: {
    layer: { type: 'layer', label: 'Layer', doc: 'The layer of the previous frame, one per eye.', domain: 'view', depth: false },
  },
  params: {},
  lowering: { kind: 'image', shader: 'layer/previous-frame/keep.fs', access: 'persistent' },
  delay: true,
});
