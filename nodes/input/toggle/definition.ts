import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'input/toggle',
  version: 1,
  title: 'Toggle',
  doc: 'Shows a toggle on the visitor’s screen and outputs whether it is on. In the editor, set it in the inspector.',
  keywords: ['input', 'control', 'ui', 'checkbox', 'switch on screen', 'on', 'off', 'boolean', 'visitor', 'interactive'],
  inputs: {},
  outputs: { on: { type: 'toggle', label: 'On', doc: 'Whether the toggle is on.' } },
  params: {
    value: {
      type: 'toggle',
      stage: 'uniform',
      label: 'On',
      doc: 'Whether it is on at the start. If connected, no toggle is shown.',
      default: false,
    },
    label: { type: 'text', stage: 'structure', label: 'Label', doc: 'Text beside the toggle.', default: 'On' },
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
  control: 'toggle',
});
