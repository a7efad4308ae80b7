import { defineNode } from '../../kit/definition.ts';
import { ANY_OR_SCREEN, POINTERS_BY } from '../../kit/pointer-params.ts';

export const definition = defineNode({
  type: 'input/pointer',
  version: 1,
  title: 'Pointer',
  doc: 'Gives the ray of a finger, mouse, controller, hand or gaze as a pose, and tells when a press starts and ends. A pressed pointer comes before one that hovers; a followed press is followed to its end. On screens there is a ray only while a finger touches or the mouse is over the view.',
  keywords: ['touch', 'mouse', 'controller', 'hand', 'gaze', 'pinch', 'ray', 'press', 'drag', 'hover', 'input', 'cursor'],
  inputs: {},
  outputs: {
    pose: { type: 'pose', label: 'Pose', doc: 'The ray: it starts at the pose, along -z. Invalid while nothing points.' },
    grip: { type: 'pose', label: 'Grip', doc: 'Where the controller or hand holds something. Invalid for screens, mouse and gaze.' },
    pressed: { type: 'toggle', label: 'Is pressed', doc: 'On from the start of a press until it ends.' },
    pinch: {
      type: 'number',
      label: 'Pinch',
      doc: 'How far the pinch or trigger is closed, from 0 to 1. On screens it is 1 during a press.',
    },
    started: { type: 'pulse', label: 'Started', doc: 'A pulse when a press starts, with the ray as its pose.' },
    ended: {
      type: 'pulse',
      label: 'Ended',
      doc: 'A pulse when a press ends, with the ray as its pose. Its number is 1 for a tap, 0 for a drag, -1 if the system canceled the press.',
    },
  },
  params: {
    by: {
      ...POINTERS_BY,
      options: [
        ...ANY_OR_SCREEN,
        { value: 'left', label: 'Left controller or hand' },
        { value: 'right', label: 'Right controller or hand' },
      ],
    },
    claims: {
      type: 'toggle',
      stage: 'structure',
      label: 'Claim presses',
      doc: 'No other node gets the press, and a drag does not turn the view in a page without AR.',
      default: false,
    },
  },
  readsInput: true,
  lowering: { kind: 'value' },
  stateful: true,
});
