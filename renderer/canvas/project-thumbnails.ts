import type { GraphNode, NodeLayout } from '../../export/graph/project.ts';
import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import { layerPortOf } from '../state/editor/layer-names.ts';
import { HEADER_HEIGHT, NODE_WIDTH, nodeShape } from '../state/graph/node-shape.ts';
import { type BareBox, thumbnailHeights } from '../state/graph/thumbnail-heights.ts';
import { sameParts as same, type WiresInput } from './project-wires.ts';

type Input = Pick<WiresInput, 'graph' | 'layout' | 'library'> & {
  readonly expanded: ReadonlySet<string>;
  readonly hasThumbnail?: boolean;
};

/** Names of the connected params of a node, with a text that is equal for equal names. */
export interface WiredParams {
  readonly key: string;
  readonly inputs: ReadonlySet<string>;
}

interface CachedBox {
  readonly key: readonly unknown[];
  readonly box: BareBox;
}

const NONE: ReadonlyMap<string, number> = new Map();

/**
 * Projects the open graph to the heights of its thumbnails. A drag changes them when it ends, so that nodes do not grow and shrink while
 * another one passes.
 */
export function createThumbnailsProjection(): (input: Input, wiredOf: (id: string) => WiredParams) => ReadonlyMap<string, number> {
  let cached = new Map<string, CachedBox>();
  let boxes: readonly BareBox[] = [];
  let frames: Input['layout']['frames'] = {};
  let notes: Input['layout']['notes'] = {};
  let heights = NONE;
  return (input, wiredOf) => {
    if (!input.hasThumbnail) return NONE;
    const { graph, layout, library } = input;
    const next = new Map<string, CachedBox>();
    for (const [id, node] of Object.entries(graph.nodes)) {
      const wired = wiredOf(id);
      const definition = library.definition(node.type);
      const place = layout.nodes[id];
      const expanded = input.expanded.has(id);
      const key = [node, definition, place, wired.key, expanded];
      const known = cached.get(id);
      next.set(id, known && same(known.key, key) ? known : { key, box: bareBox(id, node, definition, place, wired.inputs, expanded) });
    }
    cached = next;
    const all = [...cached.values()].map(({ box }) => box);
    if (same(all, boxes) && frames === layout.frames && notes === layout.notes) return heights;
    ({ frames, notes } = layout);
    boxes = all;
    heights = thumbnailHeights(all, Object.values(notes), Object.values(frames));
    return heights;
  };
}

function bareBox(
  id: string,
  node: GraphNode,
  definition: NodeDefinition | undefined,
  place: NodeLayout | undefined,
  wired: ReadonlySet<string>,
  expanded: boolean,
): BareBox {
  const { x = 0, y = 0, collapsed = false } = place ?? {};
  if (!definition) return { id, x, y, width: NODE_WIDTH, height: HEADER_HEIGHT, hasLayer: false };
  const { width, height } = nodeShape(definition, node, { wired, expanded, collapsed });
  return { id, x, y, width, height, hasLayer: !collapsed && layerPortOf(definition) !== null };
}
