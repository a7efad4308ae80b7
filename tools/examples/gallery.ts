import { MAIN_GRAPH, type Project } from '../../export/graph/project.ts';
import type { NodeLibrary } from '../../nodes/kit/definition.ts';
import { createGalleryBuilder, type GalleryBuilder } from './gallery-builder.ts';
import { type Cell, ROWS, SIGNAL_WIRES, SIGNALS } from './gallery-cells.ts';

/** Height of a rail, and from cell to cell, metres. */
export const RAIL_M = 0.14;
const PITCH_M = 0.22;
/** Foot of the rails of the lowest row. */
const FOOT_M = 0.35;

/** Of the balls, row by row. */
const COLORS = [
  [0.95, 0.75, 0.3, 1],
  [0.45, 0.8, 0.55, 1],
  [0.5, 0.7, 0.95, 1],
  [0.85, 0.6, 0.9, 1],
  [0.95, 0.55, 0.45, 1],
] as const;

/** From cell to cell on the canvas; the last column of a cell holds what shows it. */
const CELL_PX = { x: 1150, y: 640, node: 270, line: 250 } as const;

/** The subgraph that shows a cell, by what it shows. */
const SHOWN_BY = { height: 'ball-on-rail', place: 'ball', color: 'box' } as const;

/** Name of a cell: its row as a letter and its column from 1. Ids of its nodes end with it. */
export function cellKey(row: number, column: number): string {
  return `${'abcdefgh'[row]}${column + 1}`;
}

/** Where the foot of a cell's rail stands. */
export function cellFootM(row: number, column: number): readonly [number, number, number] {
  const columns = Math.max(...ROWS.map((cells) => cells.length));
  return [round((column - (columns - 1) / 2) * PITCH_M), round(FOOT_M + (ROWS.length - 1 - row) * PITCH_M), 0];
}

/** A wall of cells, each showing what one node type does: by the height of a ball, by its place, or by a colour. */
export function makeGallery(library: NodeLibrary): Project {
  const wall = createGalleryBuilder(library, 'Gallery of values, pulses and controls');
  addBallOnRail(wall);
  addBall(wall);
  addBox(wall);
  wall.into(MAIN_GRAPH);
  Object.entries(SIGNALS).forEach(([name, [type, params]], i) => {
    wall.add(`${name}-all`, type, { x: -CELL_PX.node * 2, y: i * CELL_PX.line }, params);
  });
  for (const wire of SIGNAL_WIRES) wall.wire(wire.replace(/(\w+)\./g, '$1-all.'));
  const right = CELL_PX.x * Math.max(...ROWS.map((cells) => cells.length));
  wall.add('scene-all', 'layer/scene', { x: right + CELL_PX.node, y: 0 }, { ambient: 0.8, shadows: false });
  wall.add('sun-all', 'light/directional', { x: right, y: -CELL_PX.line }, { intensity: 0.6 });
  wall.add('screen-all', 'output/screen', { x: right + 2 * CELL_PX.node, y: 0 });
  wall.wire('sun-all.lights -> scene-all.lights');
  wall.wire('scene-all.layer -> screen-all.layer');
  ROWS.forEach((cells, row) => {
    const group = `row-${'abcdefgh'[row]}`;
    wall.add(group, 'objects/group', { x: right, y: row * CELL_PX.y });
    cells.forEach((cell, column) => {
      wall.wire(`${placeCell(wall, cell, row, column)} -> ${group}.objects`);
    });
    wall.wire(`${group}.objects -> scene-all.objects`);
  });
  return wall.finish();
}

/** Gives the output with its objects. */
function placeCell(wall: GalleryBuilder, cell: Cell, row: number, column: number): string {
  const key = cellKey(row, column);
  const [x, y] = [column * CELL_PX.x, row * CELL_PX.y];
  const idOf = (name: string): string => `${name}-${Object.hasOwn(cell.nodes, name) ? key : 'all'}`;
  const outputOf = (output: string): string => output.replace(/^\w+/, idOf);
  Object.entries(cell.nodes).forEach(([name, [type, params]], i) => {
    wall.add(idOf(name), type, { x: x + (i % 3) * CELL_PX.node, y: y + Math.floor(i / 3) * CELL_PX.line }, params);
  });
  for (const wire of cell.wires) wall.wire(wire.split(' -> ').map(outputOf).join(' -> '));
  const [kind, output] = cell.shows;
  const color = COLORS[row % COLORS.length] ?? COLORS[0];
  const footM = [...cellFootM(row, column)];
  wall.add(
    `shown-${key}`,
    `graph/${SHOWN_BY[kind]}`,
    { x: x + 3 * CELL_PX.node, y },
    kind === 'color' ? { footM } : { footM, color: [...color] },
  );
  wall.wire(`${outputOf(output)} -> shown-${key}.${kind}`);
  wall.frame(cell.title, { x: x - 30, y: y - 60, width: 4 * CELL_PX.node, height: CELL_PX.y - 80 });
  return `shown-${key}.objects`;
}

/** In heights of a rail: `cell` sizes them and puts them where they belong. */
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
  wall.add('middle-one', 'objects/transform', { x: 540, y: 0 }, { positionM: [0, 0.5, 0] });
  wall.add('cell-one', 'objects/transform', { x: 810, y: 0 }, { scale: RAIL_M });
  wall.wire('ball-one.objects -> move-one.objects');
  wall.wire('move-one.objects -> middle-one.objects');
  wall.wire('middle-one.objects -> cell-one.objects');
  wall.show('inputs', 'place', 'move-one.positionM');
  wall.show('inputs', 'color', 'ball-one.color');
  wall.show('inputs', 'footM', 'cell-one.positionM');
  wall.show('outputs', 'objects', 'cell-one.objects');
}

function addBox(wall: GalleryBuilder): void {
  wall.into(SHOWN_BY.color);
  wall.add('box-one', 'objects/primitive', { x: 0, y: 0 }, { sizeM: [0.7, 0.7, 0.7], roughness: 1 });
  wall.add('middle-one', 'objects/transform', { x: 270, y: 0 }, { positionM: [0, 0.5, 0] });
  wall.add('cell-one', 'objects/transform', { x: 540, y: 0 }, { scale: RAIL_M });
  wall.wire('box-one.objects -> middle-one.objects');
  wall.wire('middle-one.objects -> cell-one.objects');
  wall.show('inputs', 'color', 'box-one.color');
  wall.show('inputs', 'footM', 'cell-one.positionM');
  wall.show('outputs', 'objects', 'cell-one.objects');
}

/** So that positions are written in few digits. */
function round(metres: number): number {
  return Math.round(metres * 1000) / 1000;
}
