import { defineNode } from '../../kit/definition.ts';
import { BASE_COLOR, ROUGHNESS } from '../../kit/material-params.ts';

export const definition = defineNode({
  type: 'objects/hands',
  version: 1,
  title: 'Hands and controllers',
  doc: 'Makes models of the visitor’s bare hands, which follow their joints, and of the controllers they hold. Where the visitor sees their real hands, connect it to a Phantom, so that the hands hide virtual objects behind them. There are none while nothing is tracked, and on phones.',
  keywords: ['avatar', 'controller', 'finger', 'glove', 'hand tracking', 'occluder', 'model', 'vr'],
  inputs: {},
  outputs: { objects: { type: 'objects', label: 'Objects', doc: 'The hands and controllers that are tracked, in world space.' } },
  params: {
    show: {
      type: 'choice',
      stage: 'structure',
      label: 'Show',
      doc: 'Which models to make.',
      default: 'both',
      options: [
        { value: 'both', label: 'Hands and controllers' },
        { value: 'hands', label: 'Hands' },
        { value: 'controllers', label: 'Controllers' },
      ],
    },
    side: {
      type: 'choice',
      stage: 'structure',
      label: 'Side',
      doc: 'Which side.',
      default: 'both',
      options: [
        { value: 'both', label: 'Both' },
        { value: 'left', label: 'Left' },
        { value: 'right', label: 'Right' },
      ],
    },
    color: { ...BASE_COLOR, default: [0.75, 0.72, 0.7, 1] },
    roughness: { ...ROUGHNESS, default: 0.7 },
    castShadow: { type: 'toggle', stage: 'uniform', label: 'Cast shadows', doc: 'Whether they cast shadows.', default: true },
    receiveShadow: {
      type: 'toggle',
      stage: 'uniform',
      label: 'Receive shadows',
      doc: 'Whether they receive shadows, their own included.',
      default: true,
    },
  },
  readsInput: true,
  lowering: { kind: 'geometry' },
  needs: [
    {
      capability: 'hands',
      required: false,
      when: 'always',
      where: { param: 'show', is: 'both' },
      why: 'to follow your hands',
      without: 'There are no models of bare hands, only of controllers.',
    },
    {
      capability: 'hands',
      required: false,
      when: 'always',
      where: { param: 'show', is: 'hands' },
      why: 'to follow your hands',
      without: 'There are no models of bare hands.',
    },
  ],
});
