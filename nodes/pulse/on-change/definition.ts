import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'pulse/on-change',
  version: 1,
  title: 'On change',
  doc: 'Outputs a pulse when a number changes, or when a toggle is turned on or off. Connect a Compare node to it for a pulse when a number exceeds a limit.',
  keywords: ['edge', 'rising', 'falling', 'trigger', 'event', 'detect', 'crossed', 'became'],
  inputs: {},
  outputs: { changed: { type: 'pulse', label: 'Changed', doc: 'One pulse per change; it carries the new number.' } },
  params: {
    number: {
      type: 'number',
      stage: 'uniform',
      label: 'Number',
      doc: 'The number to watch. A toggle can be connected too: off is 0, on is 1.',
      default: 0,
    },
    direction: {
      type: 'choice',
      stage: 'structure',
      label: 'Trigger',
      doc: 'Which changes count.',
      default: 'changes',
      options: [
        { value: 'changes', label: 'Changes' },
        { value: 'rises', label: 'Rises or is turned on' },
        { value: 'falls', label: 'Falls or is turned off' },
      ],
    },
    least: {
      type: 'number',
      stage: 'uniform',
      label: 'Minimum change',
      doc: 'The smallest change that outputs a pulse, in one frame or over several.',
      default: 0,
      min: 0,
    },
  },
  lowering: { kind: 'value' },
  stateful: { param: 'least', above: 0 },
});
