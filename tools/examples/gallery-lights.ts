import type { GalleryBuilder } from './gallery-builder.ts';
import { cellMiddleM, moved, type Place, RAIL_M } from './gallery-place.ts';

/** Size of a matte plate that receives light, and its distance behind the center of a cell, in meters. */
const PLATE_M = [0.118, 0.118, 0.006];
const BEHIND_M = 0.045;
/** Range of lights, so that they light only their own cell. */
const REACH_M = 0.17;

/** Positions of the pegs around the bulb, relative to the center of its cell, in meters. */
export const PEGS: readonly (readonly [right: number, up: number])[] = [
  [0, 0.03],
  [-0.026, -0.015],
  [0.026, -0.015],
];
/**
 * Intensity of the bulb: mean, amplitude and angular speed. three.js treats distances below 0.1 m as 0.1 m, where 0.03 cd make white paper
 * white.
 */
export const SWELL = { middleCd: 0.03, byCd: 0.015, radPerS: 2 } as const;

/** Adds a layer with two cells: a bulb that brightens and dims between three pegs, and a spot light on a ball that casts a shadow. */
export function addLamps(wall: GalleryBuilder, row: number, columns: readonly [point: number, spot: number]): void {
  const [point, spot] = columns.map((column) => cellMiddleM(row, column)) as [Place, Place];
  wall.into('lamps');
  addPlate(wall, 'bulb', point, 0);
  PEGS.forEach(([right, up], i) => {
    const sizeM = [0.018, 0.018, 0.018];
    addThing(wall, `peg-${i + 1}`, moved(point, right, up, 0.01 - BEHIND_M), i + 1, { shape: 'sphere', sizeM, roughness: 1 });
  });
  wall.add('time-bulb', 'value/time', { x: 540, y: 0 });
  wall.add(
    'swell-bulb',
    'value/expression',
    { x: 540, y: 250 },
    { expression: `${SWELL.middleCd} + ${SWELL.byCd} * sin(a * ${SWELL.radPerS})` },
  );
  wall.wire('time-bulb.seconds -> swell-bulb.a');
  wall.add(
    'point-bulb',
    'light/point',
    { x: 540, y: 500 },
    {
      color: [1, 0.72, 0.4, 1],
      positionM: [...moved(point, 0, 0, 0.03 - BEHIND_M)],
      rangeM: REACH_M,
      mapSize: '512',
    },
  );
  wall.wire('swell-bulb.result -> point-bulb.intensityCd');
  addPlate(wall, 'stage', spot, 5);
  addThing(wall, 'ball', moved(spot, -0.008, -0.01, -0.012), 6, { shape: 'sphere', sizeM: [0.034, 0.034, 0.034], roughness: 1 });
  wall.add(
    'spot-stage',
    'light/spot',
    { x: 540, y: 1250 },
    {
      color: [0.65, 0.85, 1, 1],
      intensityCd: 0.05,
      positionM: [...moved(spot, -0.04, 0.05, 0.09)],
      targetM: [...moved(spot, 0, 0, -BEHIND_M)],
      angleRad: 0.6,
      penumbra: 0.4,
      mapSize: '512',
      rangeM: REACH_M * 1.5,
    },
  );
  addScene(wall, ['plate-bulb', ...PEGS.map((_, i) => `peg-${i + 1}`), 'plate-stage', 'ball'], ['point-bulb', 'spot-stage'], {
    ambient: 0.05,
  });
  wall.frame('Point light: a bulb that brightens and dims', { x: -30, y: -60, width: 840, height: 1270 });
  wall.frame('Spot light: a cone and a shadow', { x: -30, y: 1190, width: 840, height: 620 });
}

/** Adds a layer with two cells in the evening light of a rotating panorama: a ball of chalk and a mirror ball. */
export function addSky(wall: GalleryBuilder, row: number, columns: readonly [matt: number, mirror: number]): void {
  const [matt, mirror] = columns.map((column) => cellMiddleM(row, column)) as [Place, Place];
  const sizeM = [RAIL_M, RAIL_M, RAIL_M];
  wall.into('sky');
  wall.add('time-sky', 'value/time', { x: 0, y: 600 }, { loopS: 8 });
  wall.add('turn-sky', 'value/expression', { x: 270, y: 600 }, { expression: 'pi * (1 - a / 4)' });
  wall.add('panorama-sky', 'source/panorama', { x: 540, y: 600 }, { file: 'sky' });
  wall.add('light-sky', 'light/environment', { x: 810, y: 600 });
  wall.wire('time-sky.seconds -> turn-sky.a');
  wall.wire('turn-sky.result -> panorama-sky.rotationRad');
  wall.wire('panorama-sky.environment -> light-sky.environment');
  addThing(wall, 'matt', matt, 0, { shape: 'sphere', sizeM, roughness: 1, color: [0.95, 0.95, 0.95, 1] });
  addThing(wall, 'mirror', mirror, 1, { shape: 'sphere', sizeM, roughness: 0.05, metalness: 1, color: [1, 1, 1, 1] });
  addScene(wall, ['matt', 'mirror'], ['light-sky'], { shadows: false });
  wall.frame('Environment light and panorama: the same light on chalk and in a mirror', { x: -30, y: -60, width: 1120, height: 1000 });
}

function addPlate(wall: GalleryBuilder, name: string, middleM: Place, line: number): void {
  addThing(wall, `plate-${name}`, moved(middleM, 0, 0, -BEHIND_M), line, { sizeM: PLATE_M, color: [0.75, 0.75, 0.75, 1], roughness: 1 });
}

type Params = Parameters<GalleryBuilder['add']>[3];

/** Adds a shape at a position. `place-NAME.objects` outputs it. */
export function addThing(wall: GalleryBuilder, name: string, positionM: Place, line: number, params: Params): void {
  wall.add(`shape-${name}`, 'objects/primitive', { x: 0, y: line * 250 }, params);
  wall.add(`place-${name}`, 'objects/transform', { x: 270, y: line * 250 }, { positionM: [...positionM] });
  wall.wire(`shape-${name}.objects -> place-${name}.objects`);
}

export function addScene(wall: GalleryBuilder, things: readonly string[], lights: readonly string[], params: Params): void {
  wall.add('scene-all', 'layer/scene', { x: 1170, y: 0 }, params);
  for (const thing of things) wall.wire(`place-${thing}.objects -> scene-all.objects`);
  for (const light of lights) wall.wire(`${light}.lights -> scene-all.lights`);
  wall.show('outputs', 'layer', 'scene-all.layer');
}
