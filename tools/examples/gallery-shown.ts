import type { GalleryBuilder } from './gallery-builder.ts';
import { RAIL_M } from './gallery-place.ts';

/** Names of the subgraphs that show a cell, by the kind in `Cell.shows`. */
export const SHOWN_BY = { height: 'ball-on-rail', place: 'ball', color: 'box', things: 'set' } as const;

/**
 * Adds the subgraphs that show a height, a position, a color or objects in a cell. Inside, one unit is the height of a rail; the node
 * `cell-one` scales and moves the objects to the cell.
 */
export function addShown(wall: GalleryBuilder): void {
  addBallOnRail(wall);
  addBall(wall);
  addBox(wall);
  addThing(wall);
}

function addBallOnRail(wall: GalleryBuilder): void {
  wall.into(SHOWN_BY.height);
  wall.add('lift-one', 'value/make-vector3', { x: 0, y: 200 });
  wall.add('ball-one', 'objects/primitive', { x: 0, y: 0 }, { shape: 'sphere', sizeM: [0.24, 0.24, 0.24], roughness: 1 });
  wall.add('move-one', 'objects/transform', { x: 270, y: 0 });
  wall.add('rail-one', 'objects/primitive', { x: 0, y: 400 }, { sizeM: [0.05, 1, 0.05], color: [0.2, 0.21, 0.24, 1], roughness: 1 });
  wall.add('upright-one', 'objects/transform', { x: 270, y: 400 }, { positionM: [0, 0.5, 0] });
  wall.add('cell-one', 'objects/transform', { x: 540, y: 0 }, { scale: RAIL_M });
  wall.wire('lift-one.vector -> move-one.positionM');
  wall.wire('ball-one.objects -> move-one.objects');
  wall.wire('rail-one.objects -> upright-one.objects');
  wall.wire('move-one.objects -> cell-one.objects');
  wall.wire('upright-one.objects -> cell-one.objects');
  wall.show('inputs', 'height', 'lift-one.y');
  wall.show('inputs', 'color', 'ball-one.color');
  wall.show('inputs', 'footM', 'cell-one.positionM');
  wall.show('outputs', 'objects', 'cell-one.objects');
}

function addBall(wall: GalleryBuilder): void {
  wall.into(SHOWN_BY.place);
  wall.add('ball-one', 'objects/primitive', { x: 0, y: 0 }, { shape: 'sphere', sizeM: [0.24, 0.24, 0.24], roughness: 1 });
  wall.add('move-one', 'objects/transform', { x: 270, y: 0 });
  wall.wire('ball-one.objects -> move-one.objects');
  placeInMiddle(wall, 'move-one', 540);
  wall.show('inputs', 'place', 'move-one.positionM');
  wall.show('inputs', 'color', 'ball-one.color');
}

function addBox(wall: GalleryBuilder): void {
  wall.into(SHOWN_BY.color);
  wall.add('box-one', 'objects/primitive', { x: 0, y: 0 }, { sizeM: [0.7, 0.7, 0.7], roughness: 1 });
  placeInMiddle(wall, 'box-one', 270);
  wall.show('inputs', 'color', 'box-one.color');
}

function addThing(wall: GalleryBuilder): void {
  wall.into(SHOWN_BY.things);
  wall.add('all-one', 'objects/group', { x: 0, y: 0 });
  placeInMiddle(wall, 'all-one', 270);
  wall.show('inputs', 'things', 'all-one.objects');
}

function placeInMiddle(wall: GalleryBuilder, node: string, x: number): void {
  wall.add('middle-one', 'objects/transform', { x, y: 0 }, { positionM: [0, 0.5, 0] });
  wall.add('cell-one', 'objects/transform', { x: x + 270, y: 0 }, { scale: RAIL_M });
  wall.wire(`${node}.objects -> middle-one.objects`);
  wall.wire('middle-one.objects -> cell-one.objects');
  wall.show('inputs', 'footM', 'cell-one.positionM');
  wall.show('outputs', 'objects', 'cell-one.objects');
}
