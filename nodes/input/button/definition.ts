import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'input/button',
  version: 1,
  title: 'Button',
  doc: 'Puts a button on the visitor’s screen and gives a pulse for each press. In the editor, every step up of “Presses” in the inspector is a press.',
  keywords: ['input', 'control', 'ui', 'press', 'click', 'trigger', 'bang', 'visitor', 'interactive'],
  inputs: {},
  outputs: {
    pressed: { type: 'pulse', label: 'Pressed', doc: 'One pulse per press. Its number says which press it is, from 1.' },
  },
  params: {
    presses: {
      type: 'number',
      stage: 'uniform',
      label: 'Presses',
      doc: 'Counts the presses: each step up is one. If connected, no button is shown and the wire presses it.',
      default: 0,
      min: 0,
      step: 1,
    },
    label: { type: 'text', stage: 'structure', label: 'Label', doc: 'Text on the button.', default: 'Press' },
    place: {
      type: 'number',
      stage: 'structure',
      label: 'Order',
      doc: 'Order among the controls, lowest first.',
      default: 0,
      step: 1,
    },
  },
  lowering: { kind: 'value' },
  stateful: { moves: ['presses'] },
  control: 'button',
});
