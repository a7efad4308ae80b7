/** A rectangle; one without width and height is a point. */
export interface Box {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** Cubic Bézier curve: x and y of its start, its two control points and its end. */
export type Curve = readonly [x0: number, y0: number, x1: number, y1: number, x2: number, y2: number, x3: number, y3: number];

export interface Distance {
  readonly toBox: number;
  readonly toCenter: number;
}

/** Whether something is nearer to a box. Of two that cross it, the one nearer to its center is. */
export function isNearer(a: Distance, b: Distance): boolean {
  return a.toBox < b.toBox || (a.toBox === b.toBox && a.toCenter < b.toCenter);
}

/**
 * Distance between a curve and a box, up to `tolerance`; `limit` if the curve is not nearer than that.
 *
 * Halves the curve and leaves out each part that cannot be nearer than what was found, because a curve lies within the bounds of its control
 * points. Far parts of long curves cost nothing.
 */
export function distanceToCurve(curve: Curve, box: Box, limit: Distance, tolerance: number): Distance {
  const search: Search = { box, centerX: box.x + box.width / 2, centerY: box.y + box.height / 2, tolerance, ...limit };
  searchPart(search, ...curve);
  return search.toBox === limit.toBox && search.toCenter === limit.toCenter ? limit : { toBox: search.toBox, toCenter: search.toCenter };
}

interface Search {
  readonly box: Box;
  readonly centerX: number;
  readonly centerY: number;
  readonly tolerance: number;
  toBox: number;
  toCenter: number;
}

function searchPart(search: Search, ...[x0, y0, x1, y1, x2, y2, x3, y3]: Curve): void {
  const [left, right] = [Math.min(x0, x1, x2, x3), Math.max(x0, x1, x2, x3)];
  const [top, bottom] = [Math.min(y0, y1, y2, y3), Math.max(y0, y1, y2, y3)];
  const { box, centerX, centerY } = search;
  const toBox = Math.hypot(gap(left, right, box.x, box.x + box.width), gap(top, bottom, box.y, box.y + box.height));
  const toCenter = Math.hypot(gap(left, right, centerX, centerX), gap(top, bottom, centerY, centerY));
  if (!isNearer({ toBox, toCenter }, search)) return;
  if (Math.max(right - left, bottom - top) <= search.tolerance) {
    search.toBox = toBox;
    search.toCenter = toCenter;
    return;
  }
  // De Casteljau's algorithm at the middle.
  const [ax, ay, bx, by, cx, cy] = [(x0 + x1) / 2, (y0 + y1) / 2, (x1 + x2) / 2, (y1 + y2) / 2, (x2 + x3) / 2, (y2 + y3) / 2];
  const [abx, aby, bcx, bcy] = [(ax + bx) / 2, (ay + by) / 2, (bx + cx) / 2, (by + cy) / 2];
  const [middleX, middleY] = [(abx + bcx) / 2, (aby + bcy) / 2];
  searchPart(search, x0, y0, ax, ay, abx, aby, middleX, middleY);
  searchPart(search, middleX, middleY, bcx, bcy, cx, cy, x3, y3);
}

/** Distance between two intervals; 0 if they overlap. */
function gap(a0: number, a1: number, b0: number, b1: number): number {
  return Math.max(b0 - a1, a0 - b1, 0);
}
