import type { Asset } from '../../../export/graph/project.ts';
import type { RecipeNode } from './recipe.ts';

/** Real objects of the studio (`export/emulator/rooms/studio/furniture.ts`), in which all examples take place; in meters. */
export const TABLE = { x: -0.2, z: -0.42, topM: 0.4225, widthM: 1.05, depthM: 0.56, thickM: 0.035 } as const;
const STOOL = { x: 1.2, z: -0.55, widthM: 0.56, heightM: 0.38 } as const;

export const ROBOT: Readonly<Record<string, Asset>> = {
  'robot-tin1': { path: 'assets/robot.glb', kind: 'model', credit: 'Made by tools/examples/robot.ts', licence: 'MIT' },
};

export const ELEPHANT: Readonly<Record<string, Asset>> = {
  'elephant-02': { path: 'assets/elephant.glb', kind: 'model', credit: 'Made by tools/examples/elephant.ts', licence: 'MIT' },
};

/** The robot and the elephant: a model with flat sides and edges beside one without. */
export const PAIR: Readonly<Record<string, Asset>> = {
  ...ROBOT,
  ...ELEPHANT,
};

/** Asset table with an image of four hands in front of a wall. */
export const HANDS: Readonly<Record<string, Asset>> = {
  'hands-up04': { path: 'assets/hands.png', kind: 'image', credit: 'Made by tools/examples/paper/hands.ts', licence: 'MIT' },
};

/** A robot on the rug in front of the table. `robot.objects` outputs it. */
export function robotOnRug(
  row: number,
  place: { readonly x?: number; readonly y?: number; readonly z?: number; readonly yawRad?: number } = {},
) {
  const { x = 0.6, y = 0, z = -0.22, yawRad = -0.05 } = place;
  return {
    model: ['source/model', 0, row, { model: 'robot-tin1' }],
    robot: ['objects/transform', 1, row, { positionM: [x, y, z], rotationRad: [0, yawRad, 0], scale: 1.55 }],
  } as const satisfies Record<string, RecipeNode>;
}

export const ROBOT_WIRES = ['model.objects -> robot.objects'] as const;

/** Two photographs of the studio with different exposures. */
export const SHOTS: Readonly<Record<string, Asset>> = {
  'shot-long': { path: 'assets/long.jpg', kind: 'image', credit: 'Made by tools/examples/paper/bracket.ts', licence: 'MIT' },
  'shot-short': { path: 'assets/short.jpg', kind: 'image', credit: 'Made by tools/examples/paper/bracket.ts', licence: 'MIT' },
};

/** An elephant on the rug, and a robot on the real table beside it. `pair.objects` outputs both; they fill a third of the image. */
export function elephantAndRobot(row: number) {
  return {
    calf: ['source/model', 0, row, { model: 'elephant-02' }],
    elephant: ['objects/transform', 1, row, { positionM: [0.54, 0, -0.52], rotationRad: [0, -0.95, 0], scale: 1.26 }],
    model: ['source/model', 0, row + 1, { model: 'robot-tin1' }],
    robot: ['objects/transform', 1, row + 1, { positionM: [-0.56, TABLE.topM, -0.4], rotationRad: [0, 0.3, 0], scale: 1.7 }],
    pair: ['objects/group', 2, row],
  } as const satisfies Record<string, RecipeNode>;
}

export const PAIR_WIRES = [
  'calf.objects -> elephant.objects',
  'model.objects -> robot.objects',
  'elephant.objects -> pair.objects',
  'robot.objects -> pair.objects',
] as const;

/** Params of a directional light that comes from the window, over the left shoulder of the viewer. */
export const WINDOW_LIGHT = { azimuthRad: -1.2, elevationRad: 0.75, color: [1, 0.96, 0.9, 1], intensity: 0.85, areaM: 2 } as const;

/** Floor, table and stool as phantoms. `floor.objects` and `table.objects` receive shadows; `stool.objects` also casts them. */
export function phantoms(row: number) {
  return {
    plane: ['objects/primitive', 0, row, { shape: 'plane', sizeM: [5, 0, 4.6] }],
    floor: ['objects/phantom', 2, row],
    round: ['objects/primitive', 0, row + 1, { shape: 'cylinder', sizeM: [STOOL.widthM, STOOL.heightM, STOOL.widthM] }],
    set: ['objects/transform', 1, row + 1, { positionM: [STOOL.x, STOOL.heightM / 2, STOOL.z] }],
    stool: ['objects/phantom', 2, row + 1, { castShadow: true }],
    board: ['objects/primitive', 0, row + 2, { shape: 'box', sizeM: [TABLE.widthM, TABLE.thickM, TABLE.depthM] }],
    lay: ['objects/transform', 1, row + 2, { positionM: [TABLE.x, TABLE.topM - TABLE.thickM / 2, TABLE.z] }],
    table: ['objects/phantom', 2, row + 2],
  } as const satisfies Record<string, RecipeNode>;
}

export const PHANTOM_WIRES = [
  'plane.objects -> floor.objects',
  'round.objects -> set.objects',
  'set.objects -> stool.objects',
  'board.objects -> lay.objects',
  'lay.objects -> table.objects',
] as const;
