import type { GalleryBuilder } from './gallery-builder.ts';
import { type Cell, type Section, SIGNAL_WIRES, SIGNALS } from './gallery-cells.ts';
import { cellFootM, cellKey } from './gallery-place.ts';
import { SHOWN_BY } from './gallery-shown.ts';

/** Colors of the balls by row. */
const COLORS = [
  [0.95, 0.75, 0.3, 1],
  [0.45, 0.8, 0.55, 1],
  [0.5, 0.7, 0.95, 1],
  [0.85, 0.6, 0.9, 1],
  [0.95, 0.55, 0.45, 1],
  [0.4, 0.85, 0.85, 1],
  [0.9, 0.85, 0.6, 1],
] as const;

/**
 * Distances on the canvas, in canvas units: between cells (`x`, `y`), and between columns (`node`) and rows (`line`) of nodes in a cell;
 * and the number of cells per row. The last column of nodes in a cell holds the subgraph that shows it.
 */
const CELL_PX = { x: 1150, y: 860, node: 270, line: 250, columns: 3 } as const;

/** Adds a subgraph that outputs the objects of its cells. The shared signals that these use are to the left of the cells. */
export function addSection(wall: GalleryBuilder, { name, row, column, cells }: Section): void {
  wall.into(name);
  const signals = signalsOf(cells);
  signals.forEach((signal, i) => {
    const [type, params] = SIGNALS[signal] ?? ['value/time'];
    wall.add(`${signal}-all`, type, { x: -CELL_PX.node * 1.5, y: i * CELL_PX.line }, params);
  });
  for (const wire of SIGNAL_WIRES) {
    if (namesIn(wire).every((signal) => signals.includes(signal))) wall.wire(wire.replace(/(\w+)\./g, '$1-all.'));
  }
  wall.add('section-all', 'objects/group', { x: CELL_PX.x * Math.min(cells.length, CELL_PX.columns), y: 0 });
  cells.forEach((cell, i) => {
    const at = { x: (i % CELL_PX.columns) * CELL_PX.x, y: Math.floor(i / CELL_PX.columns) * CELL_PX.y };
    wall.wire(`${addCell(wall, cell, row, column + i, at)} -> section-all.objects`);
  });
  wall.show('outputs', 'objects', 'section-all.objects');
}

/** Names of the shared signals that the cells use, directly or through another signal. */
function signalsOf(cells: readonly Cell[]): string[] {
  const named = new Set(
    cells.flatMap(({ nodes, wires, shows: [, shown] }) => [...wires, shown].flatMap(namesIn).filter((name) => !Object.hasOwn(nodes, name))),
  );
  for (const wire of SIGNAL_WIRES) {
    const [from = '', to = ''] = namesIn(wire);
    if (named.has(to)) named.add(from);
  }
  return Object.keys(SIGNALS).filter((signal) => named.has(signal));
}

function namesIn(wire: string): string[] {
  return [...wire.matchAll(/(\w+)\./g)].map(([, name = '']) => name);
}

/** Adds a cell. Returns the output with its objects. */
function addCell(
  wall: GalleryBuilder,
  cell: Cell,
  row: number,
  column: number,
  { x, y }: { readonly x: number; readonly y: number },
): string {
  const key = cellKey(row, column);
  const idOf = (name: string): string => `${name}-${Object.hasOwn(cell.nodes, name) ? key : 'all'}`;
  const outputOf = (output: string): string => output.replace(/^\w+/, idOf);
  Object.entries(cell.nodes).forEach(([name, [type, params]], i) => {
    wall.add(idOf(name), type, { x: x + (i % 3) * CELL_PX.node, y: y + Math.floor(i / 3) * CELL_PX.line }, params);
  });
  for (const wire of cell.wires) wall.wire(wire.split(' -> ').map(outputOf).join(' -> '));
  const [kind, output] = cell.shows;
  const footM = [...cellFootM(row, column)];
  const color = COLORS[row] ?? COLORS[0];
  const params = kind === 'height' || kind === 'place' ? { footM, color: [...color] } : { footM };
  wall.add(`shown-${key}`, `graph/${SHOWN_BY[kind]}`, { x: x + 3 * CELL_PX.node, y }, params);
  wall.wire(`${outputOf(output)} -> shown-${key}.${kind}`);
  wall.frame(cell.title, { x: x - 30, y: y - 60, width: 4 * CELL_PX.node, height: CELL_PX.y - 80 });
  return `shown-${key}.objects`;
}
