import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'input/gamepad',
  version: 1,
  title: 'Gamepad',
  doc: 'Outputs the thumbstick, trigger and buttons of a headset controller, or of one half of a gamepad.',
  keywords: ['controller', 'joystick', 'thumbstick', 'stick', 'trigger', 'button', 'vr', 'xbox', 'quest', 'interactive'],
  inputs: {},
  outputs: {
    x: { type: 'number', label: 'X', doc: 'Horizontal position of the thumbstick, from −1 (left) to 1 (right).' },
    y: { type: 'number', label: 'Y', doc: 'Vertical position of the thumbstick, from −1 (down) to 1 (up).' },
    trigger: { type: 'number', label: 'Trigger', doc: 'Trigger value, from 0 (released) to 1 (fully pulled).' },
    squeeze: { type: 'number', label: 'Squeeze', doc: 'Value of the grip or shoulder button, from 0 (released) to 1 (fully pressed).' },
    pulled: {
      type: 'pulse',
      label: 'Pulled',
      doc: 'A pulse when the trigger is pulled past the middle. It carries the pose of the controller’s pointing ray, if the pose is tracked.',
    },
    primary: { type: 'pulse', label: 'Lower button', doc: 'A pulse when the lower button is pressed: A on the right, X on the left.' },
    secondary: { type: 'pulse', label: 'Upper button', doc: 'A pulse when the upper button is pressed: B on the right, Y on the left.' },
    connected: {
      type: 'toggle',
      label: 'Connected',
      doc: 'Whether a controller is connected. Browsers report a gamepad only after one of its buttons is pressed.',
    },
  },
  params: {
    hand: {
      type: 'choice',
      stage: 'structure',
      label: 'Hand',
      doc: 'Which controller, or which half of a gamepad. With “Either”, the thumbstick that is pushed further counts.',
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
      doc: 'Thumbstick positions closer to the center than this are output as 0.',
      default: 0.15,
      min: 0,
      max: 0.9,
      step: 0.01,
      unit: 'ratio',
    },
  },
  readsInput: true,
  lowering: { kind: 'value' },
  stateful: true,
});
