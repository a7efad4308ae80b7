import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'input/choice',
  version: 1,
  title: 'Choice',
  doc: 'Lets the visitor choose one of several words on screen, and gives which it is. Connect its number to a Switch to choose between things.',
  keywords: ['input', 'control', 'ui', 'menu', 'dropdown', 'select', 'list', 'radio', 'option', 'visitor', 'interactive'],
  inputs: {},
  outputs: {
    index: { type: 'number', label: 'Index', doc: 'Which one is chosen: 0 is the first.' },
    word: { type: 'text', label: 'Word', doc: 'The chosen word.' },
  },
  params: {
    value: {
      type: 'number',
      stage: 'uniform',
      label: 'Chosen',
      doc: 'Which one is chosen at first: 0 is the first. If connected, no choice is shown.',
      default: 0,
      min: 0,
      step: 1,
    },
    label: { type: 'text', stage: 'structure', label: 'Label', doc: 'Text beside the choice.', default: 'Choose' },
    place: {
      type: 'number',
      stage: 'structure',
      label: 'Order',
      doc: 'Order among the controls, lowest first.',
      default: 0,
      step: 1,
    },
    options: {
      type: 'text',
      stage: 'structure',
      label: 'Options',
      doc: 'The words to choose from, separated by commas.',
      default: 'One, Two, Three',
    },
  },
  lowering: { kind: 'value' },
  control: 'choice',
});
