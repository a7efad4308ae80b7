import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'input/button',
  version: 1,
  title: 'Button',
  doc: 'Shows a button on the visitor’s screen and outputs a pulse for each press. In the editor, raise “Presses” in the inspector to press it.',
  keywords: ['input', 'control', 'ui', 'press', 'click', 'trigger', 'bang', 'visitor', 'interactive'],
  inputs: {},
  outputs: {
    pressed: { type: 'pulse', label: 'Pressed', doc: 'One pulse per press; its number counts the presses, from 1.' },
  },
  params: {
    presses: {
      type: 'number',
      stage: 'uniform',
      label: 'Presses',
      doc: 'The number of presses so far. If connected, no button is shown, and each increase of the input is a press.',
      default: 0,
      min: 0,
      step: 1,
    },
    label: { type: 'text', stage: 'structure', label: 'Label', doc: 'Text on the button.', default: 'Press' },
    place: {
      type: 'number',
      stage: 'structure',
      label: 'Order',
      doc: 'Position among the controls on the page, lowest first.',
      default: 0,
      step: 1,
    },
  },
  lowering: { kind: 'value' },
  stateful: { moves: ['presses'] },
  control: 'button',
});
