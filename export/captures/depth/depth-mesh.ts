import type { DepthMap } from './depth-map.ts';
import type { DepthRays } from './depth-rays.ts';
import { type Block, createTriangleTests, type TriangleTests } from './triangle-tests.ts';

/**
 * The mesh of a depth map, whose vertices are pixels. A quadtree divides the map until two or four triangles show each block of pixels with
 * a small relative error of depth (Lee et al. 2017; Dupont de Dinechin and Paljic 2020, §3.2). Every pixel of a block is compared, not only
 * middles of edges. A block whose neighbor is finer takes the neighbor's corners into its own edges, so there are no cracks.
 *
 * Rejected: a right-triangulated mesh needs sides of 2ⁿ + 1 pixels, and no cracks only by splitting far beyond the place of an error.
 */
export interface DepthMesh {
  /** Column and row of each vertex in half pixels from the top left corner of the map. The center of the first pixel is (1, 1). */
  readonly places: Uint16Array;
  /** The depth of each vertex. */
  readonly depths: Float32Array;
  /** Three vertices per triangle. */
  readonly indices: Uint32Array;
}

/** Relative error of depth that triangles may have. */
export const DEPTH_TOLERANCE = 0.005;
/** The tolerance grows by this factor until a mesh has few enough triangles. */
const COARSER = 2;

/**
 * Makes the mesh of a depth map.
 *
 * @param mostTriangles A map that needs more is shown with a larger error.
 */
export function makeDepthMesh(map: DepthMap, rays: DepthRays, mostTriangles: number, tolerance = DEPTH_TOLERANCE): DepthMesh {
  for (let allowed = tolerance; ; allowed *= COARSER) {
    const mesh = meshWithin(map, rays, allowed);
    if (mesh.indices.length / 3 <= mostTriangles || allowed > 1) return mesh;
  }
}

function meshWithin(map: DepthMap, rays: DepthRays, tolerance: number): DepthMesh {
  const tests = createTriangleTests(map, rays, tolerance);
  const { widthPx, heightPx } = map;
  const blocks: Block[] = [];
  const pending: Block[] = [{ left: 0, top: 0, right: rays.wraps ? widthPx : widthPx - 1, bottom: heightPx - 1 }];
  for (let block = pending.pop(); block; block = pending.pop()) {
    const { left, top, right, bottom } = block;
    const isPixel = right - left === 1 && bottom - top === 1;
    if (isPixel || (Math.min(right - left, bottom - top) > 1 && holds(block, widthPx, tests))) blocks.push(block);
    else pending.push(...divided(block));
  }
  const builder = createBuilder(map);
  const cells = blocks.filter(({ left, right }) => right - left === 1);
  for (const cell of cells) addCell(cell, widthPx, map, tests, builder);
  const large = blocks.filter(({ left, right }) => right - left > 1);
  for (const { left, top, right, bottom } of large) {
    for (const row of [top, bottom]) for (const column of [left, right]) builder.use(row * widthPx + (column % widthPx));
  }
  for (const block of large) addBlock(block, widthPx, builder, tests);
  if (rays.wraps) for (const row of [0, heightPx - 1]) closePole(row, map, tests, builder);
  return builder.build();
}

/** Halves both sides of a block, or the longer one of a block that is one pixel wide. */
function divided({ left, top, right, bottom }: Block): readonly Block[] {
  const column = right - left > 1 ? (left + right) >> 1 : right;
  const row = bottom - top > 1 ? (top + bottom) >> 1 : bottom;
  const parts: Block[] = [{ left, top, right: column, bottom: row }];
  if (column < right) parts.push({ left: column, top, right, bottom: row });
  if (row < bottom) parts.push({ left, top: row, right: column, bottom });
  if (column < right && row < bottom) parts.push({ left: column, top: row, right, bottom });
  return parts.filter((part) => part.right > part.left && part.bottom > part.top);
}

/** Whether four triangles around the middle of a block show all its pixels well, and none is stretched. */
function holds(block: Block, widthPx: number, tests: TriangleTests): boolean {
  const corners = cornersOf(block, widthPx);
  const middle = middleOf(block, widthPx);
  if (!tests.isKnown(middle) || !corners.every((corner) => tests.isKnown(corner.at))) return false;
  return corners.every((from, i) => {
    const to = corners[(i + 1) % 4] ?? from;
    return tests.fits(from.at, to.at, middle, block, sectorOf(block, from, to)) && !tests.isTorn(from.at, to.at, middle);
  });
}

interface Corner {
  readonly column: number;
  readonly row: number;
  /** Index of the pixel. */
  readonly at: number;
}

/** The corners of a block, clockwise from the top left one. */
function cornersOf({ left, top, right, bottom }: Block, widthPx: number): readonly Corner[] {
  const corner = (column: number, row: number): Corner => ({ column, row, at: row * widthPx + (column % widthPx) });
  return [corner(left, top), corner(right, top), corner(right, bottom), corner(left, bottom)];
}

function middleOf({ left, top, right, bottom }: Block, widthPx: number): number {
  return ((top + bottom) >> 1) * widthPx + (((left + right) >> 1) % widthPx);
}

/** The pixels between the lines from the middle of a block to two corners, clockwise. */
function sectorOf({ left, top, right, bottom }: Block, from: Corner, to: Corner) {
  const [x, y] = [(left + right) >> 1, (top + bottom) >> 1];
  const side = (corner: Corner, column: number, row: number): number => (corner.column - x) * (row - y) - (corner.row - y) * (column - x);
  return (column: number, row: number): boolean => side(from, column, row) >= 0 && side(to, column, row) <= 0;
}

/** Collects triangles; vertices are pixels, or poles behind them. */
interface Builder {
  /** Marks a pixel as a corner of triangles, before they are added. */
  use(corner: number): void;
  isUsed(corner: number): boolean;
  add(a: number, b: number, c: number): void;
  build(): DepthMesh;
}

function createBuilder({ widthPx, heightPx, values }: DepthMap): Builder {
  const pixels = widthPx * heightPx;
  const used = new Uint8Array(pixels);
  /** Number of each vertex, plus 1; the last two are the poles. */
  const numbers = new Int32Array(pixels + 2);
  const places: number[] = [];
  const depths: number[] = [];
  const indices: number[] = [];
  const vertex = (corner: number): number => {
    if (numbers[corner] === 0) {
      numbers[corner] = depths.length + 1;
      if (corner < pixels) places.push(2 * (corner % widthPx) + 1, 2 * Math.floor(corner / widthPx) + 1);
      else places.push(1, corner === pixels ? 0 : 2 * heightPx);
      depths.push(corner < pixels ? (values[corner] ?? 0) : meanOfRow(corner === pixels ? 0 : heightPx - 1));
    }
    return (numbers[corner] ?? 1) - 1;
  };
  const meanOfRow = (row: number): number => {
    const known = values.subarray(row * widthPx, (row + 1) * widthPx).filter((depth) => depth > 0 && Number.isFinite(depth));
    return known.length / known.reduce((sum, depth) => sum + 1 / depth, 0);
  };
  return {
    use: (corner) => {
      used[corner] = 1;
    },
    isUsed: (corner) => used[corner] === 1,
    add: (a, b, c) => {
      indices.push(vertex(a), vertex(b), vertex(c));
    },
    build: () => ({ places: Uint16Array.from(places), depths: Float32Array.from(depths), indices: Uint32Array.from(indices) }),
  };
}

/** Adds the triangles of a block of one pixel by the diagonal along which depth changes less; none that is stretched. */
function addCell(block: Block, widthPx: number, { values }: DepthMap, tests: TriangleTests, builder: Builder): void {
  const [a = 0, b = 0, c = 0, d = 0] = cornersOf(block, widthPx).map(({ at }) => at);
  const known = [a, b, c, d].filter(tests.isKnown);
  const change = (from: number, to: number): number => Math.abs((values[from] ?? 0) - (values[to] ?? 0));
  const triangles =
    known.length === 3
      ? [known]
      : known.length < 3
        ? []
        : change(a, c) <= change(b, d)
          ? [
              [a, b, c],
              [a, c, d],
            ]
          : [
              [a, b, d],
              [b, c, d],
            ];
  for (const [p = 0, q = 0, r = 0] of triangles) {
    if (tests.isTorn(p, q, r)) continue;
    for (const corner of [p, q, r]) builder.use(corner);
    builder.add(p, q, r);
  }
}

/** Adds a larger block: two triangles if they suffice, else a fan from its middle to the corners on its edges. */
function addBlock(block: Block, widthPx: number, builder: Builder, tests: TriangleTests): void {
  const { left, top, right, bottom } = block;
  const around: number[] = [];
  const visit = (column: number, row: number): void => {
    const corner = row * widthPx + (column % widthPx);
    if (builder.isUsed(corner)) around.push(corner);
  };
  for (let column = left; column < right; column++) visit(column, top);
  for (let row = top; row < bottom; row++) visit(right, row);
  for (let column = right; column > left; column--) visit(column, bottom);
  for (let row = bottom; row > top; row--) visit(left, row);
  const [a = 0, b = 0, c = 0, d = 0] = around;
  if (around.length === 4) {
    const [p, q, r, s] = cornersOf(block, widthPx) as [Corner, Corner, Corner, Corner];
    const half = (from: Corner, to: Corner, isAbove: boolean) => (column: number, row: number) =>
      ((to.column - from.column) * (row - from.row) - (to.row - from.row) * (column - from.column)) * (isAbove ? -1 : 1) >= 0;
    if (tests.fits(a, b, c, block, half(p, r, true)) && tests.fits(a, c, d, block, half(p, r, false))) {
      builder.add(a, b, c);
      builder.add(a, c, d);
      return;
    }
    if (tests.fits(a, b, d, block, half(q, s, false)) && tests.fits(b, c, d, block, half(q, s, true))) {
      builder.add(a, b, d);
      builder.add(b, c, d);
      return;
    }
  }
  const middle = middleOf(block, widthPx);
  around.forEach((corner, i) => {
    builder.add(corner, around[(i + 1) % around.length] ?? corner, middle);
  });
}

/** Closes the hole around a pole, between the first or last row and the direction straight up or down. */
function closePole(row: number, { widthPx, heightPx }: DepthMap, tests: TriangleTests, builder: Builder): void {
  const pole = widthPx * heightPx + (row === 0 ? 0 : 1);
  const ring: number[] = [];
  for (let column = 0; column < widthPx; column++) {
    const corner = row * widthPx + column;
    if (builder.isUsed(corner) && tests.isKnown(corner)) ring.push(corner);
  }
  if (ring.length < 3) return;
  ring.forEach((corner, i) => {
    builder.add(corner, ring[(i + 1) % ring.length] ?? corner, pole);
  });
}
