import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'input/slider',
  version: 1,
  title: 'Slider',
  doc: 'Puts a slider on the visitor’s screen and gives the number that it is set to. In the editor, the inspector is the slider.',
  keywords: ['input', 'control', 'ui', 'fader', 'range', 'knob', 'number', 'visitor', 'interactive'],
  inputs: {},
  outputs: { number: { type: 'number', label: 'Number', doc: 'What the slider is set to, never beyond its ends.' } },
  params: {
    value: {
      type: 'number',
      stage: 'uniform',
      label: 'Value',
      doc: 'Where the slider stands at first. If connected, no slider is shown.',
      default: 0.5,
    },
    label: { type: 'text', stage: 'structure', label: 'Label', doc: 'Text beside the slider.', default: 'Amount' },
    place: {
      type: 'number',
      stage: 'structure',
      label: 'Order',
      doc: 'Order among the controls, lowest first.',
      default: 0,
      step: 1,
    },
    min: { type: 'number', stage: 'structure', label: 'Minimum', doc: 'The number at the left end.', default: 0 },
    max: { type: 'number', stage: 'structure', label: 'Maximum', doc: 'The number at the right end.', default: 1 },
    step: {
      type: 'number',
      stage: 'structure',
      label: 'Step',
      doc: 'The slider stops at multiples of this, counted from the left end. 0 lets it stop anywhere.',
      default: 0.01,
      min: 0,
    },
  },
  lowering: { kind: 'value' },
  control: 'slider',
});
