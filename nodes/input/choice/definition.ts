import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'input/choice',
  version: 1,
  title: 'Choice',
  doc: 'Shows a list of options on the visitor’s screen and outputs the chosen one. Connect “Index” to a Switch node to choose between numbers, colors or vectors.',
  keywords: ['input', 'control', 'ui', 'menu', 'dropdown', 'select', 'list', 'radio', 'option', 'visitor', 'interactive'],
  inputs: {},
  outputs: {
    index: { type: 'number', label: 'Index', doc: 'Index of the chosen option; 0 is the first.' },
    word: { type: 'text', label: 'Word', doc: 'The chosen option as text.' },
  },
  params: {
    value: {
      type: 'number',
      stage: 'uniform',
      label: 'Chosen',
      doc: 'Index of the option that is chosen at the start; 0 is the first. If connected, no list is shown.',
      default: 0,
      min: 0,
      step: 1,
    },
    label: { type: 'text', stage: 'structure', label: 'Label', doc: 'Text beside the list.', default: 'Choose' },
    place: {
      type: 'number',
      stage: 'structure',
      label: 'Order',
      doc: 'Position among the controls on the page, lowest first.',
      default: 0,
      step: 1,
    },
    options: {
      type: 'text',
      stage: 'structure',
      label: 'Options',
      doc: 'The options to choose from, separated by commas.',
      default: 'One, Two, Three',
    },
  },
  lowering: { kind: 'value' },
  control: 'choice',
});
