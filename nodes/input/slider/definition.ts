import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'input/slider',
  version: 1,
  title: 'Slider',
  doc: 'Shows a slider on the visitor’s screen and outputs its value. In the editor, set the value in the inspector.',
  keywords: ['input', 'control', 'ui', 'fader', 'range', 'knob', 'number', 'visitor', 'interactive'],
  inputs: {},
  outputs: { number: { type: 'number', label: 'Number', doc: 'The value of the slider, from “Minimum” to “Maximum”.' } },
  params: {
    value: {
      type: 'number',
      stage: 'uniform',
      label: 'Value',
      doc: 'Value of the slider at the start. If connected, no slider is shown.',
      default: 0.5,
    },
    label: { type: 'text', stage: 'structure', label: 'Label', doc: 'Text beside the slider.', default: 'Amount' },
    place: {
      type: 'number',
      stage: 'structure',
      label: 'Order',
      doc: 'Position among the controls on the page, lowest first.',
      default: 0,
      step: 1,
    },
    min: { type: 'number', stage: 'structure', label: 'Minimum', doc: 'Value at the left end.', default: 0 },
    max: { type: 'number', stage: 'structure', label: 'Maximum', doc: 'Value at the right end.', default: 1 },
    step: {
      type: 'number',
      stage: 'structure',
      label: 'Step',
      doc: 'Distance between two values of the slider, counted from “Minimum”. With 0 it is continuous.',
      default: 0.01,
      min: 0,
    },
  },
  lowering: { kind: 'value' },
  control: 'slider',
});
