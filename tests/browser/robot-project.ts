import { readFile } from 'node:fs/promises';
import type { ProjectText } from '../support/project-kit.ts';

export const MODEL = await readFile('examples/first-light/assets/robot.glb');

/** A box in the middle of the view, and a model to load. */
export const ROBOT = {
  title: 'Robot and box',
  nodes: {
    'robot-a1b2': ['source/model', { model: 'robot' }],
    'box-a1b2': ['objects/primitive', { color: [1, 0, 0, 1] }],
    'place-a1b2': ['objects/transform', { positionM: [0, 0.75, 0] }],
    'scene-a1b2': 'layer/scene',
    'screen-a1b2': 'output/screen',
  },
  wires: [
    'robot-a1b2.objects -> scene-a1b2.objects',
    'box-a1b2.objects -> place-a1b2.objects',
    'place-a1b2.objects -> scene-a1b2.objects',
    'scene-a1b2.layer -> screen-a1b2.layer',
  ],
  assets: { robot: { path: 'assets/robot.glb', kind: 'model' } },
} as const satisfies ProjectText;
