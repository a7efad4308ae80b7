/** The main graph of a project: node types and positions by id. */
export interface GridGraph {
  readonly nodes: Readonly<Record<string, { readonly type: string }>>;
  readonly wires: readonly string[];
  readonly places: Readonly<Record<string, readonly [x: number, y: number]>>;
}

/** Nodes per column, and distances between them, as in automatic layout. */
export const GRID_ROWS = 25;
const SPACING = { x: 264, y: 120 };
const FILTERS = ['filter/sepia', 'filter/threshold', 'filter/gaussian-blur', 'filter/color-temperature'];

/** Rows of filters that do not affect the screen, beside a camera video that does. */
export function gridGraph(count: number): GridGraph {
  const nodes: Record<string, { type: string }> = {};
  const places: Record<string, [number, number]> = {};
  const wires = ['node-a0.layer -> node-a1.layer'];
  for (let i = 0; i < count; i++) {
    const id = `node-a${i}`;
    nodes[id] = { type: i === 0 ? 'source/camera-video' : i === 1 ? 'output/screen' : (FILTERS[i % FILTERS.length] ?? '') };
    places[id] = [Math.floor(i / GRID_ROWS) * SPACING.x, (i % GRID_ROWS) * SPACING.y];
    const left = i - GRID_ROWS;
    if (left > 1) wires.push(`node-a${left}.layer -> ${id}.inputImage`);
  }
  return { nodes, wires, places };
}

/** A camera video that the screen and so many filters read, in columns below it: all wires begin at one port. */
export function hubGraph(count: number): GridGraph {
  const { nodes, places } = gridGraph(count + 2);
  const wires = Array.from({ length: count }, (_, i) => `node-a0.layer -> node-a${i + 2}.inputImage`);
  return {
    nodes,
    places: { ...places, 'node-a0': [Math.floor(count / GRID_ROWS / 2) * SPACING.x, -2 * SPACING.y] },
    wires: ['node-a0.layer -> node-a1.layer', ...wires],
  };
}
