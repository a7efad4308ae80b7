import type { Project } from '../../export/graph/project.ts';
import type { NodeLibrary } from '../../nodes/kit/definition.ts';
import { makeProject } from './paper/recipe.ts';

/** Folder in `examples/`. */
export const LAMP_AND_WINDOW = 'a-lamp-and-a-window';

/**
 * Makes the example after Figure 21 of “Real Time Shadow Mapping for Augmented Reality Photorealistic Rendering”: an object with the
 * shadows of a lamp and of a window, which are found in a panorama of the room. The same project serves phones and glasses that cannot
 * darken.
 */
export function makeLampAndWindow(library: NodeLibrary): Project {
  return makeProject(library, {
    folder: LAMP_AND_WINDOW,
    figure: '21',
    title: 'A lamp and a window',
    description:
      'A tin robot on the floor is lit by the lamp and the window of a panorama, and casts a shadow for each of them, also on glasses that cannot darken.',
    nodes: {
      room: ['source/panorama-capture', 0, 1, { file: 'room', exposure: -1 }],
      lamps: ['light/from-panorama', 1, 1, { lamps: 2, areaM: 3, visitorControls: true }],
      robot: ['source/model', 0, 0, { model: 'robot' }],
      stand: ['objects/transform', 1, 0, { positionM: [0.8, 0, -0.6], rotationRad: [0, 0.3, 0], scale: 1.4 }],
      plane: ['objects/primitive', 0, 2, { shape: 'plane', sizeM: [5, 0, 5] }],
      floor: ['objects/phantom', 1, 2],
      shadow: ['layer/negative-shadow', 2, 1, { strength: 0.9, maxStretchM: 1 }],
      scene: ['layer/scene', 2, 0],
      over: ['operator/over', 3, 0],
      screen: ['output/screen', 4, 0],
    },
    wires: [
      'room.environment -> lamps.environment',
      'robot.objects -> stand.objects',
      'plane.objects -> floor.objects',
      'stand.objects -> scene.objects',
      'lamps.lights -> scene.lights',
      'stand.objects -> shadow.casters',
      'floor.objects -> shadow.receivers',
      'lamps.lights -> shadow.lights',
      'shadow.layer -> over.bottom',
      'scene.layer -> over.top',
      'over.layer -> screen.layer',
    ],
    assets: {
      room: { path: 'assets/room.hdr', kind: 'environment', credit: 'Scrim', licence: 'MIT' },
      robot: { path: 'assets/robot.glb', kind: 'model', credit: 'Scrim', licence: 'MIT' },
    },
  });
}
