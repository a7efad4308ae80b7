import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/delay',
  version: 1,
  title: 'Delay',
  doc: 'Gives a number as it was some time ago: at least one frame. The one node through which wires may form a loop, so that a value can depend on what it was.',
  keywords: ['echo', 'lag', 'previous', 'feedback', 'loop', 'history', 'later', 'wait'],
  inputs: {},
  outputs: { result: { type: 'number', label: 'Result', doc: 'The number of then.' } },
  params: {
    number: { type: 'number', stage: 'uniform', label: 'Number', doc: 'What to delay.', default: 0 },
    delayS: {
      type: 'number',
      stage: 'uniform',
      label: 'Delay',
      doc: 'By how many seconds. 0 is one frame; between two frames it goes evenly from one to the other.',
      default: 0,
      min: 0,
      max: 10,
      step: 0.05,
      unit: 's',
    },
    start: { type: 'number', stage: 'uniform', label: 'Start', doc: 'What it gives in the first frame.', default: 0 },
  },
  lowering: { kind: 'value' },
  stateful: true,
  delay: true,
});
