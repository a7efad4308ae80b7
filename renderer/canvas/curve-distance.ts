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

/** Searches a part of the curve. It takes numbers instead of a list: a move of the pointer calls it thousands of times. */
function searchPart(search: Search, x0: number, y0: number, x1: number, y1: number, x2: number, y2: number, x3: number, y3: number): void {
  const left = Math.min(x0, x1, x2, x3);
  const right = Math.max(x0, x1, x2, x3);
  const top = Math.min(y0, y1, y2, y3);
  const bottom = Math.max(y0, y1, y2, y3);
  const { box, centerX, centerY } = search;
  const toBox = length(gap(left, right, box.x, box.x + box.width), gap(top, bottom, box.y, box.y + box.height));
  // Also false if a coordinate is no number.
  if (!(toBox <= search.toBox)) return;
  const toCenter = length(gap(left, right, centerX, centerX), gap(top, bottom, centerY, centerY));
  if (toBox === search.toBox && toCenter >= search.toCenter) return;
  if (Math.max(right - left, bottom - top) <= search.tolerance) {
    search.toBox = toBox;
    search.toCenter = toCenter;
    return;
  }
  // De Casteljau's algorithm at the middle.
  const ax = (x0 + x1) / 2;
  const ay = (y0 + y1) / 2;
  const bx = (x1 + x2) / 2;
  const by = (y1 + y2) / 2;
  const cx = (x2 + x3) / 2;
  const cy = (y2 + y3) / 2;
  const abx = (ax + bx) / 2;
  const aby = (ay + by) / 2;
  const bcx = (bx + cx) / 2;
  const bcy = (by + cy) / 2;
  const middleX = (abx + bcx) / 2;
  const middleY = (aby + bcy) / 2;
  searchPart(search, x0, y0, ax, ay, abx, aby, middleX, middleY);
  searchPart(search, middleX, middleY, bcx, bcy, cx, cy, x3, y3);
}

/** Distance between two intervals; 0 if they overlap. */
function gap(a0: number, a1: number, b0: number, b1: number): number {
  return Math.max(b0 - a1, a0 - b1, 0);
}

/** `Math.hypot` guards against overflow, which makes it several times slower. */
function length(x: number, y: number): number {
  return Math.sqrt(x * x + y * y);
}
