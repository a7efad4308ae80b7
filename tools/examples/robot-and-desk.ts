import type { Project } from '../../export/graph/project.ts';
import type { NodeLibrary } from '../../nodes/kit/definition.ts';
import { makeProject } from './paper/recipe.ts';
import { SUN } from './photographed-desk.ts';

/** Folder in `examples/`. */
export const ROBOT_AND_DESK = 'a-robot-around-a-photographed-desk';

/** Where the photographed desk stands: in front of the visitor. Meters. */
export const DESK_AT = [0, 0, -1.9] as const;

/** The ellipse on which the robot walks around the desk: half axes along x and z in meters, and angle: 0 in front. */
export const WALK = { xM: 0.9, zM: 0.6, radPerS: 0.4, startRad: 2.7 } as const;

export const ROBOT_SCALE = 1.8;

/** Makes the example of a captured place in which a virtual thing walks: hidden by what was photographed, its shadow on it, both as a comic. */
export function makeRobotAndDesk(library: NodeLibrary): Project {
  const [x, y, z] = DESK_AT;
  const phase = `(${WALK.startRad} + time * ${WALK.radPerS})`;
  return makeProject(library, {
    folder: ROBOT_AND_DESK,
    figure: 'desk',
    title: 'A robot around a photographed desk',
    description:
      'A desk that was photographed from all sides stands in the room. A robot walks around it, is hidden behind it, and its shadow falls on it; both are a comic.',
    nodes: {
      desk: ['source/capture', 0, 3, { file: 'desk', positionM: [x, y, z] }],
      mesh: ['source/capture-mesh', 0, 1, { file: 'desk', positionM: [x, y, z] }],
      robot: ['source/model', 0, 0, { model: 'robot' }],
      walk: ['objects/transform', 1, 0, { scale: ROBOT_SCALE }],
      sun: ['light/directional', 1, 2, SUN],
      scene: ['layer/scene', 2, 0, { ambient: 0.55 }],
      shadow: ['layer/shadow', 2, 1, { strength: 0.55 }],
      ground: ['operator/over', 3, 2],
      over: ['operator/over', 4, 1],
      print: ['filter/comic-drawing', 5, 1],
      screen: ['output/screen', 6, 1],
    },
    wires: [
      'robot.objects -> walk.objects',
      'walk.objects -> scene.objects',
      'mesh.objects -> scene.objects',
      'sun.lights -> scene.lights',
      'walk.objects -> shadow.casters',
      'mesh.objects -> shadow.receivers',
      'sun.lights -> shadow.lights',
      'desk.layer -> ground.bottom',
      'shadow.layer -> ground.top',
      'ground.layer -> over.bottom',
      'scene.layer -> over.top',
      'over.layer -> print.inputImage',
      'print.layer -> screen.layer',
    ],
    bindings: {
      'walk.positionM': { expression: `[${x} + ${WALK.xM} * sin(${phase}), 0, ${z} + ${WALK.zM} * cos(${phase})]` },
      // It faces the way that it walks.
      'walk.rotationRad': { expression: `[0, atan2(${WALK.xM} * cos(${phase}), -${WALK.zM} * sin(${phase})), 0]` },
    },
    assets: {
      desk: {
        path: 'assets/desk.capture/capture.json',
        kind: 'capture',
        credit: 'Made by tools/examples/photographed-desk.ts',
        licence: 'MIT',
      },
      robot: { path: 'assets/robot.glb', kind: 'model', credit: 'Made by tools/examples/robot.ts', licence: 'MIT' },
    },
  });
}
