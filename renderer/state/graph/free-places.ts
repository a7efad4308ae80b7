import { type Change, sequence } from '../../../export/graph/commands/change.ts';
import { moveNodes } from '../../../export/graph/commands/layout-commands.ts';
import { putReroute } from '../../../export/graph/commands/route-commands.ts';
import type { GraphNode, Project } from '../../../export/graph/project.ts';
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

interface FreePlaces {
  readonly library: NodeLibrary;
  readonly graph: string;
  /** Whether nodes show thumbnails, which makes them higher. */
  readonly hasThumbnail: boolean;
}

/** Moves the nodes that `before` does not have down until they cover no other node. Nodes of `before` stay where they are. */
export function placeFreely(before: Project, context: FreePlaces): (project: Project) => Change {
  return (project) => {
    const { known, added } = boxesOf(project, before, context);
    const placed = [...known.values()];
    const positions: Record<string, { x: number; y: number }> = {};
    for (const [id, box] of added) {
      const free = below(box, placed);
      placed.push(free);
      positions[id] = { x: free.x, y: free.y };
    }
    return moveNodes(project, { graph: context.graph, positions });
  };
}

/** As `placeFreely`, but moves all new nodes, and new reroutes, by the same distance, so that they keep their arrangement. */
export function placeTogether(before: Project, context: FreePlaces): (project: Project) => Change {
  const { graph } = context;
  return (project) => {
    const { known, added } = boxesOf(project, before, context);
    const others = [...known.values()];
    let down = 0;
    // Each step passes at least one box for good, as in `below`.
    for (;;) {
      const needed = [...added.values()].flatMap((box) =>
        others.filter((other) => overlaps({ ...box, y: box.y + down }, other)).map((other) => other.y + other.height + GAP - box.y),
      );
      if (needed.length === 0) break;
      down = Math.ceil(Math.max(...needed) / GRID) * GRID;
    }
    const positions = Object.fromEntries([...added].map(([id, { x, y }]) => [id, { x, y: y + down }]));
    const reroutes = Object.entries(project.layout[graph]?.reroutes ?? {}).filter(
      ([id]) => getOwn(before.layout[graph]?.reroutes ?? {}, id) === undefined,
    );
    return sequence(
      project,
      (now) => moveNodes(now, { graph, positions }),
      ...reroutes.map(
        ([id, { x, y }]) =>
          (now: Project) =>
            putReroute(now, { graph, id, reroute: { x, y: y + down } }),
      ),
    );
  };
}

/** What the nodes of a graph cover: those that `before` has, and those that it does not. */
function boxesOf(project: Project, before: Project, { library, graph, hasThumbnail }: FreePlaces) {
  const { nodes = {}, wires = [] } = project.graphs[graph] ?? {};
  const layout = project.layout[graph]?.nodes ?? {};
  const boxOf = (id: string, node: GraphNode): Box => {
    const { x = 0, y = 0, collapsed = false } = getOwn(layout, id) ?? {};
    const definition = library.definition(node.type);
    if (!definition) return { x, y, width: NODE_WIDTH, height: HEADER_HEIGHT };
    const wired = new Set(wires.flatMap(({ to }) => (to.node === id ? [to.port] : [])));
    const { width, height } = nodeShape(definition, node, {
      wired,
      expanded: false,
      collapsed,
      thumbnailHeight: hasThumbnail ? THUMBNAIL_HEIGHT : 0,
    });
    return { x, y, width, height };
  };
  const known = new Map<string, Box>();
  const added = new Map<string, Box>();
  for (const [id, node] of Object.entries(nodes)) {
    const isKnown = getOwn(before.graphs[graph]?.nodes ?? {}, id) !== undefined;
    (isKnown ? known : added).set(id, boxOf(id, node));
  }
  return { known, added };
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

/** Whether two boxes have a part in common. */
export function overlaps(a: Box, b: Box): boolean {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}
