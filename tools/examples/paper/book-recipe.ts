import type { Asset } from '../../../export/graph/project.ts';
import { LEAN, LECTERN, PAGE } from './book.ts';
import type { Recipe } from './recipe.ts';
import { PAIR, TABLE, WINDOW_LIGHT } from './room.ts';

/** The middle of the open book in the room: at arm's length from where the recorded visitor stands first. */
export const BOOK_AT = [0.26, LECTERN.middleM, 0.6] as const;
export const LYING = { positionM: BOOK_AT, rotationRad: [Math.PI / 2 - LEAN.backRad, LEAN.yawRad, 0] } as const;
/** The valley: its ground begins at the foot of the book, and it leans with the book, so that one looks across it from above. */
const WORLD = {
  positionM: [
    BOOK_AT[0],
    BOOK_AT[1] - (PAGE.heightM / 2) * Math.cos(LEAN.backRad),
    BOOK_AT[2] + (PAGE.heightM / 2) * Math.sin(LEAN.backRad),
  ],
  rotationRad: [-LEAN.backRad, LEAN.yawRad, 0],
} as const;

/** Distances from the eyes to the book in meters, and what changes between them. */
export const NEARING = {
  /** The light of the room becomes that of the valley. */
  light: { farM: 1.05, nearM: 0.35, farK: 6500, nearK: 13_000 },
  /** A window grows from the spine, from nothing until it surrounds the visitor; sizes in open books. */
  window: { farM: 0.8, nearM: 0.32, farSize: 0.001, nearSize: 12 },
} as const;

const BOOK: Readonly<Record<string, Asset>> = {
  ...(PAIR['elephant-02'] ? { 'elephant-02': PAIR['elephant-02'] } : {}),
  'pages-13': { path: 'assets/pages.glb', kind: 'model', credit: 'Made by tools/examples/paper/book.ts', licence: 'MIT' },
  'panes-13': { path: 'assets/panes.glb', kind: 'model', credit: 'Made by tools/examples/paper/book.ts', licence: 'MIT' },
  'lectern-13': { path: 'assets/lectern.glb', kind: 'model', credit: 'Made by tools/examples/paper/book.ts', licence: 'MIT' },
  'valley-13': { path: 'assets/valley.glb', kind: 'model', credit: 'Made by tools/examples/paper/book.ts', licence: 'MIT' },
  'night-13': { path: 'assets/night.glb', kind: 'model', credit: 'Made by tools/examples/paper/book.ts', licence: 'MIT' },
};

/** Figure 13: an open book whose pages are windows to a world that one enters. */
export const WORLD_IN_THE_BOOK: Recipe = {
  folder: 'the-world-in-the-book',
  figure: '13',
  title: 'The world in the book',
  description:
    'An open book lies on a lectern; hold a real one there. A leaf turns, and its pages are windows to a valley at night, drawn as a cartoon under its own moon. Walk closer: the light of your room becomes that of the night, and a window opens from the spine until you are inside.',
  nodes: {
    paper: ['source/model', 0, 0, { model: 'pages-13' }],
    lie: ['objects/transform', 1, 0, LYING],
    panes: ['source/model', 0, 1, { model: 'panes-13' }],
    set: ['objects/transform', 1, 1, LYING],
    block: ['objects/primitive', 0, 4, { shape: 'box', sizeM: [2 * PAGE.widthM - 0.02, 0.024, PAGE.heightM - 0.02] }],
    under: ['objects/transform', 1, 4, { positionM: [0, -0.015, 0] }],
    held: ['objects/transform', 2, 4, LYING],
    wood: ['source/model', 0, 2, { model: 'lectern-13' }],
    stand: ['objects/transform', 1, 2, { positionM: BOOK_AT }],
    plane: ['objects/primitive', 0, 3, { shape: 'plane', sizeM: [5, 0, 4.6] }],
    board: ['objects/primitive', 1, 3, { shape: 'box', sizeM: [TABLE.widthM, TABLE.thickM, TABLE.depthM] }],
    lay: ['objects/transform', 2, 3, { positionM: [TABLE.x, TABLE.topM - TABLE.thickM / 2, TABLE.z] }],
    real: ['objects/phantom', 3, 1],
    sun: ['light/directional', 2, 2, { ...WINDOW_LIGHT, elevationRad: 0.85 }],
    reading: ['layer/scene', 4, 0, { ambient: 0.45 }],
    shadow: ['layer/shadow', 4, 1, { strength: 0.5, method: 'map' }],

    head: ['input/head', 0, 5],
    middle: ['pose/from-values', 0, 6, { positionM: BOOK_AT }],
    away: ['pose/distance', 1, 5],
    kelvin: [
      'value/remap',
      2,
      4,
      {
        fromLow: NEARING.light.nearM,
        fromHigh: NEARING.light.farM,
        toLow: NEARING.light.nearK,
        toHigh: NEARING.light.farK,
        curve: 'smooth',
      },
    ],
    opening: [
      'value/remap',
      2,
      5,
      {
        fromLow: NEARING.window.nearM,
        fromHigh: NEARING.window.farM,
        toLow: NEARING.window.nearSize,
        toHigh: NEARING.window.farSize,
        curve: 'smooth',
      },
    ],

    whole: ['objects/primitive', 2, 7, { shape: 'plane', sizeM: [2 * PAGE.widthM, 0, PAGE.heightM] }],
    grow: ['objects/transform', 3, 7],
    rise: ['objects/transform', 4, 7, { positionM: [0, 0.003, 0] }],
    front: ['objects/transform', 5, 7, LYING],
    windows: ['objects/group', 4, 6],
    inside: ['layer/object-mask', 5, 6],

    land: ['source/model', 0, 8, { model: 'valley-13' }],
    calf: ['source/model', 0, 9, { model: 'elephant-02' }],
    stroll: ['objects/transform', 1, 9, { positionM: [-0.62, 0, -1.9], rotationRad: [0, 0.9, 0], scale: 0.5 }],
    toon: ['technique/toon', 1, 10],
    drawn: ['objects/apply-technique', 2, 8],
    far: ['objects/transform', 3, 8, WORLD],
    stars: ['source/model', 2, 9, { model: 'night-13' }],
    sky: ['objects/transform', 3, 9, WORLD],
    moon: ['light/directional', 3, 10, { azimuthRad: -0.9, elevationRad: 0.62, color: [0.72, 0.82, 1, 1], intensity: 0.75 }],
    world: ['layer/scene', 5, 8, { ambient: 0.16 }],

    video: ['source/camera-video', 4, 3],
    cast: ['operator/over', 5, 2],
    open: ['operator/over', 6, 1],
    night: ['filter/color-temperature', 7, 2],
    enter: ['operator/choose-by-mask', 8, 4],
    screen: ['output/screen', 9, 4],
  },
  wires: [
    'paper.objects -> lie.objects',
    'panes.objects -> set.objects',
    'block.objects -> under.objects',
    'under.objects -> held.objects',
    'held.objects -> real.objects',
    'wood.objects -> stand.objects',
    'board.objects -> lay.objects',
    'plane.objects -> real.objects',
    'lay.objects -> real.objects',
    'lie.objects -> reading.objects',
    'set.objects -> reading.objects',
    'stand.objects -> reading.objects',
    'real.objects -> reading.objects',
    'sun.lights -> reading.lights',
    'lie.objects -> shadow.casters',
    'set.objects -> shadow.casters',
    'stand.objects -> shadow.casters',
    'real.objects -> shadow.receivers',
    'sun.lights -> shadow.lights',

    'head.pose -> away.from',
    'middle.pose -> away.to',
    'away.distanceM -> kelvin.number',
    'away.distanceM -> opening.number',

    'whole.objects -> grow.objects',
    'opening.result -> grow.scale',
    'grow.objects -> rise.objects',
    'rise.objects -> front.objects',
    'set.objects -> windows.objects',
    'front.objects -> windows.objects',
    'windows.objects -> inside.objects',
    'lie.objects -> inside.hiders',

    'land.objects -> drawn.objects',
    'calf.objects -> stroll.objects',
    'stroll.objects -> drawn.objects',
    'toon.technique -> drawn.technique',
    'drawn.objects -> far.objects',
    'stars.objects -> sky.objects',
    'far.objects -> world.objects',
    'sky.objects -> world.objects',
    'moon.lights -> world.lights',

    'video.layer -> cast.bottom',
    'shadow.layer -> cast.top',
    'cast.layer -> open.bottom',
    'reading.layer -> open.top',
    'open.layer -> night.inputImage',
    'kelvin.result -> night.temperature',
    'world.layer -> enter.inside',
    'night.layer -> enter.outside',
    'inside.layer -> enter.mask',
    'enter.layer -> screen.layer',
  ],
  assets: BOOK,
};
