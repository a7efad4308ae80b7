import { addNode } from '../../export/graph/commands/nodes.ts';
import { connect } from '../../export/graph/commands/wires.ts';
import { newProject } from '../../export/graph/new-project.ts';
import { type Frame, MAIN_GRAPH, type NodeLayout, type ParamValue, type Project } from '../../export/graph/project.ts';
import { parseWire } from '../../export/graph/wires.ts';
import type { NodeLibrary } from '../../nodes/kit/definition.ts';
import { formatDiagnostic, hasErrors } from '../../nodes/kit/diagnostics.ts';
import { type Cell, ROWS, SIGNAL_WIRES, SIGNALS } from './gallery-cells.ts';

/** Height of a rail, and from cell to cell, metres. */
const RAIL_M = 0.2;
const PITCH_M = 0.32;
/** Foot of the rails of the lowest row, and the middle of the wall. */
const FOOT_M = 0.2;

/** In heights of a rail. */
const BALL = 0.2;
const RAIL = [0.05, 1, 0.05] as const;
const BOX = [0.5, 0.5, 0.5] as const;

/** Of the balls, row by row. */
const COLORS = [
  [0.95, 0.75, 0.3, 1],
  [0.45, 0.8, 0.55, 1],
  [0.5, 0.7, 0.95, 1],
  [0.85, 0.6, 0.9, 1],
  [0.95, 0.55, 0.45, 1],
] as const;

/** Between nodes, and between cells, on the canvas. */
const NODE_PX = { x: 380, y: 290 } as const;
const CELL_PX = { x: 1640, y: 780 } as const;
const FRAME_PX = { left: 30, top: 60 } as const;

/** Name of a cell: its row as a letter and its column from 1. Node ids end with it. */
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
  const wall = createBuilder(library, 'Gallery of values, pulses and controls');
  const placeSignals = (): void => {
    wall.begin('Signals', -1, 0);
    for (const [name, [type, params]] of Object.entries(SIGNALS)) wall.add(`${name}-all`, type, params);
    for (const wire of SIGNAL_WIRES) wall.wire(wire.replace(/(\w+)\./g, '$1-all.'));
    wall.add('rail-all', 'objects/primitive', { sizeM: [...RAIL], color: [0.2, 0.21, 0.24, 1], roughness: 1 });
    wall.add('upright-all', 'objects/transform', { positionM: [0, 0.5, 0] });
    wall.wire('rail-all.objects -> upright-all.objects');
    wall.end();
  };
  placeSignals();
  wall.begin('Picture', -1, 1);
  wall.add('scene-all', 'layer/scene', { ambient: 0.8, shadows: false });
  wall.add('sun-all', 'light/directional', { intensity: 0.6 });
  wall.add('screen-all', 'output/screen');
  wall.wire('sun-all.lights -> scene-all.lights');
  wall.wire('scene-all.layer -> screen-all.layer');
  wall.end();
  ROWS.forEach((cells, row) => {
    cells.forEach((cell, column) => {
      placeCell(wall, cell, row, column);
    });
  });
  return wall.finish();
}

function placeCell(wall: Builder, cell: Cell, row: number, column: number): void {
  const key = cellKey(row, column);
  const idOf = (name: string): string => `${name}-${Object.hasOwn(cell.nodes, name) ? key : 'all'}`;
  const outputOf = (output: string): string => output.replace(/^\w+/, idOf);
  wall.begin(cell.title, row, column);
  for (const [name, [type, params]] of Object.entries(cell.nodes)) wall.add(idOf(name), type, params);
  for (const wire of cell.wires) wall.wire(wire.split(' -> ').map(outputOf).join(' -> '));
  const [kind, output] = cell.shows;
  const from = outputOf(output);
  const color = COLORS[row % COLORS.length] ?? COLORS[0];
  const isBox = kind === 'color';
  wall.add(`thing-${key}`, 'objects/primitive', {
    shape: isBox ? 'box' : 'sphere',
    sizeM: isBox ? [...BOX] : [BALL, BALL, BALL],
    roughness: 1,
    ...(isBox ? {} : { color: [...color] }),
  });
  wall.add(`move-${key}`, 'objects/transform', isBox ? { positionM: [0, 0.5, 0] } : {});
  const [x, y, z] = cellFootM(row, column);
  wall.add(`cell-${key}`, 'objects/transform', { positionM: [x, round(kind === 'place' ? y + RAIL_M / 2 : y), z], scale: RAIL_M });
  if (kind === 'color') wall.wire(`${from} -> thing-${key}.color`);
  if (kind === 'place') wall.wire(`${from} -> move-${key}.positionM`);
  if (kind === 'height') {
    wall.add(`lift-${key}`, 'value/make-vector3');
    wall.wire(`${from} -> lift-${key}.y`);
    wall.wire(`lift-${key}.vector -> move-${key}.positionM`);
    wall.wire(`upright-all.objects -> cell-${key}.objects`);
  }
  wall.wire(`thing-${key}.objects -> move-${key}.objects`);
  wall.wire(`move-${key}.objects -> cell-${key}.objects`);
  wall.wire(`cell-${key}.objects -> scene-all.objects`);
  wall.end();
}

type Builder = ReturnType<typeof createBuilder>;

/** Adds nodes cell by cell; each cell is a frame on the canvas, its nodes in lines of four. */
function createBuilder(library: NodeLibrary, title: string) {
  let project = newProject(title);
  const places: Record<string, NodeLayout> = {};
  const frames: Record<string, Frame> = {};
  let current = { title: '', x: 0, y: 0, ids: [] as string[] };
  const apply = ({ project: next, diagnostics }: ReturnType<typeof addNode>): void => {
    if (hasErrors(diagnostics)) throw new Error(diagnostics.map(formatDiagnostic).join(' '));
    project = next;
  };
  return {
    begin: (cellTitle: string, row: number, column: number): void => {
      current = { title: cellTitle, x: column * CELL_PX.x, y: row * CELL_PX.y, ids: [] };
    },
    add: (id: string, type: string, params: Readonly<Record<string, ParamValue>> = {}): void => {
      current.ids.push(id);
      apply(addNode(project, { library, graph: MAIN_GRAPH, id, type, x: 0, y: 0, params }));
    },
    wire: (text: string): void => {
      const wire = parseWire(text);
      if (!wire) throw new Error(`${text} is no wire.`);
      apply(connect(project, { library, graph: MAIN_GRAPH, ...wire }));
    },
    end: (): void => {
      const { x, y, ids } = current;
      const columns = Math.min(ids.length, 4);
      ids.forEach((id, i) => {
        places[id] = { x: x + (i % 4) * NODE_PX.x, y: y + Math.floor(i / 4) * NODE_PX.y };
      });
      frames[`frame-${Object.keys(frames).length + 1}`] = {
        x: x - FRAME_PX.left,
        y: y - FRAME_PX.top,
        width: columns * NODE_PX.x,
        height: Math.ceil(ids.length / 4) * NODE_PX.y + FRAME_PX.top,
        title: current.title,
      };
    },
    finish: (): Project => ({ ...project, layout: { [MAIN_GRAPH]: { nodes: places, frames, notes: {} } } }),
  };
}

/** So that positions are written in few digits. */
function round(metres: number): number {
  return Math.round(metres * 1000) / 1000;
}
