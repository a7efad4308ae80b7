import { WORLD_IN_THE_BOOK } from './book-recipe.ts';
import type { Recipe, RecipeNode } from './recipe.ts';
import {
  ELEPHANT,
  elephantAndRobot,
  PAIR,
  PAIR_WIRES,
  PHANTOM_WIRES,
  phantoms,
  ROBOT,
  ROBOT_WIRES,
  robotOnRug,
  TABLE,
  WINDOW_LIGHT,
} from './room.ts';

const EDGES = { strength: 8, lineColor: [0.1, 0.08, 0.06, 1], paperColor: [0.97, 0.95, 0.9, 1] } as const;
const MODEL_SCENE = {
  ...robotOnRug(0),
  light: ['light/directional', 1, 1, WINDOW_LIGHT],
  scene: ['layer/scene', 2, 0, { ambient: 0.4 }],
  video: ['source/camera-video', 1, 2],
} as const;
const MODEL_WIRES = [...ROBOT_WIRES, 'robot.objects -> scene.objects', 'light.lights -> scene.lights'] as const;

const WAYS = ['gooch', 'toon', 'brick', 'hatching', 'charcoal'] as const;

/** Two rows of three balls; the first has no technique. */
const BALLS: Record<string, RecipeNode> = Object.fromEntries([
  ['first', ['objects/transform', 1, 0, { positionM: ballAt(0) }] as const],
  ...WAYS.flatMap((way, i) => [
    [`ball${i}`, ['objects/transform', 1, i + 1, { positionM: ballAt(i + 1) }] as const] as const,
    [way, [`technique/${way}`, 1, i + 7] as const] as const,
    [`by${i}`, ['objects/apply-technique', 2, i + 1] as const] as const,
  ]),
]);

const BALL_WIRES = [
  'plain.objects -> first.objects',
  'first.objects -> scene.objects',
  ...WAYS.flatMap((way, i) => [
    `plain.objects -> ball${i}.objects`,
    `ball${i}.objects -> by${i}.objects`,
    `${way}.technique -> by${i}.technique`,
    `by${i}.objects -> scene.objects`,
  ]),
];

function ballAt(i: number): readonly [number, number, number] {
  return [(i % 3) * 0.56 - 0.5, i < 3 ? 1.12 : 0.58, 0.1];
}

/** Params of a lamp that shines over the table at the sofa; its position is in meters. */
function lampAt(positionM: readonly [number, number, number], intensityCd: number): NonNullable<RecipeNode[3]> {
  return { color: WINDOW_LIGHT.color, intensityCd, positionM, targetM: [-0.2, 0.9, -1.2], angleRad: 1.7, filter: 'soft' };
}

/** The elephant and the robot with one technique, and their shadows on the real floor and table. */
function pairBy(technique: string, about: Pick<Recipe, 'folder' | 'figure' | 'title' | 'description'>, params: RecipeNode[3] = {}): Recipe {
  return {
    ...about,
    nodes: {
      ...elephantAndRobot(0),
      ...phantoms(3),
      // Higher than the window, so that the shadows do not reach the stool.
      light: ['light/directional', 2, 2, { ...WINDOW_LIGHT, elevationRad: 1.05 }],
      way: [`technique/${technique}`, 2, 1, params],
      drawn: ['objects/apply-technique', 3, 0],
      video: ['source/camera-video', 3, 3],
      scene: ['layer/scene', 4, 0, { ambient: 0.4 }],
      shadow: ['layer/shadow', 4, 1, { strength: 0.6, method: 'volume' }],
      ground: ['operator/over', 5, 2],
      merge: ['operator/over', 6, 1],
      screen: ['output/screen', 7, 1],
    },
    wires: [
      ...PAIR_WIRES,
      ...PHANTOM_WIRES,
      'pair.objects -> drawn.objects',
      'way.technique -> drawn.technique',
      'drawn.objects -> scene.objects',
      'light.lights -> scene.lights',
      'pair.objects -> shadow.casters',
      'floor.objects -> shadow.receivers',
      'table.objects -> shadow.receivers',
      'light.lights -> shadow.lights',
      'video.layer -> ground.bottom',
      'shadow.layer -> ground.top',
      'ground.layer -> merge.bottom',
      'scene.layer -> merge.top',
      'merge.layer -> screen.layer',
    ],
    assets: PAIR,
  };
}

/** Examples with objects in the room. */
export const SCENES: readonly Recipe[] = [
  {
    folder: 'edges-of-a-blurred-room',
    figure: '4a',
    title: 'Edges of a blurred room',
    description: 'The room is blurred before the edge filter, the model is not: the model has fine lines, the room few and soft ones.',
    nodes: {
      ...MODEL_SCENE,
      blur: ['filter/gaussian-blur', 2, 2, { radius: 5 }],
      merge: ['operator/over', 3, 1],
      edges: ['filter/sobel-edges', 4, 1, EDGES],
      screen: ['output/screen', 5, 1],
    },
    wires: [
      ...MODEL_WIRES,
      'video.layer -> blur.inputImage',
      'blur.layer -> merge.bottom',
      'scene.layer -> merge.top',
      'merge.layer -> edges.inputImage',
      'edges.layer -> screen.layer',
    ],
    assets: ROBOT,
  },
  {
    folder: 'edges-of-a-blurred-picture',
    figure: '4b',
    title: 'Edges of a blurred image',
    description: 'The same nodes in another order: room and model are blurred together, so both have coarse lines.',
    nodes: {
      ...MODEL_SCENE,
      merge: ['operator/over', 3, 1],
      blur: ['filter/gaussian-blur', 4, 1, { radius: 5 }],
      edges: ['filter/sobel-edges', 5, 1, EDGES],
      screen: ['output/screen', 6, 1],
    },
    wires: [
      ...MODEL_WIRES,
      'video.layer -> merge.bottom',
      'scene.layer -> merge.top',
      'merge.layer -> blur.inputImage',
      'blur.layer -> edges.inputImage',
      'edges.layer -> screen.layer',
    ],
    assets: ROBOT,
  },
  {
    folder: 'shadows-of-real-and-virtual-things',
    figure: '6',
    title: 'Shadows of real and virtual objects',
    description:
      'A robot hovers over a real rug, beside a real stool. A virtual light makes the robot and the stool cast shadows on the rug and on each other. The stool also has its real shadow. Set “Method” of the Shadow node to compare shadow maps and shadow volumes.',
    nodes: {
      ...robotOnRug(0, { x: 0.5, y: 0.05, z: -0.3 }),
      ...phantoms(1),
      lamp: ['light/spot', 2, 4, { positionM: [2.4, 1.9, -0.95], targetM: [0.55, 0.1, -0.3], intensityCd: 30, angleRad: 0.8 }],
      video: ['source/camera-video', 3, 3],
      scene: ['layer/scene', 3, 0, { ambient: 0.5, shadows: false }],
      shadow: ['layer/shadow', 3, 1, { strength: 0.6, on: 'everything', method: 'volume' }],
      things: ['operator/over', 4, 0],
      merge: ['operator/over', 5, 1],
      screen: ['output/screen', 6, 1],
    },
    wires: [
      ...ROBOT_WIRES,
      ...PHANTOM_WIRES,
      'robot.objects -> scene.objects',
      'stool.objects -> scene.objects',
      'table.objects -> scene.objects',
      'lamp.lights -> scene.lights',
      'robot.objects -> shadow.casters',
      'stool.objects -> shadow.casters',
      'robot.objects -> shadow.receivers',
      'stool.objects -> shadow.receivers',
      'table.objects -> shadow.receivers',
      'floor.objects -> shadow.receivers',
      'lamp.lights -> shadow.lights',
      'video.layer -> things.bottom',
      'scene.layer -> things.top',
      'things.layer -> merge.bottom',
      'shadow.layer -> merge.top',
      'merge.layer -> screen.layer',
    ],
    assets: ROBOT,
  },
  {
    folder: 'glass-in-the-room',
    figure: '7',
    title: 'Glass in the room',
    description:
      'A ball and a ring of glass in front of the camera image: both surfaces refract it, and the edges reflect more than the center.',
    nodes: {
      ball: ['objects/primitive', 0, 0, { shape: 'sphere', sizeM: [0.55, 0.55, 0.55] }],
      hang: ['objects/transform', 1, 0, { positionM: [-0.3, 0.85, 0.1] }],
      torus: ['objects/primitive', 0, 1, { shape: 'torus', sizeM: [0.5, 0.14, 0.5] }],
      turn: ['objects/transform', 1, 1, { positionM: [0.42, 0.85, 0.05], rotationRad: [1.1, 0, 0.4] }],
      video: ['source/camera-video', 0, 2],
      glass: ['technique/glass', 1, 2, { thicknessM: 0.5 }],
      clear: ['objects/apply-technique', 2, 0],
      light: ['light/directional', 2, 2, WINDOW_LIGHT],
      scene: ['layer/scene', 3, 0, { ambient: 0.5 }],
      merge: ['operator/over', 4, 1],
      screen: ['output/screen', 5, 1],
    },
    wires: [
      'ball.objects -> hang.objects',
      'torus.objects -> turn.objects',
      'hang.objects -> clear.objects',
      'turn.objects -> clear.objects',
      'video.layer -> glass.behind',
      'glass.technique -> clear.technique',
      'clear.objects -> scene.objects',
      'light.lights -> scene.lights',
      'video.layer -> merge.bottom',
      'scene.layer -> merge.top',
      'merge.layer -> screen.layer',
    ],
  },
  {
    folder: 'ways-to-draw',
    figure: '9',
    title: 'Materials, side by side',
    description:
      'Six balls in the same light with different materials: their own, Gooch’s cool-to-warm tones, cartoon, bricks, pen strokes and charcoal. Each object has the material that is connected to it.',
    nodes: {
      plain: ['objects/primitive', 0, 0, { shape: 'sphere', sizeM: [0.46, 0.46, 0.46], color: [0.75, 0.3, 0.2, 1] }],
      ...BALLS,
      light: ['light/directional', 3, 3, WINDOW_LIGHT],
      scene: ['layer/scene', 4, 1, { ambient: 0.4, shadows: false }],
      video: ['source/camera-video', 4, 2],
      merge: ['operator/over', 5, 1],
      screen: ['output/screen', 6, 1],
    },
    wires: [
      ...BALL_WIRES,
      'light.lights -> scene.lights',
      'video.layer -> merge.bottom',
      'scene.layer -> merge.top',
      'merge.layer -> screen.layer',
    ],
  },
  {
    folder: 'cartoon-over-tiles',
    figure: '10',
    title: 'A cartoon over tiles',
    description: 'Two independent effects: the robot is drawn as a cartoon, the room behind it is tiled.',
    nodes: {
      ...MODEL_SCENE,
      toon: ['technique/toon', 0, 1],
      drawn: ['objects/apply-technique', 2, 1],
      scene: ['layer/scene', 3, 0, { ambient: 0.4 }],
      tiles: ['filter/tile', 2, 2, { columns: 3, rows: 3, mirror: true }],
      merge: ['operator/over', 4, 1],
      screen: ['output/screen', 5, 1],
    },
    wires: [
      ...ROBOT_WIRES,
      'robot.objects -> drawn.objects',
      'toon.technique -> drawn.technique',
      'drawn.objects -> scene.objects',
      'light.lights -> scene.lights',
      'video.layer -> tiles.inputImage',
      'tiles.layer -> merge.bottom',
      'scene.layer -> merge.top',
      'merge.layer -> screen.layer',
    ],
    assets: ROBOT,
  },
  {
    folder: 'sketchy-shadow',
    figure: '11',
    title: 'A sketchy shadow',
    description:
      'Two lamps in front of the table cast large shadows of an elephant and a robot on the real table, sofa, floor, wall and bookcase. They are drawn as pencil strokes, which lie on these surfaces and get denser toward the models; each lamp has strokes in its own direction. Elephant and robot have Gooch’s cool-to-warm tones, and the room is unchanged.',
    nodes: {
      ...elephantAndRobot(0),
      elephant: ['objects/transform', 1, 0, { positionM: [-0.03, TABLE.topM, -0.4], rotationRad: [0, -1.15, 0], scale: 0.7 }],
      robot: ['objects/transform', 1, 1, { positionM: [-1.08, 0, -0.45], rotationRad: [0, -0.05, 0], scale: 1.9 }],
      ...phantoms(3),
      gooch: ['technique/gooch', 2, 1],
      drawn: ['objects/apply-technique', 3, 0],
      // Near the elephant and as high as its head, so that its shadows on the wall are larger than it is.
      light: ['light/spot', 2, 2, lampAt([-1, 0.96, 0.42], 7.5)],
      lamp: ['light/spot', 2, 3, lampAt([0.36, 0.98, 0.4], 5.5)],
      depth: ['world/depth', 2, 4],
      shadow: ['layer/shadow', 3, 1, { strength: 0.85, color: [0.1, 0.09, 0.13, 1], drawing: 'strokes', spacingPx: 9, contactM: 2.2 }],
      video: ['source/camera-video', 4, 3],
      scene: ['layer/scene', 3, 0, { ambient: 0.4, shadows: false }],
      ground: ['operator/over', 5, 2],
      merge: ['operator/over', 6, 1],
      screen: ['output/screen', 7, 1],
    },
    wires: [
      ...PAIR_WIRES,
      ...PHANTOM_WIRES,
      'pair.objects -> drawn.objects',
      'gooch.technique -> drawn.technique',
      'drawn.objects -> scene.objects',
      'table.objects -> scene.objects',
      'stool.objects -> scene.objects',
      'light.lights -> scene.lights',
      'pair.objects -> shadow.casters',
      'floor.objects -> shadow.receivers',
      'table.objects -> shadow.receivers',
      'stool.objects -> shadow.receivers',
      'depth.depth -> shadow.depth',
      'light.lights -> shadow.lights',
      'lamp.lights -> shadow.lights',
      'video.layer -> ground.bottom',
      'shadow.layer -> ground.top',
      'ground.layer -> merge.bottom',
      'scene.layer -> merge.top',
      'merge.layer -> screen.layer',
    ],
    assets: PAIR,
  },
  WORLD_IN_THE_BOOK,
  pairBy('gooch', {
    folder: 'gooch-tones',
    figure: '12a',
    title: 'Gooch’s tones',
    description: 'A robot shaded as in technical illustrations: warm towards the light, cool away from it, with an outline.',
  }),
  pairBy('brick', {
    folder: 'built-of-bricks',
    figure: '12b',
    title: 'Built of bricks',
    description: 'A robot of bricks and mortar, computed without a texture. The bricks stay in place as it walks.',
  }),
  pairBy('hatching', {
    folder: 'pen-strokes',
    figure: '12c',
    title: 'In pen strokes',
    description: 'A robot hatched in real time: darker areas get more strokes, and the strokes stay in place as it walks.',
  }),
  {
    folder: 'borders-as-sketch-lines',
    figure: '10s',
    title: 'Borders as sketch lines',
    description:
      'An elephant stands behind the real table. Where the depth sensor is too coarse to say which of the two a pixel shows, the border is a sketch line instead of a cut. “Sure within” of Sketched occlusion says how much of it is drawn.',
    nodes: {
      model: ['source/model', 0, 0, { model: 'elephant-02' }],
      elephant: ['objects/transform', 1, 0, { positionM: [-0.32, 0, -1.02], rotationRad: [0, 1.1, 0], scale: 1.4 }],
      tones: ['technique/gooch', 1, 1],
      toned: ['objects/apply-technique', 2, 0],
      light: ['light/directional', 2, 1, WINDOW_LIGHT],
      scene: ['layer/scene', 3, 0, { ambient: 0.4 }],
      depth: ['world/depth', 3, 1],
      occlusion: ['operator/sketched-occlusion', 4, 0, { linePx: 3, lineColor: [0.98, 0.95, 0.88, 1] }],
      video: ['source/camera-video', 4, 1],
      merge: ['operator/over', 5, 0],
      screen: ['output/screen', 6, 0],
    },
    wires: [
      'model.objects -> elephant.objects',
      'elephant.objects -> toned.objects',
      'tones.technique -> toned.technique',
      'toned.objects -> scene.objects',
      'light.lights -> scene.lights',
      'scene.layer -> occlusion.inputImage',
      'depth.depth -> occlusion.room',
      'depth.confidence -> occlusion.confidence',
      'occlusion.layer -> merge.top',
      'video.layer -> merge.bottom',
      'merge.layer -> screen.layer',
    ],
    assets: ELEPHANT,
  },
];
