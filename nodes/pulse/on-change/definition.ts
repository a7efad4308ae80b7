import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'pulse/on-change',
  version: 1,
  title: 'On change',
  doc: 'Gives a pulse when a number changes, or a toggle is turned on or off. Connect a Compare to it for “when it gets more than”.',
  keywords: ['edge', 'rising', 'falling', 'trigger', 'event', 'detect', 'crossed', 'became'],
  inputs: {},
  outputs: { changed: { type: 'pulse', label: 'Changed', doc: 'A pulse per change; its number is the new one.' } },
  params: {
    number: {
      type: 'number',
      stage: 'uniform',
      label: 'Number',
      doc: 'What to watch. Toggles can be wired to it too: off is 0, on is 1.',
      default: 0,
    },
    direction: {
      type: 'choice',
      stage: 'structure',
      label: 'When it',
      doc: 'Which changes count.',
      default: 'changes',
      options: [
        { value: 'changes', label: 'Changes' },
        { value: 'rises', label: 'Rises, or is turned on' },
        { value: 'falls', label: 'Falls, or is turned off' },
      ],
    },
    least: {
      type: 'number',
      stage: 'uniform',
      label: 'At least by',
      doc: 'How far it has to go for a pulse, in one frame or several.',
      default: 0,
      min: 0,
    },
  },
  lowering: { kind: 'value' },
  stateful: { param: 'least', above: 0 },
});
