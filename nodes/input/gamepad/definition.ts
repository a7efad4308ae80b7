import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'input/gamepad',
  version: 1,
  title: 'Gamepad',
  doc: 'Gives the stick, the trigger and the buttons of a headset’s controller, or of one half of a gamepad.',
  keywords: ['controller', 'joystick', 'thumbstick', 'stick', 'trigger', 'button', 'vr', 'xbox', 'quest', 'interactive'],
  inputs: {},
  outputs: {
    x: { type: 'number', label: 'X', doc: 'The stick, from −1 left to 1 right.' },
    y: { type: 'number', label: 'Y', doc: 'The stick, from −1 down to 1 up.' },
    trigger: { type: 'number', label: 'Trigger', doc: 'From 0 to 1, pulled.' },
    squeeze: { type: 'number', label: 'Squeeze', doc: 'The grip, or the shoulder button, from 0 to 1.' },
    pulled: {
      type: 'pulse',
      label: 'Pulled',
      doc: 'When the trigger is pulled past the middle. Its pose is where the controller points, if that is known.',
    },
    primary: { type: 'pulse', label: 'Lower button', doc: 'When it is pressed: A on the right, X on the left.' },
    secondary: { type: 'pulse', label: 'Upper button', doc: 'When it is pressed: B on the right, Y on the left.' },
    connected: {
      type: 'toggle',
      label: 'Connected',
      doc: 'Whether there is one. Browsers tell of a gamepad when a button of it was pressed.',
    },
  },
  params: {
    hand: {
      type: 'choice',
      stage: 'structure',
      label: 'Hand',
      doc: 'Which controller, or which half of a gamepad. Of either, the stick that is pushed further counts.',
      default: 'either',
      options: [
        { value: 'either', label: 'Either' },
        { value: 'left', label: 'Left' },
        { value: 'right', label: 'Right' },
      ],
    },
    deadZone: {
      type: 'number',
      stage: 'uniform',
      label: 'Dead zone',
      doc: 'How far the stick may stray from its middle without counting.',
      default: 0.15,
      min: 0,
      max: 0.9,
      step: 0.01,
      unit: 'ratio',
    },
  },
  lowering: { kind: 'value' },
  stateful: true,
});
