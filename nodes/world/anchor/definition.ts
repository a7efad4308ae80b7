import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'world/anchor',
  version: 1,
  title: 'Anchor',
  doc: 'Keeps a pose at its point of the real room: it follows the room while tracking drifts or the visitor re-centers, and stays while tracking is lost. Where the device has no anchors, the pose stays in world space, and State says “unsupported”. With “Keep over visits”, devices that support it find the anchor again at later visits.',
  keywords: ['pin', 'fix', 'hold', 'room', 'tracking', 'drift', 'world lock', 'persistent'],
  inputs: {
    pose: {
      type: 'pose',
      label: 'Pose',
      doc: 'The pose to anchor. If it is not connected, each pulse at “Set” anchors the pose that the pulse carries.',
      required: false,
    },
    set: {
      type: 'pulse',
      label: 'Set',
      doc: 'A pulse replaces the anchor by one at the pose as it is then. Without a valid pose nothing changes. Optional.',
      required: false,
      multiple: true,
    },
    clear: {
      type: 'pulse',
      label: 'Clear',
      doc: 'A pulse removes the anchor, also for later visits; a Button lets the visitor do so. Applied first in a frame. Optional.',
      required: false,
      multiple: true,
    },
  },
  outputs: {
    pose: { type: 'pose', label: 'Pose', doc: 'The anchored pose. Invalid while there is no anchor.' },
    state: {
      type: 'text',
      label: 'State',
      doc: 'Empty without an anchor; “pending” until the device has confirmed it; “tracked”; “lost” while the device does not see it, and the pose stays; “deleted” after the device has removed it, and the pose stays in world space; “unsupported” where the device has no anchors, and the pose stays in world space.',
    },
    tracked: { type: 'toggle', label: 'Is tracked', doc: 'On while the device tracks the anchor.' },
    kept: { type: 'toggle', label: 'Kept', doc: 'On while the device keeps the anchor for later visits.' },
  },
  params: {
    when: {
      type: 'choice',
      stage: 'structure',
      label: 'Make anchor',
      doc: 'When an anchor is made. Pulses at “Set” always make one.',
      default: 'valid',
      options: [
        { value: 'valid', label: 'When the pose becomes valid' },
        { value: 'set', label: 'At a pulse only' },
      ],
    },
    keep: {
      type: 'toggle',
      stage: 'structure',
      label: 'Keep over visits',
      doc: 'Whether the device keeps the anchor for later visits of the page. The anchor is then there without a new pose, once the device finds its place. Devices limit how many they keep: a Quest keeps 8, and forgets the oldest for a ninth.',
      default: false,
    },
  },
  lowering: { kind: 'value' },
  stateful: true,
  needs: [
    {
      capability: 'anchors',
      required: false,
      when: 'always',
      why: 'to keep placed things at their point of the room',
      without: 'Placed things may drift from their point of the room, and move with the visitor’s re-centering.',
    },
  ],
});
