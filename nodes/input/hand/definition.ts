import { defineNode } from '../../kit/definition.ts';
import { HAND_JOINTS, type HandJoint } from '../../kit/hand-joints.ts';

const FINGERS: Readonly<Record<string, string>> = {
  wrist: 'Wrist',
  thumb: 'Thumb',
  index: 'Index finger',
  middle: 'Middle finger',
  ring: 'Ring finger',
  pinky: 'Little finger',
};

/** Plain labels for the parts of WebXR's joint names, for users who do not know anatomy. */
const PARTS: Readonly<Record<string, string>> = {
  metacarpal: 'base',
  'phalanx-proximal': 'knuckle',
  'phalanx-intermediate': 'middle joint',
  'phalanx-distal': 'last joint',
  tip: 'tip',
};

function labelOf(joint: HandJoint): string {
  const finger = FINGERS[joint.split('-')[0] ?? ''] ?? joint;
  const part = Object.keys(PARTS).find((end) => joint.endsWith(end));
  return part === undefined ? finger : `${finger}: ${PARTS[part]}`;
}

export const definition = defineNode({
  type: 'input/hand',
  version: 1,
  title: 'Hand',
  doc: 'Gives the joints of a bare hand, and how far it pinches or grabs. Headsets track hands; elsewhere, and while the hand holds a controller, the poses are invalid and the numbers 0.',
  keywords: ['finger', 'fist', 'gesture', 'grab', 'hand tracking', 'joint', 'palm', 'pinch', 'quest', 'vision', 'wrist'],
  inputs: {},
  outputs: {
    joint: {
      type: 'pose',
      label: 'Joint',
      doc: 'The chosen joint: −z points along the bone to the fingertip, y out of the back of the hand.',
    },
    palm: { type: 'pose', label: 'Palm', doc: 'The middle of the palm: −z points to the fingers, −y out of the palm.' },
    pinch: {
      type: 'number',
      label: 'Pinch',
      doc: 'How far thumb and index finger are closed: 0 from 6 cm between their tips on, 1 up to 1 cm.',
    },
    grab: {
      type: 'number',
      label: 'Grab',
      doc: 'How far the hand is closed to a fist, from 0 (relaxed) to 1, by the finger that is bent least. Pointing is no grab.',
    },
    pinched: {
      type: 'pulse',
      label: 'Pinched',
      doc: 'A pulse when thumb and index finger touch. It carries the pose between their tips.',
    },
    released: {
      type: 'pulse',
      label: 'Released',
      doc: 'A pulse when the pinch opens, with its pose. The number is 1, or 0 if tracking was lost in the pinch; the pose is then the last one.',
    },
    tracked: { type: 'toggle', label: 'Is tracked', doc: 'On while the device tracks the hand.' },
  },
  params: {
    side: {
      type: 'choice',
      stage: 'structure',
      label: 'Side',
      doc: 'Which hand.',
      default: 'right',
      options: [
        { value: 'left', label: 'Left' },
        { value: 'right', label: 'Right' },
      ],
    },
    joint: {
      type: 'choice',
      stage: 'structure',
      label: 'Joint',
      doc: 'The joint that “Joint” outputs. The joints are those of WebXR Hand Input.',
      default: 'index-finger-tip',
      options: HAND_JOINTS.map((value) => ({ value, label: labelOf(value) })),
    },
  },
  readsInput: true,
  lowering: { kind: 'value' },
  stateful: true,
  needs: [
    {
      capability: 'hands',
      required: false,
      when: 'always',
      why: 'to follow your hands',
      without: 'Bare hands are not followed: nothing happens at their joints, pinches and grabs.',
    },
  ],
});
