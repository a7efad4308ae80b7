import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'input/toggle',
  version: 1,
  title: 'Switch on screen',
  doc: 'Puts a switch on the visitor’s screen and gives whether it is on. In the editor, the inspector is the switch.',
  keywords: ['input', 'control', 'ui', 'checkbox', 'toggle', 'on', 'off', 'boolean', 'visitor', 'interactive'],
  inputs: {},
  outputs: { on: { type: 'toggle', label: 'On', doc: 'Whether the switch is on.' } },
  params: {
    value: { type: 'toggle', stage: 'uniform', label: 'On', doc: 'Whether it is on at first. Wired, no switch is shown.', default: false },
    label: { type: 'text', stage: 'structure', label: 'Label', doc: 'What is written at the switch.', default: 'On' },
    place: {
      type: 'number',
      stage: 'structure',
      label: 'Place',
      doc: 'Where it stands among the controls: those with smaller numbers come first.',
      default: 0,
      step: 1,
    },
  },
  lowering: { kind: 'value' },
  control: 'toggle',
});
