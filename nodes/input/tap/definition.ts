import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'input/tap',
  version: 1,
  title: 'Tap',
  doc: 'Outputs a pulse when the visitor taps the screen, clicks, or selects with a controller or a pinch. The pulse carries the pose of the pointing ray. Taps on controls do not count.',
  keywords: ['touch', 'click', 'select', 'press', 'pinch', 'trigger', 'pointer', 'interactive', 'event'],
  inputs: {},
  outputs: {
    tapped: { type: 'pulse', label: 'Tapped', doc: 'One pulse per tap, with the pose of the ray; its number counts the taps, from 1.' },
    point: {
      type: 'vector3',
      label: 'Point',
      doc: 'Point on the ray of the last tap, in meters, world space, at “Distance” from its origin. Connect it to a position to place an object there.',
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
        { value: 'any', label: 'Any' },
        { value: 'screen', label: 'Screen' },
        { value: 'hands', label: 'Controllers and hands' },
      ],
    },
    distanceM: {
      type: 'number',
      stage: 'uniform',
      label: 'Distance',
      doc: 'How far along the ray “Point” lies.',
      default: 1.5,
      min: 0,
      max: 20,
      step: 0.05,
      unit: 'm',
    },
    start: {
      type: 'vector3',
      stage: 'uniform',
      handle: 'position',
      label: 'Start',
      doc: 'Value of “Point” before the first tap, in meters.',
      default: [0, 0, 0],
    },
  },
  readsInput: true,
  lowering: { kind: 'value' },
  stateful: true,
});
