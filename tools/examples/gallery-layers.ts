import type { GalleryBuilder } from './gallery-builder.ts';
import { addThing } from './gallery-lights.ts';
import { cellMiddleM, moved, type Place } from './gallery-place.ts';

/** Options of the control for the blend mode, after the first option `ALL_IN_TURN`. In the order of the modes of `operator/blend`. */
export const BLEND_MODES = [
  'Normal',
  'Multiply',
  'Screen',
  'Overlay',
  'Darken',
  'Lighten',
  'Color dodge',
  'Color burn',
  'Hard light',
  'Soft light',
  'Difference',
  'Exclusion',
  'Hue',
  'Saturation',
  'Color',
  'Luminosity',
  'Plus lighter',
] as const;
const ALL_IN_TURN = 'All in turn';

const RED = [0.85, 0.2, 0.15, 1] as const;
const GREEN = [0.25, 0.7, 0.3, 1] as const;
const BLUE = [0.2, 0.4, 0.9, 1] as const;

/**
 * Adds three balls that move in a circle. A filter removes the color from all but the red one. The object mask of the red ball leaves out
 * where another ball is in front of it.
 */
export function addMask(wall: GalleryBuilder, row: number, column: number): void {
  const middle = cellMiddleM(row, column);
  wall.into('mask');
  wall.add('time-mask', 'value/time', { x: 0, y: 850 });
  wall.add('angles-mask', 'value/make-vector3', { x: 270, y: 850 }, { x: 0.35 });
  wall.wire('time-mask.seconds -> angles-mask.y');
  [RED, GREEN, BLUE].forEach((color, i) => {
    const name = ['red', 'green', 'blue'][i] ?? '';
    const angle = (i * 2 * Math.PI) / 3;
    const at: Place = moved([0, 0, 0], 0.034 * Math.sin(angle), 0, 0.034 * Math.cos(angle));
    addThing(wall, `one-${name}`, at, i, { shape: 'sphere', sizeM: [0.044, 0.044, 0.044], color: [...color], roughness: 0.8 });
    wall.add(`turn-${name}`, 'objects/transform', { x: 540, y: i * 250 }, { positionM: [...middle] });
    wall.wire(`place-one-${name}.objects -> turn-${name}.objects`);
    wall.wire(`angles-mask.vector -> turn-${name}.rotationRad`);
  });
  wall.add('sun-mask', 'light/directional', { x: 540, y: 850 }, { intensity: 0.6 });
  wall.add('scene-mask', 'layer/scene', { x: 810, y: 850 }, { ambient: 0.6, shadows: false });
  wall.add('mask-red', 'layer/object-mask', { x: 810, y: 0 });
  for (const name of ['red', 'green', 'blue']) {
    wall.wire(`turn-${name}.objects -> scene-mask.objects`);
    wall.wire(`turn-${name}.objects -> mask-red.${name === 'red' ? 'objects' : 'hiders'}`);
  }
  wall.wire('sun-mask.lights -> scene-mask.lights');
  wall.add('grey-mask', 'filter/grey', { x: 1080, y: 850 });
  wall.add('only-red', 'operator/mask', { x: 1080, y: 0 });
  wall.add('both-mask', 'operator/over', { x: 1350, y: 0 });
  wall.wire('scene-mask.layer -> grey-mask.inputImage');
  wall.wire('scene-mask.layer -> only-red.inputImage');
  wall.wire('mask-red.layer -> only-red.mask');
  wall.wire('only-red.layer -> both-mask.top');
  wall.wire('grey-mask.layer -> both-mask.bottom');
  wall.show('outputs', 'layer', 'both-mask.layer');
  wall.frame('Object mask: only the red object keeps its color', { x: -30, y: -60, width: 1640, height: 1260 });
}

/** The ball with the trail: radius of its circular path, its diameter, its speed, and the fraction of the trail that remains per frame. */
export const TRAIL = { radiusM: 0.038, ballM: 0.026, turnRadPerS: 2, keep: 0.88 } as const;

/** Adds a ball that moves in a circle over its previous frames. */
export function addTrail(wall: GalleryBuilder, row: number, column: number): void {
  const [x, y, z] = cellMiddleM(row, column);
  wall.into('trail');
  wall.add('time-ball', 'value/time', { x: -540, y: 300 });
  ['cos', 'sin'].forEach((wave, i) => {
    const expression = `${[x, y][i]} + ${TRAIL.radiusM} * ${wave}(a * ${TRAIL.turnRadPerS})`;
    wall.add(`${wave}-ball`, 'value/expression', { x: -270, y: 200 + i * 250 }, { expression });
    wall.wire(`time-ball.seconds -> ${wave}-ball.a`);
  });
  wall.add('where-ball', 'value/make-vector3', { x: 0, y: 300 }, { z });
  wall.wire('cos-ball.result -> where-ball.x');
  wall.wire('sin-ball.result -> where-ball.y');
  addThing(wall, 'ball', [0, 0, 0], 0, {
    shape: 'sphere',
    sizeM: [TRAIL.ballM, TRAIL.ballM, TRAIL.ballM],
    color: [1, 0.85, 0.35, 1],
    roughness: 1,
  });
  wall.wire('where-ball.vector -> place-ball.positionM');
  wall.add('scene-ball', 'layer/scene', { x: 540, y: 0 }, { ambient: 1, shadows: false });
  wall.wire('place-ball.objects -> scene-ball.objects');
  wall.add('before-trail', 'layer/previous-frame', { x: 540, y: 400 });
  // The ball hides the trail behind it.
  wall.add('fade-trail', 'operator/mask', { x: 810, y: 400 }, { source: 1, amount: Math.round(100 * (1 - TRAIL.keep)) / 100 });
  wall.add('over-trail', 'operator/over', { x: 1080, y: 0 });
  wall.wire('before-trail.layer -> fade-trail.inputImage');
  wall.wire('scene-ball.layer -> fade-trail.mask');
  wall.wire('scene-ball.layer -> over-trail.top');
  wall.wire('fade-trail.layer -> over-trail.bottom');
  wall.wire('over-trail.layer -> before-trail.layer');
  wall.show('outputs', 'layer', 'over-trail.layer');
  wall.frame('Feedback: a trail', { x: -570, y: -60, width: 1910, height: 820 });
}

/** Adds a video behind a window in the wall. */
export function addFilm(wall: GalleryBuilder, row: number, column: number): void {
  wall.into('film');
  addThing(wall, 'window', cellMiddleM(row, column, 2), 0, { sizeM: [0.25, 0.12, 0.004] });
  wall.add('mask-window', 'layer/object-mask', { x: 540, y: 0 });
  wall.add('film-one', 'source/video-file', { x: 540, y: 300 }, { file: 'film' });
  wall.add('seen-film', 'operator/mask', { x: 810, y: 0 });
  wall.wire('place-window.objects -> mask-window.objects');
  wall.wire('film-one.layer -> seen-film.inputImage');
  wall.wire('mask-window.layer -> seen-film.mask');
  wall.show('outputs', 'layer', 'seen-film.layer');
  wall.frame('Video file: a video behind a window', { x: -30, y: -60, width: 1100, height: 760 });
}

/** Colors of the strips, from left to right, and of the bars over them, from top to bottom. Each bar crosses each strip. */
const BELOW = [RED, [0.95, 0.8, 0.2, 1], GREEN, BLUE, [0.5, 0.5, 0.5, 1], [0.95, 0.95, 0.95, 1]] as const;
const ABOVE = [
  [0.9, 0.5, 0.2, 1],
  [0.35, 0.35, 0.4, 1],
  [0.3, 0.6, 0.85, 1],
] as const;
/**
 * Distances in meters: between the centers of neighboring strips, and of neighboring bars; and by how much the bars are longer than all
 * strips are wide. The strips extend beyond the bars by half as much.
 */
export const BLEND_FIELD = { stripM: 0.076, barM: 0.034, reachM: 0.03 } as const;

/** Adds bars over strips, blended by the mode that the visitor chooses, or by all modes in turn, one second each. */
export function addBlend(wall: GalleryBuilder, row: number, column: number): void {
  const middle = cellMiddleM(row, column, 4);
  const { stripM, barM, reachM } = BLEND_FIELD;
  const heightM = ABOVE.length * barM;
  const widthM = BELOW.length * stripM;
  wall.into('blend');
  const strips = BELOW.map((color, i) => {
    const name = `strip-${i + 1}`;
    const at = moved(middle, (i - (BELOW.length - 1) / 2) * stripM, 0, 0);
    addThing(wall, name, at, i, { sizeM: [stripM * 0.8, heightM + reachM / 2, 0.002], color: [...color], roughness: 1 });
    return name;
  });
  const bars = ABOVE.map((color, i) => {
    const name = `bar-${i + 1}`;
    const at = moved(middle, 0, ((ABOVE.length - 1) / 2 - i) * barM, 0);
    addThing(wall, name, at, BELOW.length + i, { sizeM: [widthM + reachM, barM * 0.7, 0.002], color: [...color], roughness: 1 });
    return name;
  });
  for (const [name, things, y] of [
    ['strips', strips, 500],
    ['bars', bars, 1500],
  ] as const) {
    wall.add(`scene-${name}`, 'layer/scene', { x: 540, y }, { ambient: 1, shadows: false });
    for (const thing of things) wall.wire(`place-${thing}.objects -> scene-${name}.objects`);
  }
  wall.add('every-mode', 'pulse/every', { x: -60, y: 2400 });
  wall.add('turn-mode', 'value/counter', { x: 210, y: 2400 }, { cycle: BLEND_MODES.length });
  wall.add(
    'choice-mode',
    'input/choice',
    { x: 210, y: 2650 },
    {
      label: 'Blend mode',
      options: [ALL_IN_TURN, ...BLEND_MODES].join(', '),
      place: 5,
    },
  );
  wall.add('pick-mode', 'value/expression', { x: 480, y: 2400 }, { expression: 'a < 0.5 ? b : a - 1' });
  wall.wire('every-mode.pulse -> turn-mode.up');
  wall.wire('choice-mode.index -> pick-mode.a');
  wall.wire('turn-mode.number -> pick-mode.b');
  wall.add('blend-all', 'operator/blend', { x: 810, y: 1000 });
  wall.wire('scene-bars.layer -> blend-all.top');
  wall.wire('scene-strips.layer -> blend-all.bottom');
  wall.wire('pick-mode.result -> blend-all.mode');
  wall.show('outputs', 'layer', 'blend-all.layer');
  wall.frame('Blended layers: strips below, bars above', { x: -30, y: -60, width: 840, height: 2320 });
  wall.frame('Blend mode: chosen by the visitor, or one after the other', { x: -90, y: 2330, width: 840, height: 560 });
}
