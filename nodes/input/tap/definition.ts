import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'input/tap',
  version: 1,
  title: 'Tap',
  doc: 'Gives a pulse when the visitor taps the screen, clicks, or selects with a controller or by pinching. The pulse brings the ray that was pointed along. Taps on controls do not count.',
  keywords: ['touch', 'click', 'select', 'press', 'pinch', 'trigger', 'pointer', 'interactive', 'event'],
  inputs: {},
  outputs: {
    tapped: { type: 'pulse', label: 'Tapped', doc: 'A pulse per tap, with the ray as its pose; its number says which tap it is, from 1.' },
    point: {
      type: 'vector3',
      label: 'Point',
      doc: 'Where the last tap pointed to, in meters: so far along its ray as is set here. Connect it to a position to put something there.',
    },
  },
  params: {
    by: {
      type: 'choice',
      stage: 'structure',
      label: 'By',
      doc: 'Which taps count.',
      default: 'any',
      options: [
        { value: 'any', label: 'Anything' },
        { value: 'screen', label: 'The screen' },
        { value: 'hands', label: 'Controllers and hands' },
      ],
    },
    distanceM: {
      type: 'number',
      stage: 'uniform',
      label: 'Distance',
      doc: 'How far along the ray the point lies.',
      default: 1.5,
      min: 0,
      max: 20,
      step: 0.05,
      unit: 'm',
    },
    start: { type: 'vector3', stage: 'uniform', label: 'Start', doc: 'The point before the first tap, meters.', default: [0, 0, 0] },
  },
  lowering: { kind: 'value' },
  stateful: true,
});
