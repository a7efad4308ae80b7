import { THUMBNAIL_HEIGHT } from './node-shape.ts';

interface Box {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** A node without its thumbnail, in canvas units. */
export interface BareBox extends Box {
  readonly id: string;
  readonly hasLayer: boolean;
}

/** Distance that a thumbnail keeps to what is below it. */
const GAP = 12;
/** A lower thumbnail would show nothing of use. */
const LEAST_HEIGHT = 48;

/**
 * Heights of thumbnails, by node: as high as the free space below the node permits, so that no node grows over another one, over a note or
 * out of its frame. Nodes without space have none.
 */
export function thumbnailHeights(nodes: readonly BareBox[], notes: readonly Box[], frames: readonly Box[]): ReadonlyMap<string, number> {
  const obstacles = [...nodes, ...notes].sort((a, b) => a.y - b.y);
  const heights = new Map<string, number>();
  for (const [index, box] of obstacles.entries()) {
    if (!isNode(box) || !box.hasLayer) continue;
    const bottom = box.y + box.height;
    let limit = bottom + THUMBNAIL_HEIGHT + GAP;
    for (let next = index + 1; next < obstacles.length; next++) {
      const other = obstacles[next];
      if (!other || other.y >= limit) break;
      // What covers the node already is not hidden by its thumbnail.
      if (other.y >= bottom && other.x < box.x + box.width && box.x < other.x + other.width) limit = other.y;
    }
    for (const frame of frames) if (isIn(box, frame)) limit = Math.min(limit, frame.y + frame.height);
    const height = limit - GAP - bottom;
    if (height >= LEAST_HEIGHT) heights.set(box.id, height);
  }
  return heights;
}

function isNode(box: Box | BareBox): box is BareBox {
  return 'hasLayer' in box;
}

function isIn(inner: Box, outer: Box): boolean {
  const { x, y, width, height } = inner;
  return x >= outer.x && y >= outer.y && x + width <= outer.x + outer.width && y + height <= outer.y + outer.height;
}
