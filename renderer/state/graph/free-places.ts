import type { Change } from '../../../export/graph/commands/change.ts';
import { moveNodes } from '../../../export/graph/commands/layout-commands.ts';
import type { Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import { HEADER_HEIGHT, NODE_WIDTH, nodeShape, THUMBNAIL_HEIGHT } from './node-shape.ts';

interface Box {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** Distance between nodes, in canvas units. */
const GAP = 24;
/** Grid of the canvas, in canvas units. */
const GRID = 8;

/**
 * Moves the nodes that `before` does not have down until they cover no other node. Nodes of `before` stay where they are.
 *
 * @param context `hasThumbnail`: whether nodes show thumbnails, which makes them higher.
 */
export function placeFreely(
  before: Project,
  context: { library: NodeLibrary; graph: string; hasThumbnail: boolean },
): (project: Project) => Change {
  const { library, graph, hasThumbnail } = context;
  const known = before.graphs[graph]?.nodes ?? {};
  return (project) => {
    const { nodes = {}, wires = [] } = project.graphs[graph] ?? {};
    const layout = project.layout[graph]?.nodes ?? {};
    const boxOf = (id: string): Box => {
      const { x = 0, y = 0, collapsed = false } = getOwn(layout, id) ?? {};
      const node = nodes[id];
      const definition = node && library.definition(node.type);
      if (!node || !definition) return { x, y, width: NODE_WIDTH, height: HEADER_HEIGHT };
      const wired = new Set(wires.flatMap(({ to }) => (to.node === id ? [to.port] : [])));
      const { width, height } = nodeShape(definition, node, {
        wired,
        expanded: false,
        collapsed,
        thumbnailHeight: hasThumbnail ? THUMBNAIL_HEIGHT : 0,
      });
      return { x, y, width, height };
    };
    const ids = Object.keys(nodes);
    const placed = ids.filter((id) => Object.hasOwn(known, id)).map(boxOf);
    const positions: Record<string, { x: number; y: number }> = {};
    for (const id of ids) {
      if (Object.hasOwn(known, id)) continue;
      const box = below(boxOf(id), placed);
      placed.push(box);
      positions[id] = { x: box.x, y: box.y };
    }
    return moveNodes(project, { graph, positions });
  };
}

/** The box, moved down until it covers none of the others. */
function below(box: Box, others: readonly Box[]): Box {
  let free = box;
  // Each step passes at least one box for good, because boxes are only left behind.
  for (;;) {
    const covered = others.filter((other) => overlaps(free, other));
    if (covered.length === 0) return free;
    const bottom = Math.max(...covered.map(({ y, height }) => y + height));
    free = { ...free, y: Math.ceil((bottom + GAP) / GRID) * GRID };
  }
}

function overlaps(a: Box, b: Box): boolean {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}
