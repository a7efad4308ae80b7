import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'layer/previous-frame',
  version: 1,
  title: 'Feedback',
  doc: 'Outputs the layer of the previous frame; nothing in the first frame. Wired in a loop, so that what it gives becomes a part of what it takes, it makes trails, echoes and tunnels: moved, blurred, faded or colored a little, frame after frame. Layers keep 8 bits, so what fades by a share of itself leaves a faint rest; filters that subtract or threshold take that away.',
  keywords: ['previous frame', 'delay', 'history', 'trail', 'echo', 'loop', 'motion blur', 'memory'],
  inputs: {
    layer: {
      type: 'layer',
      label: 'Layer',
      doc: 'What to give in the next frame. A picture of its own size is laid over the whole view.',
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
