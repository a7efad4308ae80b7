import type { Asset } from '../../../export/graph/project.ts';
import type { Recipe, RecipeNode } from '../paper/recipe.ts';
import { WINDOW_LIGHT } from '../paper/room.ts';
import { BALL_RADIUS_M, CAN, CRATE_M } from './cans.ts';
import { FUNNEL_M } from './marble-run.ts';

/** Height of the table top in the studio, in meters. Both examples stand there before a visitor places them. */
const TABLE_M = 0.4225;

function models(by: string, names: readonly string[]): Record<string, Asset> {
  return Object.fromEntries(
    names.map((name) => [
      name,
      { path: `assets/${name}.glb`, kind: 'model', credit: `Made by tools/examples/play/${by}.ts`, licence: 'MIT' },
    ]),
  );
}

/** Nodes for the room, which hides objects, carries them and receives their shadows. Objects are connected to `scene` and `shadow`. */
const ROOM_NODES = {
  video: ['source/camera-video', 4, 4],
  depth: ['world/depth', 4, 3],
  light: ['light/directional', 4, 2, { ...WINDOW_LIGHT }],
  scene: ['layer/scene', 5, 0, { ambient: 0.55 }],
  hide: ['layer/depth-occlusion', 6, 0, { biasM: 0.02, softnessM: 0.02 }],
  shadow: ['layer/shadow', 5, 2, { strength: 0.5, toleranceM: 0.06 }],
  ground: ['operator/over', 6, 2],
  merge: ['operator/over', 7, 1],
  room: ['physics/room', 4, 6],
  world: ['physics/world', 5, 5],
} as const satisfies Record<string, RecipeNode>;

const ROOM_WIRES = [
  'light.lights -> scene.lights',
  'light.lights -> shadow.lights',
  'depth.depth -> shadow.depth',
  'depth.depth -> hide.depth',
  'scene.layer -> hide.layer',
  'video.layer -> ground.bottom',
  'shadow.layer -> ground.top',
  'ground.layer -> merge.bottom',
  'hide.layer -> merge.top',
  'merge.layer -> screen.layer',
  'room.body -> world.bodies',
] as const;

const shown = (...nodes: string[]): string[] =>
  nodes.flatMap((node) => [`${node}.objects -> scene.objects`, `${node}.objects -> shadow.casters`]);

const MARBLE_RUN: Recipe = {
  folder: 'marble-run',
  figure: 'run',
  title: 'A marble run over your furniture',
  description:
    'Tap a table to put the marble run there, then tap to drop marbles. They roll down the chutes, over your real table and off its edge. Pick them up by hand in a headset.',
  nodes: {
    base: ['source/model', 0, 0, { model: 'base' }],
    stand: ['source/model', 0, 1, { model: 'stand' }],
    chutes: ['source/model', 0, 2, { model: 'chutes' }],
    ruby: ['source/model', 0, 4, { model: 'ruby' }],
    sea: ['source/model', 0, 5, { model: 'sea' }],
    amber: ['source/model', 0, 6, { model: 'amber' }],
    set: ['objects/transform', 1, 0, { positionM: [-0.22, TABLE_M, -0.52], rotationRad: [0, 0.12, 0] }],
    place: ['objects/place', 2, 0, { mode: 'once', showBefore: true, surfaces: 'floor', reticle: false }],
    board: ['physics/body', 3, 0, { mode: 'static', shape: 'box' }],
    stands: ['objects/at-pose', 3, 1],
    runs: ['objects/at-pose', 2, 2],
    track: ['physics/body', 3, 2, { mode: 'static', shape: 'parts', friction: 0.35, restitution: 0.1 }],
    funnel: ['objects/transform', 1, 5, { positionM: [...FUNNEL_M] }],
    above: ['objects/at-pose', 2, 5],
    marbles: [
      'physics/body',
      3,
      5,
      {
        copies: 17,
        shape: 'sphere',
        density: 2500,
        friction: 0.35,
        rollingM: 0.0005,
        restitution: 0.45,
        linearDamping: 0.02,
        lowestM: -0.5,
      },
    ],
    every: ['pulse/every', 0, 7, { periodS: 0.6 }],
    tap: ['input/tap', 0, 8],
    drop: ['input/button', 0, 9, { label: 'Drop a marble' }],
    collect: ['input/button', 0, 10, { label: 'Collect marbles', place: 1 }],
    taps: ['value/counter', 1, 8],
    tapped: ['pulse/on-change', 2, 8],
    grab: ['physics/grab', 4, 7, { reachM: 0.04 }],
    hit: ['physics/collision', 4, 8, { leastNs: 0.003 }],
    sound: ['output/sound', 5, 8, { sound: 'glass', loudest: 0.08 }],
    words: ['objects/label', 4, 9, { text: 'Tap to drop marbles', liftM: 0.94, leader: false, fade: false, sizeM: 0.03 }],
    ...ROOM_NODES,
    screen: ['output/screen', 8, 1, { aroundHeightM: 0.62, aroundAheadM: 0.46, aroundDistanceM: 1.5 }],
  },
  wires: [
    'base.objects -> set.objects',
    'set.objects -> place.objects',
    'place.objects -> board.objects',
    'stand.objects -> stands.objects',
    'board.pose -> stands.pose',
    'chutes.objects -> runs.objects',
    'board.pose -> runs.pose',
    'runs.objects -> track.objects',
    'ruby.objects -> funnel.objects',
    'sea.objects -> funnel.objects',
    'amber.objects -> funnel.objects',
    'funnel.objects -> above.objects',
    'board.pose -> above.pose',
    'above.objects -> marbles.objects',
    'every.pulse -> marbles.spawn',
    'tap.tapped -> taps.up',
    'taps.number -> tapped.number',
    'tapped.changed -> marbles.spawn',
    'drop.pressed -> marbles.spawn',
    'collect.pressed -> marbles.recycle',
    'marbles.body -> grab.body',
    'marbles.body -> hit.body',
    'hit.touched -> sound.play',
    'board.pose -> words.pose',
    'board.body -> world.bodies',
    'track.body -> world.bodies',
    'marbles.body -> world.bodies',
    'grab.hands -> world.bodies',
    ...shown('board', 'stands', 'track', 'marbles'),
    'words.objects -> scene.objects',
    ...ROOM_WIRES,
  ],
  assets: models('marble-run', ['base', 'stand', 'chutes', 'ruby', 'sea', 'amber']),
};

/** Number of cans per row, from the bottom, and the distance between their centers. */
const ROWS = [5, 4, 3, 2, 1] as const;
const GAP_M = 2 * CAN.radiusM + 0.004;

/** A Transform node for each can, and below for each ball. Copies of an Array would be one body. */
const CANS: Readonly<Record<string, RecipeNode>> = Object.fromEntries(
  ROWS.flatMap((count, row) =>
    Array.from({ length: count }, (_, i): [string, RecipeNode] => {
      const positionM = [(i - (count - 1) / 2) * GAP_M, CRATE_M[1] + (row + 0.5) * CAN.heightM, -0.05];
      return [`can${row}${i}`, ['objects/transform', 1, 2 + row + 5 * i, { positionM, rotationRad: [0, (0.7 * row + 1.1 * i) % 3, 0] }]];
    }),
  ),
);
const BALLS: Readonly<Record<string, RecipeNode>> = Object.fromEntries(
  [-0.16, 0, 0.16].map((x, i) => [
    `ball${i}`,
    [
      'objects/transform',
      1,
      28 + i,
      { positionM: [x, CRATE_M[1] + BALL_RADIUS_M, CRATE_M[2] / 2 - 0.03], rotationRad: [0.3 + i, 0, 0.5 * i] },
    ],
  ]),
);

const TIN_CANS: Recipe = {
  folder: 'tin-cans',
  figure: 'can',
  title: 'Tin cans and a ball to throw',
  description:
    'Tap a table or the floor to put the cans there, then tap to throw a ball at them. In a headset, pick up the balls on the crate by hand and throw them.',
  nodes: {
    crate: ['source/model', 0, 0, { model: 'crate' }],
    set: ['objects/transform', 1, 0, { positionM: [-0.2, TABLE_M, -0.5], rotationRad: [0, 0.18, 0] }],
    place: ['objects/place', 2, 0, { mode: 'once', showBefore: true, surfaces: 'floor', reticle: false }],
    box: ['physics/body', 3, 0, { mode: 'static', shape: 'box', friction: 0.7 }],
    can: ['source/model', 0, 3, { model: 'can' }],
    ...CANS,
    stack: ['objects/at-pose', 3, 3],
    cans: ['physics/body', 3, 4, { shape: 'cylinder', massKg: 0.05, friction: 0.5, restitution: 0.25, rollingM: 0.002, lowestM: -0.5 }],
    ball: ['source/model', 0, 7, { model: 'ball' }],
    ...BALLS,
    lying: ['objects/at-pose', 3, 7],
    balls: ['physics/body', 3, 8, { shape: 'sphere', massKg: 0.12, friction: 0.6, restitution: 0.55, rollingM: 0.003, lowestM: -0.5 }],
    tap: ['input/tap', 0, 8, { by: 'screen' }],
    throw: [
      'physics/body',
      3,
      9,
      { copies: 32, shape: 'sphere', spawnSpeed: 6.5, massKg: 0.12, friction: 0.6, restitution: 0.55, rollingM: 0.003, lowestM: -0.5 },
    ],
    again: ['input/button', 0, 9, { label: 'Stack again' }],
    grab: ['physics/grab', 4, 7, { reachM: 0.05 }],
    tins: ['physics/collision', 4, 8, { leastNs: 0.01 }],
    tin: ['output/sound', 5, 8, { sound: 'metal', loudest: 0.25, volume: 0.7 }],
    bounces: ['physics/collision', 4, 9, { leastNs: 0.03 }],
    bounce: ['output/sound', 5, 9, { sound: 'soft', loudest: 0.6 }],
    words: ['objects/label', 4, 10, { text: 'Tap to throw', liftM: 0.94, leader: false, fade: false, sizeM: 0.03 }],
    ...ROOM_NODES,
    screen: ['output/screen', 8, 1, { aroundHeightM: 0.75, aroundAheadM: 0.44, aroundDistanceM: 1.5 }],
  },
  wires: [
    'crate.objects -> set.objects',
    'set.objects -> place.objects',
    'place.objects -> box.objects',
    ...Object.keys(CANS).flatMap((node) => [`can.objects -> ${node}.objects`, `${node}.objects -> stack.objects`]),
    'box.pose -> stack.pose',
    'stack.objects -> cans.objects',
    'place.placed -> cans.recycle',
    'place.moved -> cans.recycle',
    'again.pressed -> cans.recycle',
    ...Object.keys(BALLS).flatMap((node) => [`ball.objects -> ${node}.objects`, `${node}.objects -> lying.objects`]),
    'box.pose -> lying.pose',
    'lying.objects -> balls.objects',
    'place.placed -> balls.recycle',
    'place.moved -> balls.recycle',
    'again.pressed -> balls.recycle',
    'ball.objects -> throw.objects',
    'tap.tapped -> throw.spawn',
    'again.pressed -> throw.recycle',
    ...['cans', 'balls', 'throw'].flatMap((node) => [`${node}.body -> grab.body`, `${node}.body -> world.bodies`]),
    'cans.body -> tins.body',
    'tins.touched -> tin.play',
    'balls.body -> bounces.body',
    'throw.body -> bounces.body',
    'bounces.touched -> bounce.play',
    'box.pose -> words.pose',
    'box.body -> world.bodies',
    'grab.hands -> world.bodies',
    ...shown('box', 'cans', 'balls', 'throw'),
    'words.objects -> scene.objects',
    ...ROOM_WIRES,
  ],
  assets: models('cans', ['crate', 'can', 'ball']),
};

/** Examples to play with: physics in the real room. */
export const PLAY: readonly Recipe[] = [MARBLE_RUN, TIN_CANS];
