import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'world/depth',
  version: 1,
  title: 'Room depth',
  doc: 'How far away the real room is, as the device measures it for each view. Wire it to whatever has to know what stands before what.',
  keywords: ['depth', 'sensor', 'lidar', 'distance', 'real', 'occlusion'],
  inputs: {},
  outputs: { depth: { type: 'depth', label: 'Depth', doc: 'Metres along the view axis; unknown where the device does not know.' } },
  params: {},
  lowering: { kind: 'source' },
  needs: [
    {
      capability: 'depth',
      required: false,
      when: 'always',
      why: 'to hide virtual things behind real ones',
      without: 'Virtual things are never hidden behind real ones.',
    },
  ],
});
